"""A program's own `time.sleep` and `time.time` count in the robot's time."""

import threading
import time
from collections.abc import Callable
from functools import partial
from typing import Any

from learnblock.clock import Clock

_NANOSECONDS = 1_000_000_000


def use_robot_time(clock: Clock) -> Callable[[], None]:
    """Have the `time` module follow `clock` in the calling thread; answer the way back.

    Other threads, and modules that hold the functions themselves, keep the wall clock.
    """
    thread = threading.get_ident()
    real = {name: getattr(time, name) for name in _ROBOT_TIME}

    def either(name: str, *args: Any) -> Any:
        if threading.get_ident() == thread:
            return _ROBOT_TIME[name](clock, *args)
        return real[name](*args)

    for name in _ROBOT_TIME:
        setattr(time, name, partial(either, name))
    return lambda: _restore(real)


def _restore(real: dict[str, Any]) -> None:
    for name, function in real.items():
        setattr(time, name, function)


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
