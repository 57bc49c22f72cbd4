"""A connection to a brick, the base class of all kinds of connections."""

import threading
from abc import ABC, abstractmethod
from collections.abc import Callable
from contextlib import suppress

from learnblock.errors import RobotConnectionError
from learnblock.i18n import Phrase
from learnblock.robots.ev3.brick import Drive, Look, State, Word
from learnblock.timing import MONOTONIC, Deadline, SteadyClock

#: Seconds between two messages of an idle program: the brick stops its motors after 0.3.
PULSE = 0.1
#: Seconds for which a state is also used for other sensors, since it contains all readings.
FRESH = 0.01


class BrickLink(ABC):
    """Exchanges one command and its answer at a time, from any thread; a failure ends it.

    The last drive command is repeated ten times per second: the brick stops its motors if it
    receives nothing, and restarts them when a slow connection recovers.

    A subclass implements `exchange`. An OSError (broken or too slow) or a ValueError (invalid data)
    breaks the link and becomes a RobotConnectionError; a RobotConnectionError from the subclass
    itself does not break it.

    Args:
        place: the brick's address, for errors.
        on_state: called with each new state.
        clock: the clock of its periods and limits.
    """

    def __init__(
        self, place: str, on_state: Callable[[State], None], clock: SteadyClock = MONOTONIC
    ) -> None:
        self.place = place
        self._clock = clock
        self._on_state = on_state
        self._lock = threading.Lock()
        self._closed = threading.Event()
        self._broken: Phrase | None = None
        self._wish = Drive(0, 0)
        self._driven = self._heard = clock.now()
        #: When the idle program has to send something again.
        self._pulse = Deadline.after(PULSE, clock)
        self._state: State | None = None
        #: Seconds that the last exchange took; None before the first one.
        self.round_trip: float | None = None
        self._thread = threading.Thread(target=self._keep_alive, name="ev3", daemon=True)

    #: Whether the brick can speak.
    speaks = False
    #: Whether it can show text on its screen.
    shows = False

    @abstractmethod
    def exchange(self, word: Word) -> State:
        """Send a command and receive the answer.

        Raises:
            OSError: the connection failed, or nothing arrived in time.
            ValueError: the answer is invalid.
            RobotConnectionError: the brick reports an error.
        """

    @abstractmethod
    def hang_up(self) -> None:
        """Close the connection and interrupt a waiting exchange; calling it twice is harmless."""

    def farewell(self) -> None:  # noqa: B027 - most connections only need to be closed
        """Send a last message on an intact connection; its errors are ignored."""

    def begin(self) -> State:
        """Request the first state, then keep the connection alive."""
        state = self.say(Look())
        self._thread.start()
        return state

    def say(self, word: Word) -> State:
        """Send a command.

        Raises:
            RobotConnectionError: the brick cannot be reached, or reports an error.
        """
        with self._lock:
            self.check()
            if self._closed.is_set():
                raise RobotConnectionError("ev3-closed", place=self.place)
            start = self._clock.now()
            try:
                state = self.exchange(self._due(word))
            except RobotConnectionError:
                raise
            except (OSError, ValueError) as error:
                self._break(error)
                self.check()
                raise
            finally:
                self._pulse = Deadline.after(PULSE, self._clock)
            self._state, self._heard = state, self._clock.now()
            self.round_trip = self._heard - start
            self._on_state(state)
            return state

    @property
    def known(self) -> State | None:
        """The brick's last state, however old."""
        return self._state

    def latest(self) -> State:
        """The brick's state, at most 0.01 seconds old.

        Raises:
            RobotConnectionError: the brick cannot be reached, or reports an error.
        """
        state = self._state
        if state is not None and self._clock.now() - self._heard < FRESH and not self._broken:
            return state
        return self.say(Look())

    def check(self) -> None:
        """Check that the connection is intact.

        Raises:
            RobotConnectionError: it is broken.
        """
        if self._broken:
            raise RobotConnectionError(self._broken.code, **self._broken.values)

    def close(self) -> None:
        """Close the connection and end its thread."""
        if not self._closed.is_set():
            self._closed.set()
            self._take_leave()
        self.hang_up()
        if self._thread.is_alive() and self._thread is not threading.current_thread():
            self._thread.join()

    def _due(self, word: Word) -> Word:
        """The command, or the last drive command if it is time to repeat it."""
        if isinstance(word, Drive):
            self._wish = word
        elif isinstance(word, Look) and any(self._wish) and self._is_late():
            word = self._wish
        if isinstance(word, Drive):
            self._driven = self._clock.now()
        return word

    def _is_late(self) -> bool:
        return self._clock.now() - self._driven > 0.9 * PULSE

    def _take_leave(self) -> None:
        # Not while another thread waits for an answer that may never arrive.
        if self._lock.acquire(timeout=PULSE):
            try:
                with suppress(OSError, ValueError, EOFError):
                    if not self._broken:
                        self.farewell()
            finally:
                self._lock.release()

    def _break(self, error: Exception) -> None:
        self._broken = self._phrase(error)
        self.hang_up()

    def _phrase(self, error: Exception) -> Phrase:
        if isinstance(error, TimeoutError):
            return Phrase("ev3-silent", place=self.place)
        if isinstance(error, OSError):
            return Phrase("ev3-link-broke", place=self.place)
        return Phrase("ev3-garbled", place=self.place)

    def _keep_alive(self) -> None:
        while not self._clock.wait(self._closed, self._pulse.left) and not self._broken:
            if self._pulse.is_over:
                self._look()

    def _look(self) -> None:
        try:
            self.say(Look())
        except RobotConnectionError:
            # The next use of the robot raises it again.
            return
