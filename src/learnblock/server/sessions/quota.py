"""Limits on how often a page, or a person, may do something that costs the computer much."""

import time
from collections import deque
from collections.abc import Callable

from learnblock.errors import LearnBlockError

#: The projects that a page may make, and the seconds in which it may; those of one person share it.
MOST_PROJECTS, _PERIOD = 20, 60.0


class Quota:
    """A number of projects within a time.

    Args:
        most: the number.
        seconds: the time.
        now: returns the time of a monotonic clock in seconds.
    """

    def __init__(
        self, most: int, seconds: float, now: Callable[[], float] = time.monotonic
    ) -> None:
        self._seconds = seconds
        self._now = now
        self._taken: deque[float] = deque(maxlen=most)

    def take(self) -> None:
        """Take one.

        Raises:
            LearnBlockError: all are taken; it names the number and how long to wait.
        """
        now = self._now()
        if len(self._taken) == self._taken.maxlen:
            left = self._taken[0] + self._seconds - now
            if left > 0:
                raise LearnBlockError(
                    "server-too-many-projects", count=len(self._taken), seconds=int(left) + 1
                )
        self._taken.append(now)


def new_projects() -> Quota:
    """How many projects a page may make."""
    return Quota(MOST_PROJECTS, _PERIOD)
