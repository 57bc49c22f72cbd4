"""Time as the threads of a driver know it: how much has passed, and waiting for some to pass.

A program's time is another matter: it is that of its robot (`learnblock.client.clock`).
"""

import threading
import time
from collections.abc import Callable
from dataclasses import dataclass
from typing import Protocol, Self


class SteadyClock(Protocol):
    """A clock that is never set, so that differences of its times are durations."""

    def now(self) -> float:
        """Seconds since some moment in the past."""

    def sleep(self, seconds: float) -> None:
        """Let this thread wait; zero or less returns at once."""

    def wait(self, event: threading.Event, seconds: float) -> bool:
        """Wait until the event is set, or seconds have passed; return whether it is set."""

    def wait_for(
        self, condition: threading.Condition, predicate: Callable[[], bool], seconds: float
    ) -> bool:
        """Wait until the predicate holds, or seconds have passed; return whether it holds.

        Args:
            condition: held by this thread, and notified by others after a change.
            predicate: called with the condition held.
            seconds: the time limit.
        """


class MonotonicClock:
    """The computer's clock."""

    def now(self) -> float:
        return time.monotonic()

    def sleep(self, seconds: float) -> None:
        if seconds > 0:
            time.sleep(seconds)

    def wait(self, event: threading.Event, seconds: float) -> bool:
        return event.wait(seconds)

    def wait_for(
        self, condition: threading.Condition, predicate: Callable[[], bool], seconds: float
    ) -> bool:
        return condition.wait_for(predicate, seconds)


#: What is less is no time that is left: sums of seconds are inexact.
NANOSECOND = 1e-9

#: The clock of every driver that is given no other one.
MONOTONIC = MonotonicClock()


@dataclass(frozen=True, slots=True)
class Deadline:
    """A moment by which something must have happened.

    Args:
        clock: the clock that tells.
        at: the moment, by this clock.
    """

    clock: SteadyClock
    at: float

    @classmethod
    def after(cls, seconds: float, clock: SteadyClock) -> Self:
        """The moment after so many seconds."""
        return cls(clock, clock.now() + seconds)

    @property
    def left(self) -> float:
        """Seconds until then; 0 afterwards."""
        remaining = self.at - self.clock.now()
        return remaining if remaining > NANOSECOND else 0.0

    @property
    def is_over(self) -> bool:
        """Whether the moment has come."""
        return self.left == 0
