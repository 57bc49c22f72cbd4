"""The base class of all connections to a Thymio."""

import threading
from collections.abc import Callable

from learnblock.errors import RobotConnectionError
from learnblock.i18n import Phrase
from learnblock.robots.thymio.program import Event
from learnblock.robots.thymio.wires import Wire
from learnblock.timing import MONOTONIC, SteadyClock

#: Seconds of silence after which the robot counts as lost; it is polled 50 times per second.
SILENCE = 2.5


class GarbledError(Exception):
    """The received data is not a message."""


class ThymioLink:
    """A connection to one Thymio: it reads the robot's variables and sends it events.

    Args:
        wire: carries the data; the link closes it.
        timeout: limit of each step of connecting, in seconds.
        clock: the clock of its limits.

    Attributes:
        place: the robot's address or port, for errors.
    """

    def __init__(self, wire: Wire, timeout: float, clock: SteadyClock = MONOTONIC) -> None:
        self.place = wire.name
        self._wire = wire
        self._timeout = timeout
        self._clock = clock
        self._changed = threading.Condition()
        self._lost: Phrase | None = None
        self._heard = clock.now()
        self._closed = threading.Event()
        self._reader = threading.Thread(target=self._listen, name="thymio reader", daemon=True)

    # Subclasses override these.

    def read(self, variable: str) -> tuple[int, ...]:
        """The latest values of one of the robot's variables, signed.

        Raises:
            RobotConnectionError: the connection is lost.
        """
        raise NotImplementedError

    def tell(self, event: Event, *numbers: int) -> None:
        """Send an event to the robot's program.

        Raises:
            RobotConnectionError: the connection is lost.
        """
        raise NotImplementedError

    def _take(self, data: bytes) -> None:
        """Process received data; the reader calls it with the lock held.

        Raises:
            GarbledError: the data is invalid.
        """
        raise NotImplementedError

    # Shared by all links.

    def check(self) -> None:
        """Check that the robot still answers.

        Raises:
            RobotConnectionError: the connection is lost.
        """
        silent = self._clock.now() - self._heard
        if self._lost is None and silent > SILENCE:
            self._lose(Phrase("thymio-silent", place=self.place, seconds=round(silent, 1)))
        if self._lost is not None:
            raise RobotConnectionError(self._lost.code, **self._lost.values)

    def close(self) -> None:
        """Close the connection; calling it twice is harmless."""
        self._closed.set()
        if self._reader.is_alive() and self._reader is not threading.current_thread():
            self._reader.join()
        self._wire.close()

    def wait(self, condition: Callable[[], bool], seconds: float) -> bool:
        """Wait until received data makes the condition true, and return whether it did."""
        with self._changed:
            return self._clock.wait_for(
                self._changed, lambda: self._lost is not None or condition(), seconds
            ) and (self._lost is None)

    def _expect(self, condition: Callable[[], bool], otherwise: str) -> None:
        """Wait for a step of connecting.

        Args:
            condition: returns whether the step is done.
            otherwise: the code of the error; its words show the place.

        Raises:
            RobotConnectionError: the step is not done in time.
        """
        if not self.wait(condition, self._timeout):
            phrase = self._lost or Phrase(otherwise, place=self.place)
            raise RobotConnectionError(phrase.code, **phrase.values)

    def _send(self, data: bytes) -> None:
        if self._lost is None:
            try:
                self._wire.send(data)
            except OSError as error:
                self._lose_wire(error)
        if self._lost is not None:
            self.check()

    def _listen(self) -> None:
        while not self._closed.is_set() and self._lost is None:
            try:
                data = self._wire.receive()
                with self._changed:
                    self._take(data)
                    self._changed.notify_all()
            except GarbledError:
                self._lose(Phrase("thymio-garbled", place=self.place))
            except OSError as error:
                self._lose_wire(error)

    def _lose_wire(self, error: OSError) -> None:
        reason = error.strerror or str(error)
        self._lose(Phrase("thymio-link-broke", place=self.place, reason=reason))

    def _lose(self, reason: Phrase) -> None:
        with self._changed:
            self._lost = self._lost or reason
            self._changed.notify_all()
