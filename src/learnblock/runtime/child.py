"""The child: the process (or thread) that holds the user's program and nothing else."""

import builtins
import os
import random
import signal
import socket
import sys
from collections.abc import Callable, Collection, Iterator
from contextlib import ExitStack, contextmanager
from functools import partial
from types import CodeType, FrameType, SimpleNamespace, TracebackType
from typing import Any, NoReturn

from learnblock.client import Client
from learnblock.errors import LearnBlockError, ProgramStopped, did_you_mean
from learnblock.runtime import remote
from learnblock.runtime.gate import Gate, unless_shown
from learnblock.runtime.limits import Limits, contain
from learnblock.runtime.lines import (
    LineBudget,
    program_frame,
    start_line_events,
)
from learnblock.runtime.link import Link
from learnblock.runtime.messages import (
    Control,
    Ended,
    Fault,
    FromHost,
    Input,
    Printed,
    Setup,
    Variables,
)
from learnblock.runtime.output import LineWriter
from learnblock.runtime.own_files import own_frame, own_place
from learnblock.runtime.usertime import use_robot_time
from learnblock.runtime.values import described, encodable, shortened

#: Our own robots' modules.
_ROBOTS = "learnblock.robots."
#: An error's text is cut there.
LONGEST_ERROR = 2000


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
    try:
        link.send(_ended(link, fence))
    except EOFError:
        # The host has changed its mind, or is gone, and with it everybody who would want to know.
        return


def _ended(link: Link[FromHost], fence: Callable[[Limits], None] | None) -> Ended:
    """Run the program; how it ended.

    Raises:
        EOFError: the host was gone before it began.
    """
    try:
        setup = link.receive()
        if not isinstance(setup, Setup):
            raise TypeError(f"expected Setup, got {type(setup).__name__}")
        if fence:
            fence(setup.limits)
        return _Program(link, setup, owns_process=fence is not None).run()
    except ProgramStopped:
        # A signal that came before the program began, or just as it ended by itself.
        return Ended(stopped=True)


