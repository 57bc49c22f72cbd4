"""A run on the command line: a live status line, and a report at the end."""

import sys
from collections.abc import Callable, Collection, Iterator, Sequence
from contextlib import AbstractContextManager, ExitStack, contextmanager, nullcontext
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path
from time import monotonic
from typing import Any, BinaryIO, TypeVar

import click

from learnblock import running
from learnblock.cli.console import ExitCode, located, print_json, say, text, visible, warn
from learnblock.cli.interrupts import stopped_by_signals
from learnblock.cli.keyboard import (
    HeldKeys,
    NoKeys,
    RecordedKeyboard,
    listens_to_terminal,
    terminal_keyboard,
)
from learnblock.cli.report import decimal, effect_rows, ending_rows, goal_row, print_row, short
from learnblock.errors import Diagnostic, FileError, LearnBlockError
from learnblock.i18n import Phrase
from learnblock.project.files.programs import ProgramFile, opened
from learnblock.robots import RobotEntry
from learnblock.running import Job, Options, ProgramRun, Report, Source
from learnblock.running.program_run import Standing
from learnblock.running.recorded_keys import read_keys
from learnblock.running.shared_run import SharedRun, can_share
from learnblock.runtime.ending import How
from learnblock.runtime.log.keeping import RunLog
from learnblock.runtime.program import Program
from learnblock.runtime.standby import Standby
from learnblock.runtime.watcher import Watcher

Result = TypeVar("Result")

#: The limit of an endless program at full speed, in seconds of the robot's time.
DEFAULT_SECONDS = 300.0
#: Seconds of the wall clock between two updates of the status line.
STATUS_PERIOD = 0.1

EXIT_CODES = {
    How.ERROR: ExitCode.PROGRAM_FAILED,
    How.NO_CALL: ExitCode.PROGRAM_STOPPED,
    How.OUTPUT_LIMIT: ExitCode.PROGRAM_STOPPED,
    How.KILLED: ExitCode.PROGRAM_STOPPED,
    # Here, only a signal such as Ctrl-C stops a run.
    How.STOPPED: ExitCode.INTERRUPTED,
}


@dataclass(frozen=True, slots=True)
class PreparedProgram:
    """A program that can be run.

    Args:
        job: its run.
        source: what it was read from.
        keys: the keys that are pressed during the run.
    """

    job: Job
    source: Source
    keys: RecordedKeyboard | None = None


@contextmanager
def prepared(file: Path, *, as_json: bool, **choices: Any) -> Iterator[PreparedProgram | None]:
    """A program, read and checked; None, and a report, if it has mistakes."""
    with ExitStack() as stack:
        try:
            program_file = stack.enter_context(opened(file, warn))
        except FileError as error:
            if as_json:
                print_json(refused_report(str(file), error.diagnostics))
            raise
        yield _prepare(program_file, file, as_json=as_json, **choices)


def _prepare(
    program_file: ProgramFile,
    file: Path,
    *,
    robot: str | None,
    world: str | None,
    seed: int | None,
    variant: int | None,
    pace: str | None,
    seconds: float | None,
    keys: Path | None,
    anyway: bool,
    allow_network: bool,
    as_json: bool,
) -> PreparedProgram | None:
    source = program_file.source
    entry = running.choose_robot(source, robot or program_file.robot)
    if world is None and entry.load().lockstep:
        # A real robot is in the world where it is.
        world = program_file.world
    if errors := mistakes(source, entry, anyway=anyway, quiet=as_json):
        if as_json:
            print_json(refused_report(str(source.path), errors))
        return None
    program = replace(running.program(source, entry), tags=program_file.tags)
    recorded = RecordedKeyboard(read_keys(keys)) if keys else None
    if pace is None and not (recorded or as_json) and listens_to_terminal(program):
        # At full speed a run is over before a person has pressed a key.
        pace = "real"
    network = allow_network or running.may_use_network(file)
    limit = time_limit(pace, seconds)
    options = Options(world, seed, pace, limit, variant, network=network, anyway=anyway)
    entry.load().check_wishes(options.wishes)
    return PreparedProgram(Job(program, entry, options), source, recorded)


def run_and_report(
    file: Path,
    *,
    trace: Path | None,
    picture: Path | None,
    why: Path | None,
    as_json: bool,
    page: Path | None = None,
    pupil: str | None = None,
    standby: Standby | None = None,
    **choices: Any,
) -> int:
    """Run a program, print the report, and return the exit code.

    Args:
        file: the program.
        trace: the file for its trace.
        picture: the file for the drawing of the run.
        why: the file for its log.
        as_json: print the report as JSON.
        page: the file for a page that shows the run.
        pupil: who made it, if that page is to say so.
        standby: the process for the program, if it has been started before.
        choices: the options of the run.
    """
    with prepared(file, as_json=as_json, **choices) as program:
        if program is None:
            return ExitCode.MISTAKES
        check_picture(picture)
        log = _log(program.job.program, why) if why or page else None
        code = _run_prepared(program, trace, picture, log, standby, as_json=as_json)
        if page and log:
            from learnblock.cli.take_home import robot_run, write_page  # noqa: PLC0415 - slow to load

            source = program.source
            run = robot_run(source, program.job.robot, log)
            write_page(page, [run], source.path.stem, pupil)
        return code


