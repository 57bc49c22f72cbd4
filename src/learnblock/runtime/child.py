"""The child: the process or thread that runs the user's program and nothing else."""

import ast
import builtins
import os
import random
import signal
import socket
import sys
from collections.abc import Callable, Iterator
from contextlib import AbstractContextManager, ExitStack, contextmanager
from functools import partial
from types import CodeType, FrameType, SimpleNamespace, TracebackType
from typing import Any, NoReturn

from msgspec import structs

from learnblock.client import Client, skills
from learnblock.errors import InputEndedError, LearnBlockError, ProgramStopped
from learnblock.runtime import remote
from learnblock.runtime.claims import last_line
from learnblock.runtime.containment import fence
from learnblock.runtime.error_phrases import phrase_of
from learnblock.runtime.failed_code import failed_code
from learnblock.runtime.forking import next_program
from learnblock.runtime.gate import Gate, unless_shown
from learnblock.runtime.lines import (
    LineBudget,
    program_frame,
    start_line_events,
)
from learnblock.runtime.link import Link, SocketLink
from learnblock.runtime.lockstep import LockStepClock
from learnblock.runtime.log.instrumenting import instrument
from learnblock.runtime.log.noting import Noting
from learnblock.runtime.messages import (
    LONGEST_PROMPT,
    MOST_NUMBERS,
    Contained,
    Control,
    Ended,
    Fault,
    FromHost,
    Logged,
    Printed,
    Setup,
    Stuck,
    Variables,
)
from learnblock.runtime.output import LineStream
from learnblock.runtime.own_files import own_frame, own_place
from learnblock.runtime.userrandom import use_own_random
from learnblock.runtime.usertime import use_robot_time
from learnblock.runtime.values import encodable, shortened
from learnblock.runtime.variable_texts import described_variables
from learnblock.runtime.wire import Wire

#: The modules of the built-in robots.
_ROBOTS = "learnblock.robots."


def main() -> None:
    """Run as ``python -m learnblock.runtime.child FD``: FD is our end of the link.

    If it is a fork server's end of its orders, each order makes a process that runs as usual.
    """
    given = socket.socket(fileno=int(sys.argv[1]))
    is_link = given.type is socket.SOCK_STREAM
    connection = given if is_link else next_program(given, fence.prepare, skills.prepare)
    if connection is not None:
        _be_program(SocketLink(connection, FromHost))


def _be_program(link: Link[FromHost]) -> None:
    signal.signal(signal.SIGTERM, _stop_program)
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    try:
        if hasattr(signal, "pthread_sigmask"):
            # A fork server keeps it back until here.
            signal.pthread_sigmask(signal.SIG_UNBLOCK, {signal.SIGTERM})
        # Its host may still be loading.
        fence.prepare()
        skills.prepare()
    except ProgramStopped:
        # Stopped as soon as it was started.
        link.send(Ended(stopped=True))
        link.close()
        return
    run(link, fence.contain)


def run(link: Link[FromHost], contain: Callable[[Setup], None] | None = None) -> None:
    """Receive the setup, run the program, and report how it ended.

    Args:
        link: our end of the link.
        contain: contains this process; None in a thread of the host.
    """
    try:
        link.send(_ended(link, contain))
    except EOFError:
        # The host has stopped the run or is gone, so there is no recipient.
        return


def _ended(link: Link[FromHost], contain: Callable[[Setup], None] | None) -> Ended:
    """Run the program; return how it ended.

    Raises:
        EOFError: the host was gone before the program began.
    """
    try:
        setup = link.receive()
        if not isinstance(setup, Setup):
            raise TypeError(f"expected Setup, got {type(setup).__name__}")
        if contain:
            contain(setup)
        link.send(Contained())
        return _Program(link, setup, owns_process=contain is not None).run()
    except ProgramStopped:
        # A signal arrived before the program began, or just as it ended.
        return Ended(stopped=True)
    except LearnBlockError as error:
        # Without its fence a program does not run.
        return Ended(Fault(error.phrase, ()))


def _preferring(tags: dict[str, int], *, alone: bool) -> AbstractContextManager[None]:
    from learnblock.perception import tag_names  # noqa: PLC0415 - few projects have their own tags

    return tag_names.preferring(tags, alone=alone)


