"""A robot's time: programs sleep and read the time only through its clock."""

import time
from typing import Protocol


# Why: docs/decisions.md, "Time belongs to the robot"
class Clock(Protocol):
    """A robot's time.

    A wall clock runs by itself; a simulated robot's clock moves only while its program waits.
    """

    @property
    def instant(self) -> int | None:
        """A number that changes whenever the robot's time changes; None for a wall clock.

        Two readings of a sensor at one instant are the same reading.
        """

    def time(self) -> float:
        """Seconds since the robot was connected."""

    def sleep(self, seconds: float) -> None:
        """Wait for a number of seconds in the robot's time; zero or less returns at once."""

    def charge(self) -> None:
        """Add the time that using a device takes on every robot."""


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
        """Do nothing: using a real device takes time anyway."""
