"""The child: the process (or thread) that holds the user's program and nothing else."""

import builtins
import random
import signal
import socket
import sys
import traceback
from collections.abc import Callable, Iterator
from contextlib import ExitStack, contextmanager
from functools import partial
from types import FrameType, SimpleNamespace
from typing import Any, NoReturn

from learnblock.client import Client
from learnblock.errors import LearnBlockError, ProgramStopped
from learnblock.runtime import remote
from learnblock.runtime.limits import Limits, contain
from learnblock.runtime.lines import LineBudget, depth, line_events
from learnblock.runtime.link import Link
from learnblock.runtime.messages import (
    Continue,
    Ended,
    Fault,
    FromHost,
    Input,
    Line,
    Printed,
    Setup,
    ShowVariables,
    Variables,
)
from learnblock.runtime.output import LineWriter
from learnblock.runtime.usertime import use_robot_time

#: Our own robots' modules.
_ROBOTS = "learnblock.robots."
#: A variable's text is cut there.
LONGEST_VALUE = 200


def main() -> None:
    """Run as ``python -m learnblock.runtime.child FD``: FD is our end of the link."""
    link: Link[FromHost] = Link(socket.socket(fileno=int(sys.argv[1])), FromHost)
    signal.signal(signal.SIGTERM, _stop_program)
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    run(link, contain)


def run(link: Link[FromHost], fence: Callable[[Limits], None] | None = None) -> None:
    """Receive the setup, run the program, and say how it ended.

    Args:
        link: our end of the link.
        fence: puts this process under the limits; None in a thread of the host.
    """
    setup = link.receive()
    if not isinstance(setup, Setup):
        raise TypeError(f"expected Setup, got {type(setup).__name__}")
    if fence:
        fence(setup.limits)
    program = _Program(remote.Wire(link), setup, owns_process=fence is not None)
    try:
        ended = program.run()
    except ProgramStopped:
        # A signal that came just as the program ended by itself.
        ended = Ended(stopped=True)
    try:
        link.send(ended)
    except EOFError:
        # The host is gone, and with it everybody who would want to know.
        return


