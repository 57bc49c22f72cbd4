"""Line events: which line of a program is about to run."""

import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from threading import get_ident
from types import CodeType, FrameType
from typing import Any

from learnblock.client.clock import Clock

OnLine = Callable[[int], object]
#: The maximum number of lines that are passed on at one time of the robot.
MOST_LINES_AT_ONE_TIME = 1000


@contextmanager
def line_events(code: CodeType, on_line: OnLine) -> Iterator[None]:
    """Inside the `with`, call `on_line(number)` before each line of `code` and its functions."""
    stop = start_line_events(code, on_line)
    try:
        yield
    finally:
        stop()


def start_line_events(
    code: CodeType, on_line: OnLine, running: FrameType | None = None
) -> Callable[[], None]:
    """Begin line events for `code`; return the function that ends them.

    Args:
        code: a module's code.
        on_line: called with the number of each line.
        running: the innermost frame of the program, if it is already running.

    Only lines of the calling thread are reported.
    """
    if sys.version_info >= (3, 12):
        return _monitor(code, on_line)
    return _trace(code.co_filename, on_line, running)


def program_frame(filename: str, frame: FrameType | None) -> FrameType | None:
    """The innermost frame of the file `filename` among `frame` and its callers, or None."""
    while frame is not None and frame.f_code.co_filename != filename:
        frame = frame.f_back
    return frame


class LineBudget:
    """Passes on line events, up to a limit at one time of the robot.

    A long calculation is of no interest and must not fill the trace.

    Args:
        clock: the robot's clock.
        on_line: called with the number of each line.
    """

    def __init__(self, clock: Clock, on_line: OnLine) -> None:
        self._clock = clock
        self._on_line = on_line
        self._moment = -1
        self._left = 0

    def __call__(self, number: int) -> None:
        moment = self._clock.instant
        if moment is None:
            moment = int(self._clock.time() * 10)
        if moment != self._moment:
            self._moment, self._left = moment, MOST_LINES_AT_ONE_TIME
        if self._left > 0:
            self._left -= 1
            self._on_line(number)


def depth(filename: str) -> int:
    """The number of frames of the file `filename` among the caller's callers."""
    frame, count = sys._getframe(1), 0  # noqa: SLF001 - the documented way to walk the stack
    walker: FrameType | None = frame
    while walker is not None:
        count += walker.f_code.co_filename == filename
        walker = walker.f_back
    return count


def _monitor(code: CodeType, on_line: OnLine) -> Callable[[], None]:
    # PEP 669: only the program's own code is slowed, and only at its lines.
    monitoring: Any = sys.monitoring  # type: ignore[attr-defined,unused-ignore] # 3.12
    tool = next(tool for tool in range(6) if monitoring.get_tool(tool) is None)
    thread = get_ident()

    def line(_code: CodeType, number: int) -> None:
        if get_ident() == thread:
            on_line(number)

    monitoring.use_tool_id(tool, "learnblock")
    monitoring.register_callback(tool, monitoring.events.LINE, line)
    for part in _parts(code):
        monitoring.set_local_events(tool, part, monitoring.events.LINE)

    def stop() -> None:
        for part in _parts(code):
            monitoring.set_local_events(tool, part, monitoring.events.NO_EVENTS)
        monitoring.register_callback(tool, monitoring.events.LINE, None)
        monitoring.free_tool_id(tool)

    return stop


def _parts(code: CodeType) -> Iterator[CodeType]:
    yield code
    for constant in code.co_consts:
        if isinstance(constant, CodeType):
            yield from _parts(constant)


def _trace(filename: str, on_line: OnLine, running: FrameType | None) -> Callable[[], None]:
    def local(frame: FrameType, event: str, _argument: object) -> Any:
        if event == "line":
            on_line(frame.f_lineno)
        return local

    def enter(frame: FrameType, _event: str, _argument: object) -> Any:
        return local if frame.f_code.co_filename == filename else None

    # A frame that is already running is not entered again, so it needs its own trace function.
    frame = running
    while frame := program_frame(filename, frame):
        frame.f_trace = local
        frame = frame.f_back
    sys.settrace(enter)
    return lambda: sys.settrace(None)
