"""Line events: which statement of a program is about to run, by its first line."""

import sys
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from functools import partial, wraps
from threading import get_ident
from types import CodeType, FrameType
from typing import TYPE_CHECKING, Any

from learnblock.runtime.statements import OnLine, Statements, has_statements
from learnblock.runtime.turn import Turn

if TYPE_CHECKING:
    from learnblock.client.clock import Clock

#: Called with a frame and where it is: at the start of a function, and at a line.
_Callbacks = tuple[Callable[[FrameType, int], None], Callable[[FrameType, int], None]]
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
    if sys.version_info >= (3, 12):
        for frame in _program_frames(code.co_filename, running):
            statements.resume(frame)
        return _monitor(code, statements, on_line)
    return _trace(code.co_filename, statements, on_line, running)


def without_line_events(
    function: Callable[..., Any], is_alone: Callable[[tuple[Any, ...], dict[str, Any]], bool]
) -> Callable[..., Any]:
    """`function` without the cost of line events in calls that run no statement of the program.

    Up to Python 3.11 the interpreter reports every call of any function in them.

    Args:
        function: the function.
        is_alone: whether the call with these arguments runs no statement of the program.
    """
    if sys.version_info >= (3, 12):
        return function

    @wraps(function)
    def unseen(*args: Any, **kwargs: Any) -> Any:
        tracer = sys.gettrace()
        if tracer is None:
            return function(*args, **kwargs)
        sys.settrace(None)
        try:
            if (args or kwargs) and not is_alone(args, kwargs):
                sys.settrace(tracer)
            return function(*args, **kwargs)
        finally:
            sys.settrace(tracer)

    return unseen


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
        turn: the lines of a thread that may not take it are not passed on: they run only to
            describe a variable.
        beyond: called with the number of each line that is not passed on.
    """

    def __init__(
        self,
        clock: "Clock",
        on_line: OnLine,
        turn: Turn | None = None,
        beyond: OnLine | None = None,
    ) -> None:
        self._clock = clock
        self._on_line = on_line
        self._turn = turn or Turn()
        self._beyond = beyond
        self._moment = -1
        self._left = 0

    def __call__(self, number: int) -> None:
        if self._turn.forbidden_to is not None and self._turn.forbidden_to == get_ident():
            return
        moment = self._clock.instant
        if moment is None:
            moment = int(self._clock.time() * 10)
        if moment != self._moment:
            self._moment, self._left = moment, MOST_LINES_AT_ONE_TIME
        if self._left > 0:
            self._left -= 1
            self._on_line(number)
        elif self._beyond:
            self._beyond(number)


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
    thread = get_ident()

    def start(frame: FrameType, _offset: int) -> None:
        if get_ident() == thread:
            statements.enter(frame)

    def line(frame: FrameType, number: int) -> None:
        if get_ident() == thread:
            begun = statements.begun(frame, number)
            if begun:
                on_line(begun)

    return _register([*_parts(code)], (start, line))


def _register(parts: Sequence[CodeType], callbacks: _Callbacks) -> Callable[[], None]:
    """Call back at starts and lines of `parts`; return the function that ends that."""
    monitoring: Any = sys.monitoring  # type: ignore[attr-defined,unused-ignore] # 3.12
    if not _monitored:
        _take_tool(monitoring)
    [tool] = _tools
    for part in parts:
        # By identity: two programs that run at the same time may have equal code.
        _monitored[id(part)] = callbacks
        monitoring.set_local_events(tool, part, monitoring.events.PY_START | monitoring.events.LINE)

    def stop() -> None:
        for part in parts:
            if _monitored.pop(id(part), None):
                monitoring.set_local_events(tool, part, monitoring.events.NO_EVENTS)
        if not _monitored and _tools:
            _free_tool(monitoring)

    return stop


# The interpreter has six tools for all programs in this process, so they share one.
_monitored: dict[int, _Callbacks] = {}
_tools: list[int] = []


def _take_tool(monitoring: Any) -> None:
    tool = next(tool for tool in range(6) if monitoring.get_tool(tool) is None)
    monitoring.use_tool_id(tool, "learnblock")
    _tools.append(tool)
    for which, event in enumerate((monitoring.events.PY_START, monitoring.events.LINE)):
        monitoring.register_callback(tool, event, partial(_on_event, which))


def _free_tool(monitoring: Any) -> None:
    tool = _tools.pop()
    for event in (monitoring.events.PY_START, monitoring.events.LINE):
        monitoring.register_callback(tool, event, None)
    monitoring.free_tool_id(tool)


def _on_event(which: int, code: CodeType, where: int) -> None:
    callbacks = _monitored.get(id(code))
    if callbacks:
        callbacks[which](sys._getframe(1), where)  # noqa: SLF001 - the documented way


def _parts(code: CodeType) -> Iterator[CodeType]:
    if has_statements(code):
        yield code
    for constant in code.co_consts:
        if isinstance(constant, CodeType):
            yield from _parts(constant)


def _trace(
    filename: str, statements: Statements, on_line: OnLine, running: FrameType | None
) -> Callable[[], None]:
    def enter(frame: FrameType, _event: str, _argument: object) -> Any:
        if frame.f_code.co_filename != filename or not has_statements(frame.f_code):
            return None
        return statements.follow(frame, on_line)

    # A frame that is already running is not entered again, so it needs its own trace function.
    for frame in _program_frames(filename, running):
        if has_statements(frame.f_code):
            frame.f_trace = statements.follow(frame, on_line, is_running=True)
    sys.settrace(enter)
    return lambda: sys.settrace(None)
