"""A conversation with a brick, whichever way it is reached."""

import threading
from abc import ABC, abstractmethod
from collections.abc import Callable
from contextlib import suppress
from time import monotonic

from learnblock.errors import RobotConnectionError
from learnblock.robots.ev3.brick import Drive, Look, State, Word

#: Seconds between two words of a program that says nothing: the brick stops its motors after 0.3.
PULSE = 0.1
#: Seconds for which a state is good enough for another sensor: all come in one answer.
FRESH = 0.01


class Link(ABC):
    """One word and its answer at a time, from any thread; a failure is the end of it.

    What the wheels are to do is said again ten times a second: a brick stops them when it hears
    nothing, and turns them again when a wire that was slow for a moment is well.

    A subclass says how a word travels. What it raises as OSError (a wire that failed or was too
    slow) or ValueError (nonsense) becomes a sentence; a RobotConnectionError is one already, and
    does not end the conversation.

    Args:
        where: the brick's place, for sentences.
        told: is given each new state.
    """

    def __init__(self, where: str, told: Callable[[State], None]) -> None:
        self.where = where
        self._told = told
        self._lock = threading.Lock()
        self._closed = threading.Event()
        self._broken = ""
        self._wish = Drive(0, 0)
        self._driven = 0.0
        self._state: State | None = None
        self._heard = 0.0
        self._thread = threading.Thread(target=self._keep_alive, name="ev3", daemon=True)

    #: Whether the brick can speak.
    speaks = False

    @abstractmethod
    def exchange(self, word: Word) -> State:
        """Say a word and hear the answer.

        Raises:
            OSError: the wire failed, or nothing came in time.
            ValueError: what came was nonsense.
            RobotConnectionError: the brick complains.
        """

    @abstractmethod
    def hang_up(self) -> None:
        """Let go of the wire; an exchange that waits on it ends. It may be called twice."""

    def farewell(self) -> None:  # noqa: B027 - on most wires closing them says it
        """Say the last word on a wire that is well; what it raises is nobody's trouble any more."""

    def begin(self) -> State:
        """Ask for the first state, and keep the conversation alive from then on."""
        state = self.say(Look())
        self._thread.start()
        return state

    def say(self, word: Word) -> State:
        """Say a word.

        Raises:
            RobotConnectionError: the brick is gone, or complains.
        """
        with self._lock:
            self.check()
            if self._closed.is_set():
                raise RobotConnectionError(f"the EV3 at {self.where} has been let go")
            try:
                state = self.exchange(self._due(word))
            except RobotConnectionError:
                raise
            except (OSError, ValueError) as error:
                self._break(error)
                self.check()
                raise
            self._state, self._heard = state, monotonic()
            self._told(state)
            return state

    def latest(self) -> State:
        """The brick's state, no older than a hundredth of a second.

        Raises:
            RobotConnectionError: the brick is gone, or complains.
        """
        state = self._state
        if state is not None and monotonic() - self._heard < FRESH and not self._broken:
            return state
        return self.say(Look())

    def check(self) -> None:
        """Say so if the brick is gone.

        Raises:
            RobotConnectionError: it is.
        """
        if self._broken:
            raise RobotConnectionError(self._broken)

    def close(self) -> None:
        """End the conversation; nothing of it is left."""
        if not self._closed.is_set():
            self._closed.set()
            self._take_leave()
        self.hang_up()
        if self._thread.is_alive() and self._thread is not threading.current_thread():
            self._thread.join()

    def _due(self, word: Word) -> Word:
        """The word, or what the wheels are to do, if it is time to say that again."""
        if isinstance(word, Drive):
            self._wish = word
        elif isinstance(word, Look) and any(self._wish) and self._is_late():
            word = self._wish
        if isinstance(word, Drive):
            self._driven = monotonic()
        return word

    def _is_late(self) -> bool:
        return monotonic() - self._driven > 0.9 * PULSE

    def _take_leave(self) -> None:
        # Not while somebody waits for an answer that may never come.
        if self._lock.acquire(timeout=PULSE):
            try:
                with suppress(OSError, ValueError, EOFError):
                    if not self._broken:
                        self.farewell()
            finally:
                self._lock.release()

    def _break(self, error: Exception) -> None:
        self._broken = f"{self._what_happened(error)}: is it switched on, and near enough?"
        self.hang_up()

    def _what_happened(self, error: Exception) -> str:
        if isinstance(error, TimeoutError):
            return f"the EV3 at {self.where} does not answer any more"
        if isinstance(error, OSError):
            return f"the link to the EV3 at {self.where} broke"
        return f"what comes from {self.where} is not what an EV3 says"

    def _keep_alive(self) -> None:
        while not self._closed.wait(PULSE) and not self._broken:
            if monotonic() - self._heard > 0.9 * PULSE:
                self._look()

    def _look(self) -> None:
        try:
            self.say(Look())
        except RobotConnectionError:
            # Whoever asks next is told.
            return