def _log(program: Program, path: Path | None) -> RunLog:
    """A log in memory, and in a file, or in a folder under the program's name."""
    if path and path.is_dir():
        path /= f"{Path(program.name).stem}.why"
    return RunLog(program, path)


def say_if_not_whole(log: RunLog) -> None:
    """Say why a log's file ends too early, if it does."""
    if log.failure:
        say("report-why-not-whole", reason=log.failure, err=True)


def _run_prepared(
    program: PreparedProgram,
    trace: Path | None,
    picture: Path | None,
    log: RunLog | None,
    standby: Standby | None,
    *,
    as_json: bool,
) -> int:
    with opened_trace(trace) as trace_file, _keyboard(program, as_json=as_json) as keyboard:
        watcher = Collector(keyboard) if as_json else _Terminal(keyboard)
        offset = 0
        if not (picture or log) and (job := _shared(program, keyboard, trace_file)):
            if standby:
                standby.end()
            shared = watcher.session = SharedRun(job, watcher)
            if result := _watched(shared.run, shared.stop, watcher):
                if trace_file:
                    trace_file.write(result.trace)
                return _reported(result.report, program.job, watcher, as_json=as_json)
            # It is made again, and prints the same again.
            standby, offset = None, shared.shown
        session = ProgramRun(
            program.job,
            trace=trace_file,
            watcher=watcher,
            log=log,
            lacking=partial(running.lacking, program.source),
            standby=standby,
        )
        watcher.session = session
        watcher.skip(offset)
        report = _watched(session.run, session.stop, watcher)
        code = _reported(report, program.job, watcher, as_json=as_json)
    if picture:
        _draw(session, picture)
        print_row("report-label-picture", str(picture))
    if log:
        say_if_not_whole(log)
    return code


def _watched(run: Callable[[], Result], stop: Callable[[], object], watcher: "Collector") -> Result:
    """Make a run, which signals stop."""
    with stopped_by_signals(stop):
        result = run()
    watcher.clear()
    return result


def _reported(report: Report, job: Job, watcher: "Collector", *, as_json: bool) -> int:
    """Print the report of a run, and return the exit code."""
    _print(replace(report, output=watcher.output), job, as_json=as_json)
    return EXIT_CODES.get(How(report.ended), ExitCode.WELL)


def _shared(program: PreparedProgram, keyboard: HeldKeys, trace: BinaryIO | None) -> Job | None:
    """The run in one process for host and program; None if that isn't possible."""
    if not isinstance(keyboard, NoKeys):
        # A person presses keys meanwhile.
        return None
    keys = program.keys.keys if program.keys else None
    job = replace(program.job, keys=keys, with_trace=trace is not None)
    return job if can_share(job) else None


def _keyboard(program: PreparedProgram, *, as_json: bool) -> AbstractContextManager[HeldKeys]:
    """The keyboard of a run; one whose output is for a script does not listen to the terminal."""
    if program.keys or as_json:
        return nullcontext(program.keys or NoKeys())
    return terminal_keyboard(program.job.program)


def demonstrate(picture: Path) -> int:
    """Run the demonstration, and return the exit code."""
    say("report-demo")
    click.echo()
    return run_and_report(
        running.example("tags.bt"),
        robot="sim-ebo",
        world="tags",
        seed=0,
        variant=None,
        pace="free",
        seconds=62,
        trace=None,
        why=None,
        picture=picture,
        keys=None,
        anyway=False,
        allow_network=False,
        as_json=False,
    )


def ask(prompt: str) -> str | None:
    """Ask the person for a line; None if there will be no more."""
    click.echo(text(prompt), nl=False)
    line = sys.stdin.readline()
    return line.removesuffix("\n") if line else None


class Collector(Watcher):
    """A listener that keeps the prints for the report.

    Args:
        keyboard: has the keys that the program finds held down.
    """

    #: The run whose prints are kept.
    session: ProgramRun | SharedRun | None = None

    def __init__(self, keyboard: HeldKeys | None = None) -> None:
        self._parts: list[str] = []
        self._skipped = 0
        self.keyboard = keyboard or NoKeys()

    @property
    def output(self) -> str:
        """All that the program has printed."""
        return "".join(self._parts)

    def held_keys(self, time: float) -> Collection[str]:
        return self.keyboard.held(time)

    def skip(self, characters: int) -> None:
        """Leave out the next characters that are printed: they are here already."""
        self._skipped = characters

    def printed(self, text: str) -> None:
        self._parts.append(self._new(text))

    def _new(self, text: str) -> str:
        new = text[self._skipped :]
        self._skipped -= len(text) - len(new)
        return new

    def clear(self) -> None:
        """Leave the terminal as it is."""


