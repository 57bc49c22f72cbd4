"""A steady pace: how often a pupil or an address may do something."""

import time
from collections import OrderedDict
from collections.abc import Callable

from learnblock.classroom.limits import PACE, PACES
from learnblock.server.messages.base import Pace

#: The most keys whose buckets are remembered; the oldest are forgotten.
_MOST_KEYS = 1000


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

    def take(self, count: int = 1) -> float:
        """Take some; return for how many seconds to wait before they may be used, often 0."""
        now = self._now()
        rate = self._pace.minute / 60
        self._left = min(self._left + (now - self._since) * rate, self._pace.burst) - count
        self._since = now
        return max(0.0, -self._left / rate)

    def try_take(self) -> float:
        """Take one if there is one; return for how many seconds to wait for it, 0 if taken."""
        wait = self.take()
        if wait:
            self._left += 1
        return wait


class Buckets:
    """A bucket for each key, such as an address.

    Args:
        pace: of each.
        now: returns the time of a monotonic clock in seconds.
    """

    def __init__(self, pace: Pace, now: Callable[[], float] = time.monotonic) -> None:
        self._pace = pace
        self._now = now
        self._buckets: OrderedDict[str, Bucket] = OrderedDict()

    def try_take(self, key: str) -> float:
        """Take one if there is one; return for how many seconds to wait for it, 0 if taken."""
        bucket = self._buckets.pop(key, None) or Bucket(self._pace, self._now)
        self._buckets[key] = bucket
        if len(self._buckets) > _MOST_KEYS:
            self._buckets.popitem(last=False)
        return bucket.try_take()


class Paces:
    """The paces of one person: of all messages, and of those that cost the computer more."""

    def __init__(self) -> None:
        self._all = Bucket(PACE)
        self._kinds = {kind: Bucket(pace) for kind, pace in PACES.items()}

    def take(self, count: int) -> float:
        """Take some of all messages; return for how many seconds to wait."""
        return self._all.take(count)

    def wait_for(self, kind: str) -> float:
        """Take one of a kind if there is one; return for how many seconds to wait for it."""
        bucket = self._kinds.get(kind)
        return bucket.try_take() if bucket else 0.0
