"""What all ways of talking to a Thymio share: a reader, waiting with a limit, and being lost."""

import threading
from collections.abc import Callable
from time import monotonic

from learnblock.errors import RobotConnectionError
from learnblock.robots.thymio.program import Event
from learnblock.robots.thymio.wires import Wire

#: Seconds of silence after which the robot counts as gone; it is asked 50 times a second.
SILENCE = 2.5


class GarbledError(Exception):
    """What came over the wire is no message."""


class Link:
    """A conversation with one Thymio, whose variables are read and which is told events.

    Args:
        wire: the way to it, which the link closes.
        patience: seconds within which each step of getting acquainted must succeed.

    Attributes:
        name: as messages call the robot.
    """

    def __init__(self, wire: Wire, patience: float) -> None:
        self.name = f"the Thymio at {wire.name}"
        self._wire = wire
        self._patience = patience
        self._changed = threading.Condition()
        self._lost: str | None = None
        self._heard = monotonic()
        self._closed = threading.Event()
        self._reader = threading.Thread(target=self._listen, name="thymio reader", daemon=True)

    # What a kind of link writes.

    def read(self, variable: str) -> tuple[int, ...]:
        """The numbers of one of the robot's variables, signed, as they were last heard.

        Raises:
            RobotConnectionError: the robot is gone.
        """
        raise NotImplementedError

    def tell(self, event: Event, *numbers: int) -> None:
        """Send the robot's program an event.

        Raises:
            RobotConnectionError: the robot is gone.
        """
        raise NotImplementedError

    def _take(self, data: bytes) -> None:
        """Understand what has come; called by the reader, with the lock held.

        Raises:
            GarbledError: it makes no sense.
        """
        raise NotImplementedError

    # What they share.

    def check(self) -> None:
        """Say so if the robot can no longer be reached.

        Raises:
            RobotConnectionError: it cannot.
        """
        silent = monotonic() - self._heard
        if self._lost is None and silent > SILENCE:
            self._lose(f"it has said nothing for {silent:.1f} s")
        if self._lost is not None:
            raise RobotConnectionError(
                f"the connection to {self.name} is gone: {self._lost};"
                " is it switched on and in reach, and does no other program use it?"
            )

    def close(self) -> None:
        """Let go of the robot; the second time it does nothing."""
        self._closed.set()
        if self._reader.is_alive() and self._reader is not threading.current_thread():
            self._reader.join()
        self._wire.close()

    def wait(self, condition: Callable[[], bool], seconds: float) -> bool:
        """Wait until something that is heard makes the condition true; whether it has."""
        with self._changed:
            return self._changed.wait_for(
                lambda: self._lost is not None or condition(), timeout=seconds
            ) and (self._lost is None)

    def _expect(self, condition: Callable[[], bool], otherwise: str) -> None:
        """Wait for a step of getting acquainted.

        Raises:
            RobotConnectionError: it is not made in time.
        """
        if not self.wait(condition, self._patience):
            reason = self._lost or f"{otherwise} within {self._patience:g} s"
            raise RobotConnectionError(
                f"{self.name} cannot be used: {reason};"
                " is it switched on, and does no other program use it?"
            )

    def _send(self, data: bytes) -> None:
        if self._lost is None:
            try:
                self._wire.send(data)
            except OSError as error:
                self._lose(_reason(error))
        if self._lost is not None:
            self.check()

    def _listen(self) -> None:
        while not self._closed.is_set() and self._lost is None:
            try:
                data = self._wire.receive()
                with self._changed:
                    self._take(data)
                    self._changed.notify_all()
            except GarbledError as error:
                self._lose(f"what it sends makes no sense ({error})")
            except OSError as error:
                self._lose(_reason(error))

    def _lose(self, reason: str) -> None:
        with self._changed:
            self._lost = self._lost or reason
            self._changed.notify_all()


def _reason(error: OSError) -> str:
    """What the system says, without its number."""
    return (error.strerror or str(error)).lower()
