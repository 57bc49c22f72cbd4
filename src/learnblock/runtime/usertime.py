"""Makes a program's `time.sleep` and `time.time` use the robot's time."""

import time
from collections.abc import Callable
from functools import partial
from typing import Any

from learnblock.client.clock import Clock
from learnblock.runtime.own_functions import OwnFunctions

_NANOSECONDS = 1_000_000_000


def use_robot_time(clock: Clock) -> Callable[[], None]:
    """Make `time` follow `clock` for the calling program; return the function that undoes it.

    Other threads, and modules that imported the functions directly, keep the wall clock. The
    returned function may be called from any thread, and twice.
    """
    return _TIME.use({name: partial(function, clock) for name, function in _ROBOT_TIME.items()})


def _now(clock: Clock) -> float:
    clock.charge()
    return clock.time()


def _now_in_nanoseconds(clock: Clock) -> int:
    return round(_now(clock) * _NANOSECONDS)


def _sleep(clock: Clock, seconds: float) -> None:
    if seconds < 0:
        raise ValueError("sleep length must be non-negative")
    clock.sleep(seconds)


_ROBOT_TIME: dict[str, Callable[..., Any]] = {
    "sleep": _sleep,
    "time": _now,
    "monotonic": _now,
    "perf_counter": _now,
    "time_ns": _now_in_nanoseconds,
    "monotonic_ns": _now_in_nanoseconds,
    "perf_counter_ns": _now_in_nanoseconds,
}
_TIME = OwnFunctions(time, _ROBOT_TIME)