class _Program:
    """A running program."""

    def __init__(self, link: Link[FromHost], setup: Setup, *, owns_process: bool) -> None:
        self._wire = Wire(link, self._variables)
        self._setup = setup
        self._owns_process = owns_process
        self._robot: remote.RemoteRobot | None = None
        self._cleanup = ExitStack()
        self._end_lines: Callable[[], object] = bool
        self._gate: Gate | None = None
        self._noting: Noting | None = None
        self._output = LineStream(self._printed, self._wire.flush)
        self._is_stuck = False
        #: The characters that it may still print.
        self._unprinted = setup.limits.output
        #: Its variables once it has ended, if its host wants them.
        self._last_variables: Variables | None = None

    def run(self) -> Ended:
        """Run the program; return how it ended."""
        return structs.replace(self._ended(), variables=self._last_variables)

    def _ended(self) -> Ended:
        try:
            with self._cleanup:
                self._execute()
        except ProgramStopped as stopped:
            return Ended(stopped=True, lines=self._lines(stopped))
        except SystemExit as leaving:
            return self._left(leaving)
        except BaseException as error:  # noqa: BLE001 - every error is reported
            return Ended(self._fault(error))
        return Ended()

    def _execute(self) -> None:
        builtin_names = self._builtins()
        code = self._compile(builtin_names)
        namespace = {
            "__name__": "__main__",
            "__file__": os.path.join(self._setup.folder, self._setup.filename),  # noqa: PTH118 - text
            "__builtins__": builtin_names,
        }
        if self._owns_process:
            self._cleanup.enter_context(self._own_process(namespace))
        else:
            self._cleanup.callback(use_own_random())
        if self._setup.tags:
            self._cleanup.enter_context(_preferring(self._setup.tags, alone=self._owns_process))
        self._cleanup.callback(self._output.finish)
        if self._setup.variables:
            self._cleanup.callback(self._keep_variables, namespace)
        self._cleanup.callback(self._stop_robot)
        self._code = code
        if self._setup.debug:
            self._watch_gate(self._setup.debug)
        exec(code, namespace)  # noqa: S102 - running the user's program is the purpose

    def _compile(self, builtin_names: dict[str, Any]) -> CodeType:
        program: str | ast.Module = self._setup.source
        if self._setup.log:
            # Mistakes are those of the source itself.
            compile(program, self._setup.filename, "exec", dont_inherit=True)
            program = instrument(self._setup.source).tree
            self._noting = Noting(self._log, self._setup.filename)
            self._noting.install(builtin_names)
        return compile(program, self._setup.filename, "exec", dont_inherit=True)

    def _interrupt(self, number: int, frame: FrameType | None) -> None:  # noqa: ARG002
        stopped = ProgramStopped("stopped")
        if self._wire.turn.postpone(stopped):
            return
        at = program_frame(self._setup.filename, frame)
        self._wire.interrupted(at.f_lineno if at else 0, *own_frame(frame))
        raise stopped

    def _stop_robot(self) -> None:
        self._end_lines()
        if self._noting:
            self._noting.flush()
        if self._robot:
            self._robot.stop()
        # Commands to a stopped robot, which its host refuses.
        self._wire.flush()

    # The environment of the program.

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
        # The module `__main__` is the program, as without LearnBlock.
        vars(sys.modules["__main__"]).update(namespace)
        try:
            yield
        finally:
            # The program has ended; only the report of its ending remains.
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
            raise LearnBlockError("run-second-robot")
        if self._noting:
            # Each robot has a time of its own.
            self._noting.flush()
        robot = remote.connect(
            self._wire,
            self._setup.skills,
            module,
            arguments,
            self._noting,
            anyway=self._setup.anyway,
        )
        if self._wire.lockstep:
            random.seed(robot.seed)
            self._cleanup.callback(use_robot_time(robot.clock))
        self._robot = robot
        beyond = self._beyond if self._setup.dead_ends else None
        self._begin_lines(LineBudget(robot.clock, self._wire.note_line, self._wire.turn, beyond))
        return robot

    def _watch_gate(self, control: Control) -> None:
        """Check at every line, from the first one, whether the program pauses."""
        self._wire.control = control
        self._gate = Gate(self._wire, self._setup.filename)
        if self._noting:
            self._gate.before_pause = self._noting.flush
        on_line = unless_shown(self._wire.turn, self._gate)
        self._end_lines = start_line_events(self._code, self._setup.source, on_line)

    def _begin_lines(self, budget: LineBudget) -> None:
        # Not earlier, because without a robot there is no time for a line event.
        if self._gate:
            self._gate.on_line = budget
            return
        self._end_lines()
        frame = sys._getframe()  # noqa: SLF001 - the documented way to walk the stack
        self._end_lines = start_line_events(self._code, self._setup.source, budget, frame)

    def _beyond(self, line: int) -> None:
        """Tell, once, that the program has no way out of a loop."""
        if line in self._setup.dead_ends and not self._is_stuck:
            self._is_stuck = True
            self._wire.send(Stuck())

    def _input(self, prompt: object = "") -> str:
        self._output.finish()
        answer, steps = self._wire.input(shortened(encodable(str(prompt)), LONGEST_PROMPT - 3))
        if self._robot and isinstance(self._robot.clock, LockStepClock) and steps is not None:
            self._robot.clock.instant = steps
            if self._noting:
                self._noting.woke(steps)
        if answer is None:
            raise InputEndedError("run-input-ended")
        return answer

    # Messages to the host.

    def _log(self, first: int, last: int, events: bytes) -> None:
        self._wire.note(Logged(first, last, events))

    def _printed(self, text: str) -> None:
        if self._unprinted < 0:
            return
        shown = encodable(text)
        self._wire.note_soon(Printed(shown))
        self._unprinted -= len(shown)
        if self._unprinted < 0:
            # Here, however far ahead of its host it is.
            self._wire.await_stop()

    def _variables(self) -> Variables:
        whens = self._whens()
        frame = program_frame(self._setup.filename, sys._getframe())  # noqa: SLF001 - as above
        if frame is None:
            # A thread that does not run the program's code.
            return Variables({}, {}, whens)
        local = {} if frame.f_locals is frame.f_globals else described_variables(frame.f_locals)
        return Variables(local, described_variables(frame.f_globals), whens)

    def _keep_variables(self, namespace: dict[str, Any]) -> None:
        self._last_variables = Variables({}, described_variables(namespace), self._whens())

    def _whens(self) -> dict[str, tuple[bool, float]]:
        return self._robot.when_states() if self._robot else {}

    def _fault(self, error: BaseException) -> Fault:
        failed = failed_code(error, self._setup.filename, self._setup.source)
        return Fault(phrase_of(error, failed), self._lines(error), *own_place(error))

    def _lines(self, error: BaseException) -> tuple[int, ...]:
        last = last_line(self._setup.source)
        if isinstance(error, SyntaxError) and error.filename == self._setup.filename:
            return (min(max(0, error.lineno or 0), last),)
        steps = [
            (code, number)
            for code, number in _walk(error.__traceback__)
            if code.co_filename == self._setup.filename and number <= last
        ]
        if isinstance(error, RecursionError) and len(steps) > 1:
            code, number = steps[-1]
            # The stack may be full before a function has begun: then the call is to blame.
            if number == code.co_firstlineno:
                steps.pop()
        return tuple(number for _, number in steps[-MOST_NUMBERS:])

    def _left(self, leaving: SystemExit) -> Ended:
        """`sys.exit()` ends a program normally; with a message or a status it is an error."""
        if leaving.code in (None, 0):
            return Ended()
        return Ended(self._fault(leaving))


def _walk(step: TracebackType | None) -> Iterator[tuple[CodeType, int]]:
    while step is not None:
        yield step.tb_frame.f_code, step.tb_lineno
        step = step.tb_next


def _stop_program(number: int, frame: FrameType | None) -> NoReturn:  # noqa: ARG001
    raise ProgramStopped("stopped")


def _print_to(output: LineStream, *values: object, **options: Any) -> None:
    print(*values, **{"file": output, **options})  # noqa: T201 - the program's own print


if __name__ == "__main__":
    main()
