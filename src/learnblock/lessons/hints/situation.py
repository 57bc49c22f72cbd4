"""What rules look at: a program, its run and the checks that fail, seen together."""

from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

from learnblock.evidence.evidence import Evidence
from learnblock.language.python.generation import PythonText, to_python
from learnblock.language.tree.extents import NOWHERE
from learnblock.language.tree.flow import is_loop, is_waiting
from learnblock.language.tree.nodes import (
    Blank,
    Body,
    Branch,
    Break,
    Call,
    Comment,
    Else,
    Expression,
    If,
    Item,
    Main,
    Pass,
    Program,
    Return,
    SkillCall,
)
from learnblock.language.tree.traversal import all_expressions, statements, within
from learnblock.lessons.hints.vocabulary import WAITING
from learnblock.lessons.judging import Verdict
from learnblock.lessons.lesson import Step
from learnblock.lessons.structure import every_statement
from learnblock.simulator import WorldDescription

NOTHING = (Blank, Comment, Pass)


@dataclass(frozen=True)
class CallRun:
    """A skill's call in the run.

    Args:
        time: when, in seconds of the robot's time.
        skill: its name.
        arguments: what it was given.
        line: the line of the program, from 1; 0 if unknown.
    """

    time: float
    skill: str
    arguments: tuple[Any, ...]
    line: int


@dataclass(frozen=True)
class TextRun:
    """Something that was printed, said or shown in the run.

    Args:
        kind: ``print``, ``say`` or ``show``.
        text: the text, or the emotion.
        line: the line of the program, from 1; 0 if unknown.
    """

    kind: str
    text: str
    line: int


_KINDS = {"say": "say", "show_emotion": "show", "show_text": "show", "text": "show"}


@dataclass(frozen=True)
class Elsewhere:
    """How the program did in the other attempts.

    Args:
        is_variant: whether this attempt is in a variant of the world.
        is_other_robot: whether it is not on the usual robot.
        passes_usually: whether all checks are met on the usual robot in the world as it is.
    """

    is_variant: bool = False
    is_other_robot: bool = False
    passes_usually: bool = False