class _Terminal(Collector):
    """A listener that shows output at once and, on a terminal, a line with the state of the run."""

    def __init__(self, keyboard: HeldKeys) -> None:
        super().__init__(keyboard)
        self._drawn = monotonic()
        self._started = self._drawn
        self._live = sys.stderr.isatty()

    def printed(self, text: str) -> None:
        self.clear()
        click.echo(visible(self._new(text)), nl=False)

    def input(self, prompt: str) -> str | None:
        self.clear()
        with self.keyboard.typing():
            return ask(prompt)

    def tick(self) -> None:
        now = monotonic()
        if self._live and self.session and now - self._drawn > STATUS_PERIOD:
            self._drawn = now
            click.echo(f"\r\x1b[K{self._status(self.session.standing, now)}", nl=False, err=True)

    def clear(self) -> None:
        if self._live:
            click.echo("\r\x1b[K", nl=False, err=True)

    def _status(self, standing: Standing | None, now: float) -> str:
        if standing is None:
            return text(Phrase("report-connecting"))
        parts = [f"{standing.time:7.1f} s"]
        if pose := standing.pose:
            parts.append("({:.0f}, {:.0f}) mm  {:.0f}°".format(*pose))
        if standing.emotion:
            parts.append(standing.emotion)
        speed = standing.time / max(now - self._started, 0.001)
        parts.append(text(Phrase("report-speed", factor=decimal(speed))))
        return visible("  ".join(parts))


def mistakes(source: Source, entry: RobotEntry, *, anyway: bool, quiet: bool) -> list[Diagnostic]:
    """Check a program and print the result; return the errors that prevent its run.

    Args:
        source: the program.
        entry: the robot.
        anyway: whether it may run on a robot that lacks a device.
        quiet: whether to print nothing.
    """
    diagnostics = running.check(source, entry)
    for diagnostic in () if quiet else diagnostics:
        click.echo(located(str(source.path), diagnostic), err=True)
    return [
        diagnostic
        for diagnostic in diagnostics
        if diagnostic.severity == "error" and not (anyway and diagnostic.code == "missing-device")
    ]


def refused_report(filename: str, errors: Sequence[Diagnostic]) -> Report:
    """The report of a program that was not started."""
    first = errors[0]
    error = {
        "message": str(first.message),
        "code": first.code,
        "file": filename,
        "line": first.line,
        "all": [error.located(filename) for error in errors],
    }
    return Report(ended="refused", error=error)


def time_limit(pace: str | None, seconds: float | None) -> float | None:
    """The seconds after which a run ends: at full speed an endless program has to end, too."""
    if seconds is not None:
        return seconds
    return DEFAULT_SECONDS if pace in (None, "free") else None


def check_picture(picture: Path | None) -> None:
    """Refuse a picture in a format that can't be drawn.

    Raises:
        LearnBlockError: it is neither .png nor .svg.
    """
    if picture and picture.suffix not in {".png", ".svg"}:
        raise LearnBlockError("report-picture-format", file=str(picture))


@contextmanager
def opened_trace(path: Path | None) -> Iterator[BinaryIO | None]:
    """The file of the trace, open to be written, if there is one."""
    with path.open("wb") if path else nullcontext() as file:
        yield file


def _draw(session: ProgramRun, path: Path) -> None:
    if session.client is None or session.recorder is None:
        raise LearnBlockError("report-no-picture")
    from learnblock.robots.simulated import draw  # noqa: PLC0415 - only a simulated world is drawn

    conditions = session.client.conditions()
    title = (
        f"{session.program.name} on {session.job.robot.name},"
        f" world {conditions['world']}, seed {conditions['seed']}"
    )
    if variant := conditions.get("variant"):
        title += f", variant {variant}"
    draw({"robot": (session.client, session.recorder)}, path, title)


def _print(report: Report, job: Job, *, as_json: bool) -> None:
    if as_json:
        print_json(report)
        return
    for label, value in _rows(report, job):
        print_row(label, value)


def _rows(report: Report, job: Job) -> Iterator[tuple[str, str]]:
    """The rows of the report: the code of the label, and the value."""
    yield from ending_rows(report, job.options.seconds)
    for goal in report.goals:
        yield "report-label-goal", goal_row(goal)
    yield from effect_rows(report, job.robot.name)
    if report.trace_sha256:
        yield "report-label-trace", short(report.trace_sha256)
