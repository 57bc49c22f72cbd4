"""The clock of a simulated robot, which moves only while its program waits."""

import math
from collections.abc import Callable
from functools import partial

#: This many device accesses take one step, because reading takes time on every robot.
#: Otherwise a loop that polls and never sleeps would stop the world's time forever.
ACCESSES_PER_STEP = 10


# Why: docs/decisions.md, "Simulation is lock-step"
class LockStepClock:
    """The time of a world that advances only when every program in it waits.

    Args:
        wait: `wait(steps)` parks the program for that many steps, at least one, and returns the
            world's step counter when it wakes.
        steps: returns the current counter.
        dt: seconds per step.
    """

    def __init__(self, wait: Callable[[int], int], steps: int, dt: float) -> None:
        self._wait = wait
        self._dt = dt
        self._started = steps
        self._accesses = 0
        self.instant = steps
        #: The last time that was asked for, and its step: most steps are asked for several times.
        self._time, self._at = 0.0, steps

    def time(self) -> float:
        instant = self.instant
        if instant != self._at:
            # So that step 3 is 0.03 and not 0.030000000000000002: programs print their times.
            self._time = round((instant - self._started) * self._dt, 9)
            self._at = instant
        return self._time

    def sleep(self, seconds: float) -> None:
        if seconds > 0:
            # A wait ends with the step that contains its end.
            self._advance(max(1, math.ceil(seconds / self._dt - 1e-6)))

    def charge(self) -> None:
        self._accesses += 1
        if self._accesses >= ACCESSES_PER_STEP:
            self._advance(1)

    def note_waits(self, noted: Callable[[Callable[[int], int], int], int]) -> None:
        """Let `noted(wait, steps)` wait from now on, as `wait(steps)` did."""
        self._wait = partial(noted, self._wait)

    def _advance(self, steps: int) -> None:
        self._accesses = 0
        self.instant = self._wait(steps)