class _Program:
    """One program while it runs."""

    def __init__(self, wire: remote.Wire, setup: Setup, *, owns_process: bool) -> None:
        self._wire = wire
        self._setup = setup
        self._owns_process = owns_process
        self._robot: remote.RemoteRobot | None = None
        self._cleanup = ExitStack()
        self._output = LineWriter(self._printed)
        # Until there is a robot there is no time to say that a line ran at.
        self._note_line: LineBudget | None = None

    def run(self) -> Ended:
        try:
            with self._cleanup:
                self._execute()
        except ProgramStopped as stopped:
            return Ended(stopped=True, lines=self._lines(stopped))
        except SystemExit as leaving:
            return self._left(leaving)
        except BaseException as error:  # noqa: BLE001 - whatever it is, the user is told
            return Ended(self._fault(error))
        return Ended()

    def _execute(self) -> None:
        code = compile(self._setup.source, self._setup.filename, "exec", dont_inherit=True)
        namespace = {
            "__name__": "__main__",
            "__file__": self._setup.filename,
            "__builtins__": self._builtins(),
        }
        if self._owns_process:
            self._cleanup.enter_context(self._own_process(namespace))
        self._cleanup.callback(self._output.finish)
        self._cleanup.callback(self._stop_robot)
        self._cleanup.enter_context(line_events(code, self._on_line))
        exec(code, namespace)  # noqa: S102 - running the user's program is what we are for

    def _stop_robot(self) -> None:
        if self._robot:
            self._robot.stop()

    # What a program finds round it.

    def _builtins(self) -> dict[str, Any]:
        replaced: dict[str, Any] = {"__import__": self._import, "input": self._input}
        if not self._owns_process:
            replaced["print"] = partial(_print_to, self._output)
        return {**vars(builtins), **replaced}

    @contextmanager
    def _own_process(self, namespace: dict[str, Any]) -> Iterator[None]:
        sys.stdout = sys.stderr = self._output
        if self._setup.folder:
            sys.path.insert(0, self._setup.folder)
        # The module `__main__` is the program, as it would be without us.
        vars(sys.modules["__main__"]).update(namespace)
        yield

    def _import(
        self,
        name: str,
        globals: Any = None,  # noqa: A002 - the names of builtins.__import__
        locals: Any = None,  # noqa: A002
        fromlist: Any = (),
        level: int = 0,
    ) -> Any:
        if level == 0 and fromlist and (name in self._setup.robots or name.startswith(_ROBOTS)):
            return SimpleNamespace(Robot=partial(self._connect, name))
        return builtins.__import__(name, globals, locals, fromlist, level)

    def _connect(self, module: str, **arguments: Any) -> Client:
        if self._robot and not self._robot.stopped:
            raise LearnBlockError("a program has one robot: this is the second `Robot()` in it")
        robot = remote.connect(self._wire, self._setup.skills, module, arguments)
        if self._wire.lockstep:
            random.seed(robot.seed)
            self._cleanup.callback(use_robot_time(robot.clock))
        self._robot = robot
        self._note_line = LineBudget(robot.clock, lambda number: self._wire.note(Line(number, 0)))
        return robot

    def _input(self, prompt: object = "") -> str:
        self._output.finish()
        answer = self._wire.ask(Input(str(prompt)))
        if answer is None:
            raise EOFError("there is no more input")
        return str(answer)

    # What the host is told.

    def _printed(self, text: str) -> None:
        self._wire.note_soon(Printed(text))

    def _on_line(self, number: int) -> None:
        if self._setup.debug:
            self._hold_at_line(number)
        elif self._note_line:
            self._note_line(number)

    def _hold_at_line(self, number: int) -> None:
        frame = _frame_of(self._setup.filename)
        self._wire.send(Line(number, depth(self._setup.filename)))
        while not isinstance(message := self._wire.receive(), Continue):
            if isinstance(message, ShowVariables):
                self._wire.send(_variables(frame))

    def _fault(self, error: BaseException) -> Fault:
        described = traceback.TracebackException.from_exception(error, compact=True)
        *_, summary = described.format_exception_only()
        _, _, text = summary.rstrip("\n").partition(": ")
        return Fault(type(error).__name__, text or str(error), self._lines(error))

    def _lines(self, error: BaseException) -> tuple[int, ...]:
        if isinstance(error, SyntaxError) and error.filename == self._setup.filename:
            return (error.lineno or 0,)
        return tuple(
            number
            for frame, number in traceback.walk_tb(error.__traceback__)
            if frame.f_code.co_filename == self._setup.filename
        )

    def _left(self, leaving: SystemExit) -> Ended:
        """`sys.exit()` ends a program well; with a message or a status it is an error."""
        if leaving.code in (None, 0):
            return Ended()
        return Ended(Fault("SystemExit", str(leaving.code), self._lines(leaving)))


def _stop_program(number: int, frame: FrameType | None) -> NoReturn:  # noqa: ARG001
    raise ProgramStopped("stopped")


def _print_to(output: LineWriter, *values: object, **options: Any) -> None:
    print(*values, **{"file": output, **options})  # noqa: T201 - this is what a program prints with


def _frame_of(filename: str) -> FrameType:
    frame: FrameType | None = sys._getframe(1)  # noqa: SLF001 - the documented way to walk the stack
    while frame is not None and frame.f_code.co_filename != filename:
        frame = frame.f_back
    if frame is None:
        raise LookupError(f"nothing of {filename} is running")
    return frame


def _variables(frame: FrameType) -> Variables:
    local = {} if frame.f_locals is frame.f_globals else _described(frame.f_locals)
    return Variables(local, _described(frame.f_globals))


def _described(variables: Any) -> dict[str, str]:
    return {
        name: _text(value)
        for name, value in variables.items()
        if not name.startswith("__") and not isinstance(value, Client) and not callable(value)
    }


def _text(value: object) -> str:
    try:
        text = repr(value)
    except Exception as error:  # noqa: BLE001 - a pupil's __repr__ may raise anything
        return f"<{type(error).__name__} in its own description>"
    return text if len(text) <= LONGEST_VALUE else text[:LONGEST_VALUE] + "..."


if __name__ == "__main__":
    main()
