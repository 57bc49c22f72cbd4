"""Find what never runs, and what never ends without doing anything."""

from collections.abc import Callable, Mapping
from types import MappingProxyType
from typing import Any

from learnblock.i18n import Phrase
from learnblock.language.check.findings import Findings, constant
from learnblock.language.tree.nodes import (
    Activate,
    Blank,
    Body,
    Break,
    Call,
    Comment,
    Constant,
    Continue,
    Def,
    Expression,
    ForEach,
    ForRange,
    If,
    Item,
    Name,
    Pass,
    Perform,
    Raw,
    RawExpression,
    Repeat,
    Return,
    SkillCall,
    WaitUntil,
    When,
    While,
)
from learnblock.language.tree.traversal import bodies, statements, within

LOOPS = (While, Repeat, ForEach, ForRange)
_JUMPS = (Break, Continue, Return)
_NOTHING = (Pass, Comment, Blank)
#: The event that runs at the start, without a condition.
_START = "start"


class FlowChecker:
    """Follows the statements of a program in the order in which they run."""

    def __init__(self, findings: Findings) -> None:
        self.findings = findings
        self.report = findings.report

    def run(self) -> None:
        for item in self.findings.everything:
            check = _CHECKS.get(type(item))
            if check is not None:
                check(self, item)
        if self.findings.whens:
            self.events_behind_loop()

    def unreachable(self, body: tuple[Item, ...]) -> None:
        """Report the first statement that can never be reached."""
        left: Item | None = None
        for item in body:
            if isinstance(item, Comment | Blank | Def | When):
                continue
            if left is not None:
                self.report("unreachable", _unreachable(left), item.span, "warning")
                return
            if _leaves(item):
                left = item
        if left is not None and self.findings.main and body is self.findings.top:
            main = self.findings.main[0].span
            self.report("unreachable", _unreachable(left), main, "warning")

    # Loops.

    def repeat(self, item: Repeat) -> None:
        times = constant(item.count)
        if isinstance(times, int | float) and times <= 0:
            message = Phrase(
                self.findings.worded("check-never-repeats", "check-never-repeats-python"),
                count=_spelled(times),
            )
            self.report("never-runs", message, item.count.span, "warning")

    def counting(self, item: ForRange) -> None:
        start, stop = constant(item.start), constant(item.stop)
        if not (isinstance(start, int | float) and isinstance(stop, int | float)):
            return
        if item.step is None and start > stop:
            # The end is not in the text of ``range(0)``.
            span = item.stop.span if item.stop.span.line else item.target.span
            message = self.counts_up(item.target.name, start, stop)
            self.report("never-runs", message, span, "warning")

    def counts_up(self, name: str, start: float, stop: float) -> Phrase:
        if not self.findings.in_python:
            limits = {"start": _spelled(start), "stop": _spelled(stop)}
            return Phrase("check-counts-up", name=name, **limits)
        if start:
            # Block-Text counts to the last number, 'range' to the one before.
            return Phrase("check-counts-up-python", start=_spelled(start), stop=_spelled(stop + 1))
        return Phrase("check-never-repeats-python", count=_spelled(stop + 1))

    def loop(self, item: While) -> None:
        """Report a loop that does nothing while nothing else changes its condition."""
        if _is_idle(item.body) and self.is_fixed(item.condition):
            self.report("idle-loop", Phrase("check-idle-loop"), item.span, "warning")

    def waiting(self, item: WaitUntil) -> None:
        """Report waiting for something that only other statements could change."""
        if not any(map(_may_change, within(item.condition))):
            message = Phrase("check-idle-wait", skill=self.findings.called("is_front_obstacle()"))
            self.report("idle-wait", message, item.condition.span, "warning")

    def is_fixed(self, condition: Expression) -> bool:
        if isinstance(condition, Constant):
            return condition.value is True
        return not self.findings.whens and not any(map(_may_change, within(condition)))

    # Functions and events.

    def function(self, item: Def) -> None:
        """Report a function that calls itself before it can return."""
        for one in item.body:
            match one:
                case Perform(call=Call(name=item.name) as call):
                    code = self.findings.worded("check-calls-itself", "check-calls-itself-python")
                    message = Phrase(code, name=item.name)
                    self.report("calls-itself", message, call.span, "warning")
                    return
            if any(isinstance(inner, Return | Raw) for inner in statements((one,))):
                return

    def event(self, item: When) -> None:
        """Report an event without a condition that nothing starts."""
        runs = item.condition is not None or item.name == _START
        if not runs and not _is_idle(item.body) and not self.is_started(item.name):
            message = Phrase(
                self.findings.worded("check-never-started", "check-never-started-python"),
                name=item.name,
            )
            self.report("never-started", message, item.span, "warning")

    def is_started(self, name: str) -> bool:
        """Whether a statement starts an event, or may mean to."""
        others = self.findings.whens.keys() - {name}
        return any(
            one.name not in others if isinstance(one, Activate) else name in one.text
            for one in self.findings.everything
            if isinstance(one, Activate | Raw)
        )

    def events_behind_loop(self) -> None:
        """Report an endless loop before the events: these run after the rest of the program."""
        name = next((name for name in self.findings.whens if name != _START), None)
        for item in (*self.findings.top, *self.findings.main):
            if name is not None and isinstance(item, While) and _leaves(item):
                message = Phrase(
                    self.findings.worded("check-events-never-run", "check-events-never-run-python"),
                    name=name,
                )
                self.report("events-never-run", message, item.span, "warning")


_CHECKS: Mapping[type, Callable[[FlowChecker, Any], None]] = MappingProxyType(
    {
        Repeat: FlowChecker.repeat,
        ForRange: FlowChecker.counting,
        While: FlowChecker.loop,
        WaitUntil: FlowChecker.waiting,
        Def: FlowChecker.function,
        When: FlowChecker.event,
    }
)


def _is_idle(body: Body) -> bool:
    return all(isinstance(one, _NOTHING) for one in body)


def _spelled(number: float) -> str:
    return repr(number).removesuffix(".0")


def _may_change(node: Expression) -> bool:
    if isinstance(node, Name):
        return node.name.startswith(("state_", "time_"))
    return isinstance(node, Call | SkillCall | RawExpression)


def _leaves(item: Item) -> bool:
    """Whether nothing that follows in the same body can ever be reached."""
    if isinstance(item, _JUMPS):
        return True
    if isinstance(item, While):
        return item.is_endless and not _breaks(item.body)
    if isinstance(item, If) and item.otherwise is not None:
        return all(any(map(_leaves, body)) for body in bodies(item))
    return False


def _breaks(body: Body) -> bool:
    """Whether a ``break``, or raw Python that may contain one, leaves the loop of this body."""
    for item in body:
        if isinstance(item, Break | Raw):
            return True
        if not isinstance(item, LOOPS) and any(map(_breaks, bodies(item))):
            return True
    return False


def _unreachable(left: Item) -> Phrase:
    """The message about a statement after one that never continues."""
    line = str(left.span.line)
    if isinstance(left, _JUMPS):
        word = type(left).__name__.lower()
        return Phrase("check-unreachable-after-jump", word=word, line=line)
    if isinstance(left, While):
        return Phrase("check-unreachable-after-loop", line=line)
    return Phrase("check-unreachable-after-branches", line=line)