@dataclass(frozen=True)
class Situation:
    """A program that fails checks.

    Args:
        step: the step.
        program: the program.
        verdicts: of its checks.
        evidence: what is known of its run; None if it was not run.
        world: the world.
        elsewhere: how it did in other attempts.
    """

    step: Step
    program: Program
    verdicts: Sequence[Verdict]
    evidence: Evidence | None = None
    world: WorldDescription | None = None
    elsewhere: Elsewhere = Elsewhere()

    @cached_property
    def failed(self) -> tuple[Verdict, ...]:
        """The checks that fail, those that the step needs first."""
        failed = [verdict for verdict in self.verdicts if verdict.state == "failed"]
        return tuple(sorted(failed, key=lambda verdict: (verdict.check.optional, verdict.index)))

    # The program.

    @cached_property
    def statements(self) -> tuple[Item | Main, ...]:
        """Every statement, in the order of the source."""
        return tuple(every_statement(self.program))

    @cached_property
    def loops(self) -> tuple[Any, ...]:
        """Every loop, in the order of the source."""
        return tuple(node for node in self.statements if is_loop(node))

    @cached_property
    def skills(self) -> frozenset[str]:
        """The skills that the program calls."""
        return frozenset(
            call.name for node in self.statements for call in calls_in(node, SkillCall)
        )

    def waits(self, body: Body) -> bool:
        """Whether time passes in some statements, or in the functions that they call."""
        return self._waits(body, frozenset())

    def _waits(self, body: Body, inside: frozenset[str]) -> bool:
        for statement in statements(body):
            if is_waiting(statement):
                return True
            if any(call.name in WAITING for call in calls_in(statement, SkillCall)):
                return True
            for call in calls_in(statement, Call):
                function = self.program.functions.get(call.name)
                inner = inside | {call.name}
                if function and call.name not in inside and self._waits(function.body, inner):
                    return True
        return False

    # The run.

    @cached_property
    def python(self) -> PythonText:
        """The program's Python, whose lines the run shows."""
        return to_python(self.program)

    def ran(self, node: Any) -> bool:
        """Whether a statement ran."""
        if self.evidence is None:
            return False
        return self.python.extents.get(id(node), NOWHERE)[0] in self.evidence.lines_run

    def body_ran(self, body: Body) -> bool:
        """Whether some statement of a body ran."""
        return any(self.ran(node) for node in body if not isinstance(node, NOTHING))

    @cached_property
    def _run(self) -> tuple[tuple[CallRun, ...], tuple[TextRun, ...], Counter[int]]:
        calls: list[CallRun] = []
        texts: list[TextRun] = []
        times_run: Counter[int] = Counter()
        line = 0
        # A loop that asks a sensor calls it many times at once: such calls are equal.
        same: dict[tuple[float, int, int], CallRun] = {}
        for time, about in self._timed():
            if isinstance(about.get("line"), int):
                line = self._source_line(about["line"])
                times_run[line] += 1
            elif isinstance(about.get("call"), str):
                key = (time, id(about), line)
                if (call := same.get(key)) is None:
                    arguments = tuple(about.get("args", ()))
                    call = same[key] = CallRun(time, about["call"], arguments, line)
                calls.append(call)
            else:
                texts += [TextRun(kind, text, line) for kind, text in _texts(about)]
        return tuple(calls), tuple(texts), times_run

    def _timed(self) -> Iterator[tuple[float, Mapping[str, Any]]]:
        """What happened to the robot, and when."""
        if self.evidence is None:
            return iter(())
        robot, lines = self.evidence.robot, self.evidence.trace.timed()
        if not robot:
            return lines
        return (line for line in lines if line[1].get("robot", "") == robot)

    def _source_line(self, number: int) -> int:
        """The line of the program of a line of its Python; 0 if it has none."""
        lines = self._source_lines
        if number not in lines:
            lines[number] = self.python.source_map.source_line(number) or 0
        return lines[number]

    @cached_property
    def _source_lines(self) -> dict[int, int]:
        return {}

    @property
    def calls(self) -> tuple[CallRun, ...]:
        """The calls of skills, in order."""
        return self._run[0]

    @property
    def texts(self) -> tuple[TextRun, ...]:
        """What was printed, said and shown, in order."""
        return self._run[1]

    @property
    def times_run(self) -> Counter[int]:
        """How often each line of the program ran."""
        return self._run[2]

    @property
    def end(self) -> float:
        """When the program ended, in seconds of the robot's time."""
        return self.evidence.now if self.evidence else 0.0

    @property
    def ended(self) -> str:
        """How the program ended; "" if it did not."""
        report = self.evidence.report if self.evidence else None
        return str(report.ended) if report else ""


def _texts(entry: Mapping[str, Any]) -> Iterator[tuple[str, str]]:
    if isinstance(entry.get("print"), str):
        yield from (("print", text) for text in entry["print"].split("\n"))
    elif entry.get("do") in _KINDS:
        arguments = entry.get("args")
        if isinstance(arguments, list) and arguments and isinstance(arguments[0], str):
            yield _KINDS[entry["do"]], arguments[0]


def calls_in(node: Any, kind: type[Any]) -> Iterator[Any]:
    """The calls in a statement, without its bodies."""
    return (inner for inner in all_expressions(node) if isinstance(inner, kind))


def asked_in(expression: Expression) -> Iterator[SkillCall]:
    """The skills that an expression asks."""
    for inner in within(expression):
        if isinstance(inner, SkillCall):
            yield inner


def skills_in(body: Body) -> Iterator[SkillCall]:
    """The calls of skills in some statements, including their bodies."""
    for statement in statements(body):
        yield from calls_in(statement, SkillCall)


def parts(node: If) -> Iterator[Branch | Else]:
    """The branches of an `If`."""
    yield from node.branches
    if node.otherwise is not None:
        yield node.otherwise


def first_line(body: Body) -> int:
    """The line of the first statement of a body."""
    return next((node.span.line for node in body if not isinstance(node, NOTHING)), 0)


def can_leave(body: Body) -> bool:
    """Whether a body has a statement that leaves its loop."""
    return any(isinstance(node, Break | Return) for node in statements(body))


def is_empty(body: Body) -> bool:
    """Whether a body does nothing."""
    return all(isinstance(node, NOTHING) for node in body)
