"""The report of a run on the command line: rows of a label and a value."""

from collections.abc import Iterator, Mapping

import click

from learnblock.cli.console import text
from learnblock.client import Goal
from learnblock.i18n import Phrase
from learnblock.language.check.robots import need_phrase
from learnblock.running import Report
from learnblock.runtime.ending import How

#: Characters of the longest label of the report, and the indent of a value's further lines.
LABEL = 10
#: Digits of a trace's hash in the report.
SHORT = 12
_NEW_LINE = "\n" + " " * (LABEL + 1)
#: How a run ended, by the names in the report's words.
_HOW = {How.FINISHED: "report-ended-finished", How.STOPPED: "report-ended-stopped"}
#: What became of a goal that has been decided.
_GOALS = {"reached": "report-goal-reached", "failed": "report-goal-failed"}


def short(trace_sha256: str) -> str:
    """As much of a trace's hash as a person compares; ``--json`` has all of it."""
    return trace_sha256[:SHORT]


def print_row(label: str, value: str) -> None:
    """Print a row of the report: the code of its label, and its value."""
    click.echo(f"{text(Phrase(label)):<{LABEL}} {text(value)}", err=True)


def ending_rows(report: Report, limit: float | None) -> Iterator[tuple[str, str]]:
    """The rows on how and when a program ended, and how far its robot has driven."""
    yield "report-label-ended", ending(report, limit)
    yield "report-label-time", f"{report.time:.2f} s"
    if report.distance is not None:
        yield "report-label-driven", f"{report.distance:.0f} mm"


def effect_rows(report: Report, robot: str) -> Iterator[tuple[str, str]]:
    """The rows on the emotions that a robot has shown, and the skills without effect."""
    if report.emotions:
        yield "report-label-shown", ", ".join(report.emotions)
    for missed in report.no_effect:
        reason = _missing_reason(robot, str(missed["device"]))
        yield "report-label-no-effect", f"{missed['skill']}: {text(reason)}"


def goal_row(goal: Goal) -> str:
    """A goal with its team and its state, as text."""
    name = f"{goal.name} ({goal.team})" if goal.team else goal.name
    if goal.time is None:
        return text(Phrase("report-goal-open", name=name))
    return text(Phrase(_GOALS[goal.state], name=name, time=decimal(goal.time)))


def decimal(number: float) -> Phrase:
    """A number with one decimal, without Fluent, which takes longer to load than many a run."""
    whole, _, tenths = f"{number:.1f}".partition(".")
    return Phrase("report-decimal", whole=whole, tenths=tenths)


def _missing_reason(robot: str, device: str) -> Phrase:
    """The reason why a skill that needs the device had no effect."""
    if device == "Detector:emotions":
        return Phrase("report-emotions-off", robot=robot)
    return Phrase("report-no-device", robot=robot, device=need_phrase(device))


def ending(report: Report, limit: float | None) -> str:
    """How a program ended, with the line where it failed.

    Args:
        report: its report.
        limit: the run's time limit in seconds, if it has one.
    """
    error = report.error
    if error is None:
        if report.ended == How.TIME_LIMIT and limit is not None:
            return text(Phrase("report-ended-time-limit", seconds=limit))
        return text(Phrase(_HOW.get(How(report.ended), "report-ended-otherwise")))
    place = f"{error['file']}:{error['line']}: " if error["line"] else ""
    message = error["message"]
    sentence = text(message) if isinstance(message, Phrase) else str(message)
    return text(f"{place}{sentence}{_quoted(error)}{_within(error.get('within'))}")


def _within(place: object) -> str:
    """The position in a file of the user's folder, shown below the program's line."""
    if not isinstance(place, Mapping):
        return ""
    return f"{_NEW_LINE}{place['file']}:{place['line']}{_quoted(place)}"


def _quoted(place: Mapping[str, object]) -> str:
    return f"{_NEW_LINE}{place['text']}" if place["text"] else ""
