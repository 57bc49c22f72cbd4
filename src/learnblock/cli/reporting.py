"""A run on the command line: a live status line, and a report at the end."""

import signal
import sys
from collections.abc import Iterator, Mapping, Sequence
from contextlib import ExitStack, contextmanager, nullcontext
from dataclasses import replace
from pathlib import Path
from time import monotonic
from types import FrameType
from typing import Any, BinaryIO

import click

from learnblock import running
from learnblock.cli.console import ExitCode, located, print_json, say, text
from learnblock.cli.project_files import ProgramFile, opened
from learnblock.client import Goal
from learnblock.devices import DEFAULT_KEY
from learnblock.errors import Diagnostic, FileError, LearnBlockError
from learnblock.i18n import Phrase
from learnblock.robots import RobotEntry
from learnblock.running import Options, ProgramRun, Report, Source
from learnblock.runtime.ending import How
from learnblock.runtime.watcher import Watcher

#: The limit of an endless program at full speed, in seconds of the robot's time.
DEFAULT_SECONDS = 300.0
#: Seconds of the wall clock between two updates of the status line.
STATUS_PERIOD = 0.1

#: Characters of the longest label of the report, and the indent of a value's further lines.
_LABEL = 10
_NEW_LINE = "\n" + " " * (_LABEL + 1)
#: How a run ended, by the names in the report's words.
_HOW = {How.FINISHED: "finished", How.STOPPED: "stopped"}

_EXIT_CODES = {
    How.ERROR: ExitCode.PROGRAM_FAILED,
    How.NO_CALL: ExitCode.PROGRAM_STOPPED,
    How.OUTPUT_LIMIT: ExitCode.PROGRAM_STOPPED,
    How.KILLED: ExitCode.PROGRAM_STOPPED,
    # Here, only a signal such as Ctrl-C stops a run.
    How.STOPPED: ExitCode.INTERRUPTED,
}


def run_and_report(
    file: Path,
    *,
    as_json: bool,
    **choices: Any,
) -> int:
    """Run a program, print the report, and return the exit code."""
    with ExitStack() as stack:
        try:
            found = stack.enter_context(opened(file))
        except FileError as error:
            if as_json:
                print_json(_refused_report(str(file), error.diagnostics))
            raise
        return _run_found(found, file, as_json=as_json, **choices)


def _run_found(
    found: ProgramFile,
    file: Path,
    *,
    robot: str | None,
    world: str | None,
    seed: int | None,
    pace: str | None,
    seconds: float | None,
    trace: Path | None,
    picture: Path | None,
    anyway: bool,
    allow_network: bool,
    as_json: bool,
) -> int:
    source = found.source
    entry = running.choose_robot(source, robot or found.robot)
    if world is None and entry.load().lockstep:
        # A real robot is in the world where it is.
        world = found.world
    if _refused(source, entry, anyway=anyway, as_json=as_json):
        return ExitCode.MISTAKES
    if picture and picture.suffix not in {".png", ".svg"}:
        raise LearnBlockError("report-picture-format", file=str(picture))
    network = allow_network or running.may_use_network(file)
    options = Options(world, seed, pace, _time_limit(pace, seconds), network=network)
    entry.load().check_wishes(options.wishes)
    program = replace(running.program(source, entry), tags=found.tags)
    with _opened(trace) as trace_file:
        watcher = _Collector() if as_json else _Terminal()
        session = ProgramRun(program, entry, options, trace=trace_file, watcher=watcher)
        watcher.session = session
        report = _run(session)
        watcher.clear()
    _print(replace(report, output=watcher.output), session, as_json=as_json)
    if picture:
        _draw(session, picture)
        _print_row("report-label-picture", str(picture))
    return _EXIT_CODES.get(How(report.ended), ExitCode.WELL)


def demonstrate(picture: Path) -> int:
    """Run the demonstration, and return the exit code."""
    say("report-demo")
    click.echo()
    return run_and_report(
        running.example("tags.bt"),
        robot="sim-ebo",
        world="tags",
        seed=0,
        pace="free",
        seconds=62,
        trace=None,
        picture=picture,
        anyway=False,
        allow_network=False,
        as_json=False,
    )


class _Collector(Watcher):
    """A listener that keeps the prints for the report."""

    #: The run whose prints are kept.
    session: ProgramRun | None = None

    def __init__(self) -> None:
        self.output = ""

    def printed(self, text: str) -> None:
        self.output += text

    def clear(self) -> None:
        """Leave the terminal as it is."""


class _Terminal(_Collector):
    """A listener that shows output at once and, on a terminal, a line with the state of the run."""

    def __init__(self) -> None:
        super().__init__()
        self._drawn = monotonic()
        self._started = self._drawn
        self._live = sys.stderr.isatty()

    def printed(self, text: str) -> None:
        self.clear()
        click.echo(text, nl=False)

    def input(self, prompt: str) -> str | None:
        self.clear()
        click.echo(prompt, nl=False)
        line = sys.stdin.readline()
        return line.removesuffix("\n") if line else None

    def tick(self) -> None:
        now = monotonic()
        if self._live and self.session and now - self._drawn > STATUS_PERIOD:
            self._drawn = now
            click.echo(f"\r\x1b[K{self._status(self.session, now)}", nl=False, err=True)

    def clear(self) -> None:
        if self._live:
            click.echo("\r\x1b[K", nl=False, err=True)

    def _status(self, session: ProgramRun, now: float) -> str:
        recorder, client = session.recorder, session.client
        if recorder is None or client is None:
            return text(Phrase("report-connecting"))
        parts = [f"{recorder.time():7.1f} s"]
        if pose := client.where():
            parts.append("({:.0f}, {:.0f}) mm  {:.0f}°".format(*pose))
        if recorder.emotions:
            parts.append(recorder.emotions[-1])
        speed = recorder.time() / max(now - self._started, 0.001)
        parts.append(text(Phrase("report-speed", factor=round(speed, 1))))
        return "  ".join(parts)


