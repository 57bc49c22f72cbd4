"""Makes a program's `time.sleep` and `time.time` use the robot's time."""

import threading
import time
from collections.abc import Callable
from functools import partial
from typing import Any

from learnblock.client.clock import Clock

_NANOSECONDS = 1_000_000_000


def use_robot_time(clock: Clock) -> Callable[[], None]:
    """Make `time` follow `clock` in the calling thread; return the function that undoes it.

    Other threads, and modules that imported the functions directly, keep the wall clock. The
    returned function may be called from any thread, and twice.
    """
    thread = threading.get_ident()
    with _lock:
        _clocks.setdefault(thread, []).append(clock)
        for name in _ROBOT_TIME:
            setattr(time, name, _EITHER_TIME[name])
    return lambda: _restore(thread, clock)


def _restore(thread: int, clock: Clock) -> None:
    with _lock:
        clocks = _clocks.get(thread, [])
        if clock in clocks:
            clocks.remove(clock)
        if not clocks:
            _clocks.pop(thread, None)
        if not _clocks:
            for name, function in _WALL_TIME.items():
                setattr(time, name, function)


def _either(name: str, *args: Any) -> Any:
    clocks = _clocks.get(threading.get_ident())
    if clocks:
        return _ROBOT_TIME[name](clocks[-1], *args)
    return _WALL_TIME[name](*args)


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
_WALL_TIME: dict[str, Callable[..., Any]] = {name: getattr(time, name) for name in _ROBOT_TIME}
_EITHER_TIME: dict[str, Callable[..., Any]] = {name: partial(_either, name) for name in _ROBOT_TIME}
# The `time` module is the interpreter's only one, so the replacements are shared too:
# the clocks of each thread, the newest last.
_clocks: dict[int, list[Clock]] = {}
_lock = threading.Lock()
