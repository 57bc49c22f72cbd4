"""A steady pace: how often a page may do something."""

import time
from collections.abc import Callable

from learnblock.classroom.rights import Pace


class Bucket:
    """A token bucket: full at first, refilled all the time.

    Args:
        pace: how fast it is refilled, and how much is in it at most.
        now: returns the time of a monotonic clock in seconds.
    """

    def __init__(self, pace: Pace, now: Callable[[], float] = time.monotonic) -> None:
        self._pace = pace
        self._now = now
        self._left = float(pace.burst)
        self._since = now()

    def take(self) -> float:
        """Take one; return for how many seconds to wait before it may be used, often 0."""
        now = self._now()
        rate = self._pace.minute / 60
        self._left = min(self._left + (now - self._since) * rate, self._pace.burst) - 1
        self._since = now
        return max(0.0, -self._left / rate)

    def try_take(self) -> bool:
        """Take one if there is one; return whether there was."""
        if self.take() == 0.0:
            return True
        self._left += 1
        return False
