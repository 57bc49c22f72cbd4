"""Line events: which statement of a program is about to run, by its first line."""

import sys
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from threading import get_ident
from types import CodeType, FrameType
from typing import TYPE_CHECKING, Any

from learnblock.runtime.statements import Statements, has_statements

if TYPE_CHECKING:
    from learnblock.client.clock import Clock

OnLine = Callable[[int], object]
#: The maximum number of lines that are passed on at one time of the robot.
MOST_LINES_AT_ONE_TIME = 1000


@contextmanager
def line_events(code: CodeType, source: str, on_line: OnLine) -> Iterator[None]:
    """Inside the `with`, call `on_line(number)` before each statement of `code`."""
    stop = start_line_events(code, source, on_line)
    try:
        yield
    finally:
        stop()


def start_line_events(
    code: CodeType, source: str, on_line: OnLine, running: FrameType | None = None
) -> Callable[[], None]:
    """Begin line events for `code` and its functions; return the function that ends them.

    The same program gives the same events on every version of Python.

    Args:
        code: a module's code.
        source: the source of `code`.
        on_line: called with the first line of each statement that is about to run.
        running: the innermost frame of the program, if it is already running.

    Only statements of the calling thread are reported.
    """
    statements = Statements(source)
    for frame in _program_frames(code.co_filename, running):
        statements.resume(frame)
    if sys.version_info >= (3, 12):
        return _monitor(code, statements, on_line)
    return _trace(code.co_filename, statements, on_line, running)


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

    def __init__(self, clock: "Clock", on_line: OnLine) -> None:
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


def _program_frames(filename: str, running: FrameType | None) -> Iterator[FrameType]:
    """The frames of the file `filename` that are running, innermost first."""
    frame = program_frame(filename, running)
    while frame is not None:
        yield frame
        frame = program_frame(filename, frame.f_back)


def _monitor(code: CodeType, statements: Statements, on_line: OnLine) -> Callable[[], None]:
    # PEP 669: only the program's own code is slowed, and only at its lines.
    events: Any = sys.monitoring.events  # type: ignore[attr-defined,unused-ignore] # 3.12
    thread = get_ident()

    def start(_code: CodeType, _offset: int) -> None:
        if get_ident() == thread:
            statements.enter(sys._getframe(1))  # noqa: SLF001 - the documented way

    def line(_code: CodeType, number: int) -> None:
        if get_ident() == thread:
            begun = statements.begun(sys._getframe(1), number)  # noqa: SLF001 - as above
            if begun:
                on_line(begun)

    return _register(code, {events.PY_START: start, events.LINE: line})


def _register(code: CodeType, callbacks: Mapping[int, Callable[..., None]]) -> Callable[[], None]:
    """Make the interpreter call back at events of `code`; return the function that ends that."""
    monitoring: Any = sys.monitoring  # type: ignore[attr-defined,unused-ignore] # 3.12
    tool = next(tool for tool in range(6) if monitoring.get_tool(tool) is None)
    monitoring.use_tool_id(tool, "learnblock")
    for event, callback in callbacks.items():
        monitoring.register_callback(tool, event, callback)
    for part in _parts(code):
        monitoring.set_local_events(tool, part, sum(callbacks))

    def stop() -> None:
        for part in _parts(code):
            monitoring.set_local_events(tool, part, monitoring.events.NO_EVENTS)
        for event in callbacks:
            monitoring.register_callback(tool, event, None)
        monitoring.free_tool_id(tool)

    return stop


def _parts(code: CodeType) -> Iterator[CodeType]:
    if has_statements(code):
        yield code
    for constant in code.co_consts:
        if isinstance(constant, CodeType):
            yield from _parts(constant)


def _trace(
    filename: str, statements: Statements, on_line: OnLine, running: FrameType | None
) -> Callable[[], None]:
    def local(frame: FrameType, event: str, _argument: object) -> Any:
        if event == "line":
            begun = statements.begun(frame, frame.f_lineno)
            if begun:
                on_line(begun)
        return local

    def enter(frame: FrameType, _event: str, _argument: object) -> Any:
        if frame.f_code.co_filename != filename or not has_statements(frame.f_code):
            return None
        statements.enter(frame)
        return local

    # A frame that is already running is not entered again, so it needs its own trace function.
    for frame in _program_frames(filename, running):
        if has_statements(frame.f_code):
            frame.f_trace = local
    sys.settrace(enter)
    return lambda: sys.settrace(None)
