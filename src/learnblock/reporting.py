"""The command line's run: a live status line, and at the end what happened."""

import dataclasses
import signal
import sys
from collections.abc import Iterator
from contextlib import contextmanager, nullcontext
from pathlib import Path
from time import monotonic
from types import FrameType
from typing import Any, BinaryIO

import click

from learnblock import running
from learnblock.console import ExitCode, print_json
from learnblock.devices import DEFAULT_KEY
from learnblock.errors import Diagnostic, LearnBlockError
from learnblock.robots import RobotEntry
from learnblock.running import Options, Report, Session, Source
from learnblock.runtime.ending import How
from learnblock.runtime.watcher import Watcher

#: A program that never ends, at full speed, needs an end: seconds of the robot's time.
DEFAULT_SECONDS = 300.0
#: Seconds of the wall clock between two states of the status line.
STATUS_PERIOD = 0.1

_EXIT_CODES = {
    How.ERROR: ExitCode.PROGRAM_FAILED,
    How.NO_CALL: ExitCode.PROGRAM_STOPPED,
    How.OUTPUT_LIMIT: ExitCode.PROGRAM_STOPPED,
    How.KILLED: ExitCode.PROGRAM_STOPPED,
    # Nothing but a signal, such as that of Ctrl-C, stops a run from here.
    How.STOPPED: ExitCode.INTERRUPTED,
}


def run_and_report(
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
    as_json: bool,
) -> int:
    """Run a program and print what happened; answer the exit code."""
    source = running.read(file)
    entry = running.choose_robot(source, robot)
    if _refused(source, entry, anyway=anyway, as_json=as_json):
        return ExitCode.MISTAKES
    if picture and picture.suffix not in {".png", ".svg"}:
        raise LearnBlockError(f"a picture is a .png or a .svg file, not {picture}")
    options = Options(world, seed, pace, _time_limit(pace, seconds))
    entry.load().check_wishes(options.wishes)
    with _opened(trace) as trace_file:
        terminal = None if as_json else _Terminal()
        session = Session(
            running.program(source, entry), entry, options, trace=trace_file, watcher=terminal
        )
        if terminal:
            terminal.session = session
        report = _run(session)
        if terminal:
            terminal.clear()
    _print(report, session, as_json=as_json)
    if picture:
        _draw(session, picture)
        click.echo(f"picture    {picture}", err=True)
    return _EXIT_CODES.get(How(report.ended), ExitCode.WELL)


def demonstrate(picture: Path) -> int:
    """Run the demonstration; answer the exit code."""
    click.echo("EBO's twin looks for tags by camera, drives up to each, and shows a feeling.\n")
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
        as_json=False,
    )


class _Terminal(Watcher):
    """Shows prints as they come, and on a terminal one line with the state of things."""

    #: What it tells the state of.
    session: Session | None = None

    def __init__(self) -> None:
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

    def _status(self, session: Session, now: float) -> str:
        recorder, client = session.recorder, session.client
        if recorder is None or client is None:
            return "connecting"
        parts = [f"{recorder.time():7.1f} s"]
        if pose := client.where():
            parts.append("({:.0f}, {:.0f}) mm  {:.0f}°".format(*pose))
        if recorder.emotions:
            parts.append(recorder.emotions[-1])
        parts.append(f"{recorder.time() / max(now - self._started, 0.001):.1f} x real time")
        return "  ".join(parts)


def _refused(source: Source, entry: RobotEntry, *, anyway: bool, as_json: bool) -> bool:
    """Print what the check finds; say whether the program cannot be run."""
    diagnostics = running.check(source, entry)
    errors = [
        one
        for one in diagnostics
        if one.severity == "error" and not (anyway and one.code == "missing-device")
    ]
    if as_json and errors:
        refused = Report(ended="refused", error=_refusal(str(source.path), errors))
        print_json(dataclasses.asdict(refused))
    elif not as_json:
        for one in diagnostics:
            click.echo(one.located(str(source.path)), err=True)
    return bool(errors)


def _refusal(filename: str, errors: list[Diagnostic]) -> dict[str, object]:
    first = errors[0]
    return {
        "message": first.message,
        "code": first.code,
        "file": filename,
        "line": first.line,
        "all": [one.located(filename) for one in errors],
    }


def _time_limit(pace: str | None, seconds: float | None) -> float | None:
    if seconds is not None:
        return seconds
    return DEFAULT_SECONDS if pace in (None, "free") else None


@contextmanager
def _opened(path: Path | None) -> Iterator[BinaryIO | None]:
    with path.open("wb") if path else nullcontext() as file:
        yield file


def _run(session: Session) -> Report:
    """Run; Ctrl-C and SIGTERM stop the robot and still give the report."""

    def stop(number: int, frame: FrameType | None) -> None:  # noqa: ARG001
        session.stop()

    before = {number: signal.signal(number, stop) for number in (signal.SIGINT, signal.SIGTERM)}
    try:
        return session.run()
    finally:
        for number, handler in before.items():
            signal.signal(number, handler)


def _draw(session: Session, path: Path) -> None:
    if session.client is None or session.recorder is None:
        raise LearnBlockError("there is no picture: the program made no robot")
    from learnblock.robots.simulated import draw  # noqa: PLC0415 - only a simulated world is drawn

    conditions = session.client.conditions()
    title = (
        f"{session.program.name} on {session.robot.name},"
        f" world {conditions['world']}, seed {conditions['seed']}"
    )
    draw(session.client, session.recorder, path, title)


def _print(report: Report, session: Session, *, as_json: bool) -> None:
    if as_json:
        print_json(dataclasses.asdict(report))
        return
    for line in _summary(report, session):
        click.echo(line, err=True)


def _summary(report: Report, session: Session) -> Iterator[str]:
    yield f"{'ended':<10} {_ending(report, session)}"
    yield f"{'time':<10} {report.time:.2f} s"
    if report.distance is not None:
        yield f"{'driven':<10} {report.distance:.0f} mm"
    for goal in report.goals:
        when = f" at {goal.time:.1f} s" if goal.time is not None else ""
        yield f"{'goal':<10} {goal.name}: {goal.state}{when}"
    if report.emotions:
        yield f"{'shown':<10} {', '.join(report.emotions)}"
    for missed in report.no_effect:
        reason = _reason(session.robot.name, str(missed["device"]))
        yield f"{'no effect':<10} {missed['skill']}: {reason}"
    yield f"{'trace':<10} {report.trace_sha256}"


def _reason(robot: str, device: str) -> str:
    """Why a skill had no effect that would have needed the device."""
    if device == "Detector:emotions":
        return f"emotions are not recognised on {robot}'s camera: `learnblock perception` says more"
    return f"{robot} has no {device.removesuffix(f':{DEFAULT_KEY}')}"


def _ending(report: Report, session: Session) -> str:
    if report.error is None:
        limit = session.options.seconds
        if report.ended == How.TIME_LIMIT:
            return f"at the time limit of {limit:g} s (another: --for SECONDS)"
        return report.ended
    place = f"{report.error['file']}:{report.error['line']}: " if report.error["line"] else ""
    quoted = f"\n           {report.error['text']}" if report.error["text"] else ""
    return f"{place}{report.error['message']}{quoted}{_within(report.error.get('within'))}"


def _within(place: Any) -> str:
    """Where in a file of the user's own it was, below the line of the program."""
    if not place:
        return ""
    quoted = f"\n           {place['text']}" if place["text"] else ""
    return f"\n           in {place['file']}:{place['line']}{quoted}"
