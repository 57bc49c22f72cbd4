"""From a file to a finished run: what the command line and the page do alike."""

import re
from collections.abc import Callable, Collection, Mapping
from contextlib import nullcontext, suppress
from dataclasses import dataclass
from importlib.util import find_spec
from pathlib import Path
from typing import TYPE_CHECKING, Any, BinaryIO

from learnblock import language, robots, skill_files
from learnblock.blocks import all_configurations, builtin, libraries
from learnblock.blocks.importable import Importable
from learnblock.client import Client, Goal, Outcome
from learnblock.devices import Pose
from learnblock.errors import Diagnostic, LearnBlockError, ProgramError, UnknownNameError
from learnblock.language.nodes import Import
from learnblock.language.nodes import Program as Tree
from learnblock.language.python_imports import PACKAGE
from learnblock.robots import RobotEntry
from learnblock.runtime.debugger import Debugger
from learnblock.runtime.ending import Ending, How
from learnblock.runtime.host import Host
from learnblock.runtime.limits import Limits
from learnblock.runtime.process import ProcessWorker, Worker, one_processor
from learnblock.runtime.program import Program
from learnblock.runtime.run import Run
from learnblock.runtime.trace import Recorder, Trace, record
from learnblock.runtime.watcher import Watcher

if TYPE_CHECKING:
    from learnblock.robots.stage import Stage

DEFAULT_ROBOT = "sim-ebo"
#: A program larger than this is none that a person wrote.
LARGEST_PROGRAM = 4 * 1024 * 1024

_ROBOT_IMPORT = re.compile(r"^from ([\w.]+) import Robot\b", re.MULTILINE)


@dataclass(frozen=True)
class Source:
    """A program's file, read.

    Args:
        path: the file as the user named it.
        text: what stands in it.
        tree: the same as a tree.
    """

    path: Path
    text: str
    tree: Tree

    @property
    def is_python(self) -> bool:
        return self.path.suffix == ".py"

    @property
    def imports(self) -> frozenset[str]:
        """The libraries and files that it imports."""
        return frozenset(one.module for one in self.tree.items if isinstance(one, Import))

    @property
    def libraries(self) -> frozenset[str]:
        """Those that it imports as libraries, whose skills are the robot's; in Block-Text all."""
        if not self.is_python:
            return self.imports
        return frozenset(one for one in self.imports if f"{PACKAGE}.{one} import" in self.text)

    @property
    def robot(self) -> str | None:
        """The module of the robot that a Python file imports; None for Block-Text."""
        found = _ROBOT_IMPORT.search(self.text) if self.is_python else None
        return found[1] if found else None


def read(path: Path) -> Source:
    """Read a program in Block-Text (.bt) or Python (.py).

    Raises:
        ProgramError: it is wrong, with every mistake found.
        OSError: it cannot be read.
    """
    name = str(path)
    if path.suffix not in {".bt", ".py"}:
        raise ProgramError(
            name,
            [Diagnostic("unknown-notation", "a program is a .bt file (Block-Text) or a .py file")],
        )
    text = read_text(path)
    notation = language.from_python if path.suffix == ".py" else language.parse
    return Source(path, text, notation(text, name))


def read_text(path: Path) -> str:
    """The text of a program's file.

    Raises:
        ProgramError: it is too large or is no text in UTF-8.
        OSError: it cannot be read.
    """
    with path.open("rb") as file:
        data = file.read(LARGEST_PROGRAM + 1)
    if len(data) > LARGEST_PROGRAM:
        problem = f"the file is larger than {LARGEST_PROGRAM} bytes"
        raise ProgramError(str(path), [Diagnostic("too-large", problem)])
    try:
        return data.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        line = data.count(b"\n", 0, error.start) + 1
        problem = f"the byte {data[error.start]:#x} is not UTF-8; save the file as UTF-8"
        raise ProgramError(str(path), [Diagnostic("not-utf-8", problem, line)]) from error


def example(name: str) -> Path:
    """One of the examples that come with LearnBlock.

    Raises:
        UnknownNameError: there is none of that name.
    """
    # Beside the package in an installation, beside `src` in a checkout.
    here = Path(__file__).parent
    for folder in (here / "examples", here.parents[1] / "examples"):
        if folder.is_dir():
            known = {path.name: path for path in folder.iterdir()}
            if name in known:
                return known[name]
            raise UnknownNameError("example", name, known)
    raise UnknownNameError("example", name, ())


