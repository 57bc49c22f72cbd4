"""Limits on wrong attempts: after some of them the next one has to wait."""

import time
from collections import OrderedDict
from collections.abc import Callable
from dataclasses import dataclass

from learnblock.errors import LearnBlockError

#: The most keys that are remembered; the oldest are forgotten.
_MOST_KEYS = 1000


class TooManyAttemptsError(LearnBlockError):
    """There were too many wrong attempts; the next one has to wait."""


@dataclass(frozen=True, slots=True)
class _Mistakes:
    count: int
    until: float


class Attempts:
    """Counts mistakes by key, such as a name; after some of them the next try has to wait.

    Args:
        free: the number of mistakes without a wait.
        pause: seconds to wait after one more; twice as long after each further mistake.
        longest: the longest time to wait, and that after which mistakes are forgotten.
        now: returns the time of a monotonic clock in seconds.
    """

    def __init__(
        self,
        free: int,
        pause: float,
        longest: float = 300.0,
        now: Callable[[], float] = time.monotonic,
    ) -> None:
        self._free, self._pause, self._longest = free, pause, longest
        self._now = now
        self._mistakes: OrderedDict[str, _Mistakes] = OrderedDict()

    def require(self, key: str) -> None:
        """Check that a try is allowed now.

        Raises:
            TooManyAttemptsError: it is not yet; it names the seconds to wait.
        """
        mistakes = self._mistakes.get(key)
        if mistakes is None:
            return
        left = mistakes.until - self._now()
        if left > 0:
            raise TooManyAttemptsError("class-wait", seconds=int(left) + 1)
        if left < -self._longest:
            del self._mistakes[key]

    def failed(self, key: str) -> None:
        """Count a mistake."""
        before = self._mistakes.pop(key, None)
        count = before.count + 1 if before else 1
        over = count - self._free
        wait = min(self._pause * 2.0 ** min(over - 1, 20), self._longest) if over > 0 else 0.0
        self._mistakes[key] = _Mistakes(count, self._now() + wait)
        if len(self._mistakes) > _MOST_KEYS:
            self._mistakes.popitem(last=False)

    def succeeded(self, key: str) -> None:
        """Forget the mistakes of a key."""
        self._mistakes.pop(key, None)
