"""What checks and hints look at: the lines of a run's trace, its collisions and its report."""

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from itertools import pairwise
from typing import NamedTuple

from learnblock.evidence.trace_lines import Line, TraceLines, kind_of
from learnblock.running.report import Report
from learnblock.running.result import RunResult
from learnblock.runtime.recorder import Collision

_LARGEST_NUMBER = 1e9


class Moment(NamedTuple):
    """When something happened: its time, and its place among what happened at the same time."""

    time: float
    order: float


class TimedPose(NamedTuple):
    """Where a robot was, and when."""

    moment: Moment
    x: float
    y: float
    heading: float


def length_of(path: Sequence[TimedPose]) -> float:
    """The length of a way in mm."""
    steps = pairwise(path)
    return sum(math.hypot(after.x - before.x, after.y - before.y) for before, after in steps)


class Noted(NamedTuple):
    """A text, such as a printed line or a skill's name, and when it was noted."""

    moment: Moment
    text: str


@dataclass(frozen=True)
class Evidence:
    """The facts about a run, or about its part so far.

    Args:
        lines: the lines of the trace, in order; collisions, which are not in it, at the end.
        report: the report; None while the program runs.
        now: seconds of the robot's time.
        robot: the name of the robot that is looked at, among several.
        team: the reports of several robots, by their names.
    """

    lines: Sequence[Line]
    report: Report | None = None
    now: float = 0.0
    robot: str = ""
    team: Mapping[str, Report] = field(default_factory=dict)

    @property
    def has_ended(self) -> bool:
        """Whether the run is over."""
        return self.report is not None

    def of(self, robot: str) -> "Evidence":
        """The same run, looked at for another robot."""
        return replace(self, robot=robot, report=self.team.get(robot, self.report))

    @cached_property
    def path(self) -> Sequence[TimedPose]:
        """Where the robot was in its world, every 0.1 s, and at the end; none of a real robot."""
        places = [TimedPose(moment, *line["pose"]) for moment, line in self._of("pose")]
        # A real robot only knows where it is from its start.
        if places and self.report and self.report.pose:
            places.append(TimedPose(Moment(self.report.time, len(self.lines)), *self.report.pose))
        return places

    @cached_property
    def distance(self) -> float:
        """The mm that the robot drove, along its way."""
        return length_of(self.path)

    @cached_property
    def reached(self) -> Mapping[str, Moment]:
        """The goals that were reached, by name."""
        return self._goals("reached")

    @cached_property
    def failed(self) -> Mapping[str, Moment]:
        """The goals that can't be reached any more, by name."""
        return self._goals("failed")

    @cached_property
    def calls(self) -> Sequence[Noted]:
        """The skills that the program called."""
        return self._texts("call")

    @cached_property
    def prints(self) -> Sequence[Noted]:
        """The lines that the program printed."""
        return [
            Noted(moment, text)
            for moment, line in self._of("print")
            for text in line["print"].split("\n")
        ]

    @cached_property
    def sends(self) -> Sequence[Noted]:
        """The names of the messages that the program sent."""
        return self._texts("send")

    @cached_property
    def shows(self) -> Sequence[Noted]:
        """The emotions and texts that the robot showed."""
        return self._commands("show_emotion", "show_text", "text")

    @cached_property
    def emotions(self) -> Sequence[Noted]:
        """The emotions that the robot showed."""
        return self._commands("show_emotion")

    @cached_property
    def says(self) -> Sequence[Noted]:
        """The texts that the robot said."""
        return self._commands("say")

    @cached_property
    def collisions(self) -> Sequence[Noted]:
        """What the robot bumped into."""
        return self._texts("collision")

    @cached_property
    def game(self) -> Sequence[tuple[Moment, Line]]:
        """The lines about what happened to the robot in a game."""
        return self._of("game")

    @cached_property
    def keys(self) -> Sequence[tuple[float, Sequence[str]]]:
        """The keys that the program saw held, at each change."""
        return [(moment.time, line["keys"]) for moment, line in self._of("keys")]

    @cached_property
    def lines_run(self) -> frozenset[int]:
        """The lines of the program's Python that ran."""
        return frozenset(about["line"] for about in self.trace.steps() if self._fits("line", about))

    @cached_property
    def trace(self) -> TraceLines:
        """The lines, for those who look at many of them."""
        return self.lines if isinstance(self.lines, TraceLines) else TraceLines(self.lines)

    def _of(self, kind: str) -> Sequence[tuple[Moment, Line]]:
        """The well-formed lines of a kind that are about the robot."""
        return [
            (Moment(time, order), about)
            for order, time, about in self.trace.of_kind(kind)
            if self._fits(kind, about)
        ]

    def _fits(self, kind: str, about: Line) -> bool:
        """Whether a line is a well-formed one of this kind, about the robot."""
        is_ours = not self.robot or about.get("robot", self.robot) == self.robot
        return is_ours and kind_of(about) == kind and _SHAPES[kind](about[kind])

    def _texts(self, kind: str) -> Sequence[Noted]:
        return [Noted(moment, line[kind]) for moment, line in self._of(kind)]

    def _commands(self, *names: str) -> Sequence[Noted]:
        return [
            Noted(moment, line["args"][0])
            for moment, line in self._of("device")
            if line.get("do") in names and _is_text(line.get("args"))
        ]

    def _goals(self, state: str) -> Mapping[str, Moment]:
        moments: dict[str, Moment] = {}
        for order, time, line in self.trace.of_kind("goal"):
            # Whichever robot it was: they are the world's.
            if line.get("state") == state and _is_named(line["goal"]):
                moments.setdefault(line["goal"], Moment(time, order))
        return moments