class _Program:
    """One program while it runs."""

    def __init__(self, link: Link[FromHost], setup: Setup, *, owns_process: bool) -> None:
        self._wire = remote.Wire(link, self._variables)
        self._setup = setup
        self._owns_process = owns_process
        self._robot: remote.RemoteRobot | None = None
        self._cleanup = ExitStack()
        self._end_lines: Callable[[], object] = bool
        self._gate: Gate | None = None
        self._output = LineWriter(self._printed, self._wire.flush)

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
            "__file__": os.path.join(self._setup.folder, self._setup.filename),  # noqa: PTH118 - text
            "__builtins__": self._builtins(),
        }
        if self._owns_process:
            self._cleanup.enter_context(self._own_process(namespace))
        self._cleanup.callback(self._output.finish)
        self._cleanup.callback(self._stop_robot)
        self._code = code
        if self._setup.debug:
            self._watch_gate(self._setup.debug)
        exec(code, namespace)  # noqa: S102 - running the user's program is what we are for

    def _interrupt(self, number: int, frame: FrameType | None) -> None:  # noqa: ARG002
        stopped = ProgramStopped("stopped")
        if self._wire.turn.postpones(stopped):
            return
        at = program_frame(self._setup.filename, frame)
        self._wire.interrupted(at.f_lineno if at else 0, *own_frame(frame))
        raise stopped

    def _stop_robot(self) -> None:
        self._end_lines()
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
        signal.signal(signal.SIGTERM, self._interrupt)
        sys.stdout = sys.stderr = self._output
        # For the modules that the program imports, and the files of its skills.
        builtins.input = self._input
        if self._setup.folder:
            sys.path.insert(0, self._setup.folder)
        # The module `__main__` is the program, as it would be without us.
        vars(sys.modules["__main__"]).update(namespace)
        try:
            yield
        finally:
            # It is over: what is left to do is to say how.
            signal.signal(signal.SIGTERM, signal.SIG_IGN)

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
        self._begin_lines(LineBudget(robot.clock, self._wire.note_line))
        return robot

    def _watch_gate(self, control: Control) -> None:
        """Ask at every line from the first on whether the program is held."""
        self._wire.control = control
        self._gate = Gate(self._wire, self._setup.filename)
        self._end_lines = start_line_events(self._code, unless_shown(self._wire.turn, self._gate))

    def _begin_lines(self, budget: LineBudget) -> None:
        # Not earlier: without a robot there is no time to say that a line ran at.
        if self._gate:
            self._gate.on_line = budget
            return
        self._end_lines()
        frame = sys._getframe()  # noqa: SLF001 - the documented way to walk the stack
        on_line = unless_shown(self._wire.turn, budget)
        self._end_lines = start_line_events(self._code, on_line, frame)

    def _input(self, prompt: object = "") -> str:
        self._output.finish()
        answer = self._wire.ask(Input(str(prompt)))
        if answer is None:
            raise EOFError("there is no more input")
        return str(answer)

    # What the host is told.

    def _printed(self, text: str) -> None:
        self._wire.note_soon(Printed(encodable(text)))

    def _variables(self) -> Variables:
        whens = self._robot.when_states() if self._robot else {}
        frame = program_frame(self._setup.filename, sys._getframe())  # noqa: SLF001 - as above
        if frame is None:
            # A thread that runs none of the program's own code.
            return Variables({}, {}, whens)
        local = {} if frame.f_locals is frame.f_globals else _described(frame.f_locals)
        return Variables(local, _described(frame.f_globals), whens)

    def _fault(self, error: BaseException) -> Fault:
        text = shortened(encodable(_message(error)), LONGEST_ERROR)
        return Fault(type(error).__name__, text, self._lines(error), *own_place(error))

    def _lines(self, error: BaseException) -> tuple[int, ...]:
        if isinstance(error, SyntaxError) and error.filename == self._setup.filename:
            return (error.lineno or 0,)
        return tuple(
            number
            for code, number in _walk(error.__traceback__)
            if code.co_filename == self._setup.filename
        )

    def _left(self, leaving: SystemExit) -> Ended:
        """`sys.exit()` ends a program well; with a message or a status it is an error."""
        if leaving.code in (None, 0):
            return Ended()
        return Ended(self._fault(leaving))


def _walk(step: TracebackType | None) -> Iterator[tuple[CodeType, int]]:
    while step is not None:
        yield step.tb_frame.f_code, step.tb_lineno
        step = step.tb_next


def _stop_program(number: int, frame: FrameType | None) -> NoReturn:  # noqa: ARG001
    raise ProgramStopped("stopped")


def _print_to(output: LineWriter, *values: object, **options: Any) -> None:
    print(*values, **{"file": output, **options})  # noqa: T201 - this is what a program prints with


def _message(error: BaseException) -> str:
    """An error's text, with a hint where a name is known that is nearly the one asked for."""
    if isinstance(error, SyntaxError):
        # Its text would repeat the file and the line.
        return str(error.msg)
    try:
        text = str(error)
    except Exception as another:  # noqa: BLE001 - a pupil's __str__ may raise anything
        return f"<{type(another).__name__} in its own description>"
    hint = _hint(error)
    return f"{text}; {hint}" if hint else text


def _hint(error: BaseException) -> str:
    if not isinstance(error, NameError | AttributeError) or not isinstance(error.name, str):
        return ""
    known = dir(error.obj) if isinstance(error, AttributeError) else _visible(error.__traceback__)
    return did_you_mean(error.name, [name for name in known if not name.startswith("_")])


def _visible(step: TracebackType | None) -> Collection[str]:
    """The names that can be used where an error was raised."""
    while step and step.tb_next:
        step = step.tb_next
    frame = step.tb_frame if step else None
    return {*vars(builtins), *frame.f_globals, *frame.f_locals} if frame else ()


def _described(variables: Any) -> dict[str, str]:
    return {
        encodable(name): described(value)
        for name, value in list(variables.items())
        if not name.startswith("__") and not isinstance(value, Client) and not callable(value)
    }


if __name__ == "__main__":
    main()
