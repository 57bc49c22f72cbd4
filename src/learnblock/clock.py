"""Time belongs to the robot: the one seam through which a program sleeps and asks the time."""

import time
from typing import Protocol


class Clock(Protocol):
    """A robot's time.

    A wall clock flows by itself; the clock of a simulated robot moves only while its program waits.
    """

    @property
    def instant(self) -> int | None:
        """A number that changes when the robot's time does, or None where time flows by itself.

        Two readings of a sensor at one instant are the same reading.
        """

    def time(self) -> float:
        """Seconds since the robot was connected."""

    def sleep(self, seconds: float) -> None:
        """Wait for that long in the robot's time; not at all when it is not positive."""

    def charge(self) -> None:
        """Note that the program reached for a device, which on no robot is free."""


class WallClock:
    """The time of a real robot."""

    instant = None

    def __init__(self) -> None:
        self._started = time.monotonic()

    def time(self) -> float:
        return time.monotonic() - self._started

    def sleep(self, seconds: float) -> None:
        if seconds > 0:
            time.sleep(seconds)

    def charge(self) -> None:
        """Nothing to do: a real access takes its own time."""