def evidence_so_far(
    lines: TraceLines,
    now: float,
    report: Report | None = None,
    collisions: Mapping[str, Sequence[Collision]] | None = None,
    robot: str = "",
) -> Evidence:
    """The facts about a run, which may still go on in another thread.

    Args:
        lines: the lines of its trace.
        now: seconds of the robot's time.
        report: the report, when the run is over.
        collisions: those of recorders, by the robot's name; a single robot has none: "".
        robot: the name of the robot, among several.
    """
    collided = [
        _line(name, collision) for name, bumps in (collisions or {}).items() for collision in bumps
    ]
    return Evidence(lines.with_more(collided), report, now, robot)


def evidence_of(result: RunResult) -> Evidence:
    """The facts about a finished run."""
    lines = result.lines if isinstance(result.lines, TraceLines) else TraceLines(result.lines)
    lines.write(result.trace)
    reports = result.team or {result.robot: result.report}
    collisions = {name: report.collisions for name, report in reports.items()}
    evidence = evidence_so_far(lines, result.report.time, result.report, collisions, result.robot)
    return replace(evidence, team=reports)


def _line(robot: str, collision: Collision) -> Line:
    label = {"robot": robot} if robot else {}
    return {"t": collision.time, "collision": collision.thing, **label}


def _is_number(value: object) -> bool:
    return isinstance(value, int | float) and abs(value) < _LARGEST_NUMBER


def _is_pose(value: object) -> bool:
    return isinstance(value, list) and len(value) == 3 and all(map(_is_number, value))


def _is_named(value: object) -> bool:
    return isinstance(value, str)


def _is_names(value: object) -> bool:
    return isinstance(value, list | tuple) and all(map(_is_named, value))


def _is_text(arguments: object) -> bool:
    return isinstance(arguments, list) and bool(arguments) and isinstance(arguments[0], str)


#: Lines that are looked at, and whether they are well-formed: a run may have been tampered with.
_SHAPES: Mapping[str, Callable[[object], bool]] = {
    "call": _is_named,
    "collision": _is_named,
    "device": _is_named,
    "game": _is_named,
    "goal": _is_named,
    "keys": _is_names,
    "line": lambda value: isinstance(value, int),
    "pose": _is_pose,
    "print": _is_named,
    "send": _is_named,
}