def _refused(source: Source, entry: RobotEntry, *, anyway: bool, as_json: bool) -> bool:
    """Print the diagnostics of the check; return whether they prevent the run."""
    diagnostics = running.check(source, entry)
    errors = [
        one
        for one in diagnostics
        if one.severity == "error" and not (anyway and one.code == "missing-device")
    ]
    if as_json and errors:
        print_json(_refused_report(str(source.path), errors))
    elif not as_json:
        for one in diagnostics:
            click.echo(located(str(source.path), one), err=True)
    return bool(errors)


def _refused_report(filename: str, errors: Sequence[Diagnostic]) -> Report:
    first = errors[0]
    error = {
        "message": str(first.message),
        "code": first.code,
        "file": filename,
        "line": first.line,
        "all": [one.located(filename) for one in errors],
    }
    return Report(ended="refused", error=error)


def _time_limit(pace: str | None, seconds: float | None) -> float | None:
    if seconds is not None:
        return seconds
    return DEFAULT_SECONDS if pace in (None, "free") else None


@contextmanager
def _opened(path: Path | None) -> Iterator[BinaryIO | None]:
    with path.open("wb") if path else nullcontext() as file:
        yield file


def _run(session: ProgramRun) -> Report:
    """Run, and write a report even after Ctrl-C or SIGTERM."""

    def stop(number: int, frame: FrameType | None) -> None:  # noqa: ARG001
        session.stop()

    before = {number: signal.signal(number, stop) for number in (signal.SIGINT, signal.SIGTERM)}
    try:
        return session.run()
    finally:
        for number, handler in before.items():
            signal.signal(number, handler)


def _draw(session: ProgramRun, path: Path) -> None:
    if session.client is None or session.recorder is None:
        raise LearnBlockError("report-no-picture")
    from learnblock.robots.simulated import draw  # noqa: PLC0415 - only a simulated world is drawn

    conditions = session.client.conditions()
    title = (
        f"{session.program.name} on {session.robot.name},"
        f" world {conditions['world']}, seed {conditions['seed']}"
    )
    draw(session.client, session.recorder, path, title)


def _print(report: Report, session: ProgramRun, *, as_json: bool) -> None:
    if as_json:
        print_json(report)
        return
    for label, value in _rows(report, session):
        _print_row(label, value)


def _print_row(label: str, value: str) -> None:
    click.echo(f"{text(Phrase(label)):<{_LABEL}} {value}", err=True)


def _rows(report: Report, session: ProgramRun) -> Iterator[tuple[str, str]]:
    """The rows of the report: the code of the label, and the value."""
    yield "report-label-ended", _ending(report, session)
    yield "report-label-time", f"{report.time:.2f} s"
    if report.distance is not None:
        yield "report-label-driven", f"{report.distance:.0f} mm"
    for goal in report.goals:
        yield "report-label-goal", _goal(goal)
    if report.emotions:
        yield "report-label-shown", ", ".join(report.emotions)
    for missed in report.no_effect:
        reason = _reason(session.robot.name, str(missed["device"]))
        yield "report-label-no-effect", f"{missed['skill']}: {text(reason)}"
    yield "report-label-trace", report.trace_sha256


def _goal(goal: Goal) -> str:
    if goal.time is None:
        return text(Phrase("report-goal", name=goal.name, state=goal.state))
    time = round(goal.time, 1)
    return text(Phrase("report-goal-at", name=goal.name, state=goal.state, time=time))


def _reason(robot: str, device: str) -> Phrase:
    """The reason why a skill that needs the device had no effect."""
    if device == "Detector:emotions":
        return Phrase("report-emotions-off", robot=robot)
    return Phrase("report-no-device", robot=robot, device=device.removesuffix(f":{DEFAULT_KEY}"))


def _ending(report: Report, session: ProgramRun) -> str:
    error = report.error
    if error is None:
        limit = session.options.seconds
        if report.ended == How.TIME_LIMIT and limit is not None:
            return text(Phrase("report-ended-time-limit", seconds=limit))
        return text(Phrase("report-ended", how=_HOW.get(How(report.ended), "other")))
    place = f"{error['file']}:{error['line']}: " if error["line"] else ""
    message = error["message"]
    shown = text(message) if isinstance(message, Phrase) else str(message)
    return f"{place}{shown}{_quoted(error)}{_within(error.get('within'))}"


def _within(place: object) -> str:
    """The position in a file of the user's folder, shown below the program's line."""
    if not isinstance(place, Mapping):
        return ""
    return f"{_NEW_LINE}{place['file']}:{place['line']}{_quoted(place)}"


def _quoted(place: Mapping[str, object]) -> str:
    return f"{_NEW_LINE}{place['text']}" if place["text"] else ""