def choose_robot(source: Source, name: str | None = None) -> RobotEntry:
    """The robot called `name`, or else the one the program names, or else our default.

    Raises:
        LearnBlockError: there is no such robot.
    """
    return robots.find(name or source.robot or DEFAULT_ROBOT)


def check(source: Source, robot: RobotEntry | None = None) -> list[Diagnostic]:
    """What is wrong or doubtful in a program, on a robot when one is given."""
    devices = robot.load().known_devices() if robot else None
    folder = source.path.resolve().parent
    beside = {one.name: one for one in libraries.blocks_beside(folder, source.libraries)}
    skills = all_configurations().extended({**beside, **builtin()})
    found = libraries.importable(folder, source.imports)
    return language.check(source.tree, skills, devices, _with_packages(found, source))


def _with_packages(found: Importable, source: Source) -> Importable:
    """What Python finds: without our package before its name a library is not found."""
    plain = source.imports - source.libraries
    packages = {one for one in plain if find_spec(one.partition(".")[0]) is not None}
    return Importable(found.libraries - plain, found.files | packages)


def program(source: Source, robot: RobotEntry) -> Program:
    """What is run: the file itself if it is Python, else its translation."""
    folder = str(source.path.resolve().parent)
    if source.is_python:
        return Program(source.path.name, source.text, source.text, folder=folder)
    python = language.to_python(source.tree, robot.module)
    return Program(source.path.name, python.text, source.text, python.source_map, folder)


@dataclass(frozen=True, slots=True)
class Options:
    """How to run; what is None is left to the program, the environment and the robot.

    Args:
        world: name or path.
        seed: of all noise.
        pace: ``free``, ``real`` or a factor.
        seconds: the robot's time after which the run ends.
        start: (x mm, y mm, heading in degrees) where a simulated robot begins.
    """

    world: str | None = None
    seed: int | None = None
    pace: str | None = None
    seconds: float | None = None
    start: Pose | None = None

    @property
    def wishes(self) -> dict[str, Any]:
        """What only a simulated robot understands."""
        given = {
            "world": self.world,
            "seed": self.seed,
            "pace": self.pace,
            "start": self.start,
        }
        return {name: value for name, value in given.items() if value is not None}


@dataclass(frozen=True, slots=True)
class Report:
    """What happened in a run.

    Args:
        ended: how, one word or two; ``refused`` if the program was not even started.
        time: seconds of the robot's time.
        distance: mm driven; None where it is not known.
        pose: (x mm, y mm, heading in degrees) at the end, or None.
        goals: the world's goals.
        emotions: those shown, in order.
        no_effect: skills that had none: skill, missing device, how often.
        trace_sha256: the hash of the trace.
        error: what went wrong: message, line, and the text of that line; `within` has file, line
            and text where that was in a file of the user's own; None when nothing did.
    """

    ended: str
    time: float = 0.0
    distance: float | None = None
    pose: Pose | None = None
    goals: tuple[Goal, ...] = ()
    emotions: tuple[str, ...] = ()
    no_effect: tuple[Mapping[str, object], ...] = ()
    trace_sha256: str = ""
    error: Mapping[str, object] | None = None


