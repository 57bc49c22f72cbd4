"""Stops a robot when its program ends, even after an error, Ctrl-C or SIGTERM."""

import atexit
import signal
import threading
from collections.abc import Callable
from types import FrameType
from typing import NoReturn

Stop = Callable[[], None]


def call_at_end(stop: Stop) -> None:
    """Call `stop` when the program ends.

    An atexit function runs after errors and Ctrl-C too, but not after SIGTERM.
    """
    atexit.register(stop)
    if _may_handle_sigterm():
        signal.signal(signal.SIGTERM, _exit_on_sigterm)


def forget(stop: Stop) -> None:
    """Undo `call_at_end`."""
    atexit.unregister(stop)


def _may_handle_sigterm() -> bool:
    return (
        threading.current_thread() is threading.main_thread()
        and signal.getsignal(signal.SIGTERM) is signal.SIG_DFL
    )


def _exit_on_sigterm(number: int, frame: FrameType | None) -> NoReturn:  # noqa: ARG001
    """Exit as Python does after an error: `finally` and atexit run, and the robot is stopped."""
    raise SystemExit(128 + number)