class Session:
    """One run of one program, prepared.

    Args:
        program: what to run.
        robot: on which robot.
        options: how.
        trace: the file the trace goes to; None for nowhere.
        watcher: is told what happens while it happens.
        limits: what the program may use.
        worker: makes what runs the program: a process unless said otherwise.
        debugger: lets the program be paused, stepped and held at breakpoints.
    """

    def __init__(
        self,
        program: Program,
        robot: RobotEntry,
        options: Options | None = None,
        *,
        trace: BinaryIO | None = None,
        watcher: Watcher | None = None,
        limits: Limits | None = None,
        worker: Callable[[], Worker] = ProcessWorker,
        debugger: Debugger | None = None,
    ) -> None:
        self.program = program
        self.robot = robot
        self.options = options or Options()
        self.trace = Trace(trace)
        #: Where the robot is, if it is a simulated one, once the program has made it.
        self.stage: Stage | None = None
        self._debugger = debugger
        self._run = Run(
            program,
            self._make_robot,
            self._make_recorder,
            watcher=watcher,
            limits=limits,
            debugger=debugger,
            worker=worker,
            robots=tuple(entry.module for entry in robots.entries().values()),
        )
        self._host = Host(self._run, seconds=self.options.seconds)

    @property
    def client(self) -> Client | None:
        """The robot in the host, once the program has made it."""
        return self._run.client

    @property
    def recorder(self) -> Recorder | None:
        """What has been recorded so far."""
        return self._run.recorder

    def run(self) -> Report:
        """Run the program to its end."""
        with one_processor() if self.robot.load().lockstep else nullcontext():
            self._host.run()
        return self._report()

    # What follows may be called from any thread at any time.

    def stop(self) -> None:
        """End the run within a second, also while it is paused or waits for input."""
        self._host.stop()

    def pause(self) -> None:
        """Hold the world at once, and the program at its next line."""
        self._control.pause()

    def resume(self) -> None:
        """Go on after a pause or at a breakpoint."""
        self._control.resume()

    def step(self) -> None:
        """Run to the next line, into functions."""
        self._control.step()

    def step_over(self) -> None:
        """Run to the next line of the same function, or of one that called it."""
        self._control.step_over()

    def set_breakpoints(self, lines: Collection[int]) -> None:
        """Hold the program before these lines of its Python, and before no others."""
        self._control.set_breakpoints(lines)

    def set_speed(self, factor: float | None) -> None:
        """How fast a simulated world runs, times real time; None is as fast as it goes."""
        self._run.set_speed(factor)

    def tell_variables(self, tell: bool) -> None:  # noqa: FBT001 - it is told or it is not
        """Tell the watcher the program's variables some times a second, or no more."""
        self._run.tells_variables = tell

    @property
    def _control(self) -> Debugger:
        if self._debugger is None:
            raise LearnBlockError("only a run with a debugger can be paused; give `Session` one")
        return self._debugger

    def _make_robot(self, module: str, arguments: dict[str, Any]) -> Client:
        # The robot is the one chosen for this run, whichever the program's own line names.
        del module
        client = self.robot.load().hosted(arguments, self.options.wishes)
        if client.lockstep:
            self.stage = _stage(client)
        return client

    def _make_recorder(self, client: Client) -> Recorder:
        return record(client, self.program.identity, self.trace)

    def _report(self) -> Report:
        recorder, client = self._run.recorder, self._run.client
        ending = self._run.ending or Ending(How.STOPPED, "the program was stopped")
        outcome = client.outcome() if client else Outcome()
        return Report(
            time=recorder.time() if recorder else 0.0,
            distance=outcome.distance,
            pose=outcome.pose,
            goals=outcome.goals,
            emotions=tuple(recorder.emotions) if recorder else (),
            no_effect=_no_effect(recorder) if recorder else (),
            trace_sha256=self.trace.sha256,
            ended=ending.how,
            error=None if ending.well else self._error(ending),
        )

    def _error(self, ending: Ending) -> Mapping[str, object]:
        line = self.program.written_line(ending.line) if ending.line else 0
        return {
            "message": ending.sentence,
            "file": self.program.name,
            "line": line,
            "text": self.program.quote(line),
            **({"within": _within(ending)} if ending.file else {}),
        }


def _within(ending: Ending) -> Mapping[str, object]:
    """Where in a file of the user's own it was."""
    text = ""
    with suppress(OSError, LearnBlockError):
        # Whoever has deleted it meanwhile knows why.
        lines = skill_files.read(Path(ending.file)).splitlines()
        text = "".join(lines[ending.file_line - 1 : ending.file_line]).strip()
    return {"file": ending.file, "line": ending.file_line, "text": text}


def _stage(client: Client) -> "Stage | None":
    from learnblock.robots.stage import Stage  # noqa: PLC0415 - the simulator takes its time

    return Stage.of(client)


def _no_effect(recorder: Recorder) -> tuple[Mapping[str, object], ...]:
    return tuple(
        {"skill": skill, "device": device, "times": times}
        for (skill, device), times in recorder.missed.items()
    )
