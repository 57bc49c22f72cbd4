"""Find what never runs, and what never ends without doing anything."""

from collections.abc import Callable, Mapping
from types import MappingProxyType
from typing import Any

from learnblock.i18n import Phrase
from learnblock.language.blocktext.names import state_of
from learnblock.language.check.endings import START, Endings, before_return, breaks, is_endless
from learnblock.language.check.findings import Findings, constant
from learnblock.language.tree.nodes import (
    Activate,
    AnyPython,
    Blank,
    Body,
    Break,
    Call,
    Comment,
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
    RawExpression,
    Repeat,
    Return,
    SkillCall,
    WaitUntil,
    When,
    While,
)
from learnblock.language.tree.traversal import bodies, statements, within

_JUMPS = (Break, Continue, Return)
_QUESTION = "is_front_obstacle()"
_UNCHANGED = {"loop": "check-unchanged-in-loop", "wait": "check-unchanged-in-wait"}
_SAME_STATE = {
    "loop": ("check-state-in-loop", "check-state-in-loop-python"),
    "wait": ("check-state-in-wait", "check-state-in-wait-python"),
}
_IN_PYTHON = {
    "check-events-never-run": "check-events-never-run-python",
    "check-events-held-up-by-event": "check-events-held-up-by-event-python",
}
_ADDING = frozenset(("append", "extend", "insert"))
_TAKING = frozenset(("pop", "remove", "clear"))
_NOTHING = (Pass, Comment, Blank)


class FlowChecker:
    """Follows the statements of a program in the order in which they run."""

    def __init__(self, findings: Findings) -> None:
        self.findings = findings
        self.report = findings.report
        self.endings = Endings(findings)
        self.reported: set[int] = set()

    def run(self) -> None:
        for item in self.findings.everything:
            check = _CHECKS.get(type(item))
            if check is not None:
                check(self, item)
        if self.findings.whens:
            self.events_behind_loops()

    def unreachable(self, body: tuple[Item, ...]) -> None:
        """Report the first statement that can never be reached."""
        left: Item | None = None
        for item in body:
            if isinstance(item, Comment | Blank | Def | When):
                continue
            if left is not None:
                self.report("unreachable", _unreachable(left), item.span, "warning")
                return
            if self.leaves(item):
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
        """Report a loop that nothing ends, unless its author wrote that it is endless."""
        endless = is_endless(item)
        fixed = None if endless else self.endings.fixed(item)
        if fixed is not None:
            self.report("idle-loop", self.unchanged("loop", fixed), item.condition.span, "warning")
        elif endless and _is_idle(item.body):
            self.report("idle-loop", Phrase("check-idle-loop"), item.span, "warning")
        elif endless and (way_out := self.endings.fixed_exit(item)) is not None:
            condition, part = way_out
            self.report("idle-loop", self.unchanged("loop", part), condition.span, "warning")

    def each(self, item: ForEach) -> None:
        """Report a loop that adds to the list that it goes through."""
        name = item.values.name if isinstance(item.values, Name) else ""
        changes = [
            statement.call
            for statement in statements(item.body)
            if isinstance(statement, Perform)
            and isinstance(statement.call, Call)
            and statement.call.arguments
            if isinstance(target := statement.call.arguments[0], Name) and target.name == name
        ]
        always = {id(statement.call) for statement in item.body if isinstance(statement, Perform)}
        grows = any(change.name in _ADDING and id(change) in always for change in changes)
        shrinks = any(change.name in _TAKING for change in changes)
        leaves = breaks(item.body) or any(
            isinstance(statement, Return) for statement in statements(item.body)
        )
        if grows and not shrinks and not leaves:
            code = self.findings.worded("check-growing-list", "check-growing-list-python")
            message = Phrase(
                code, name=name, target=", ".join(target.name for target in item.targets)
            )
            self.report("idle-loop", message, item.values.span, "warning")

    def waiting(self, item: WaitUntil) -> None:
        """Report waiting for something that only other statements could change."""
        fixed = self.endings.fixed(item)
        if fixed is not None:
            message = self.unchanged("wait", fixed)
        elif any(map(_may_change, within(item.condition))):
            return
        else:
            message = Phrase("check-idle-wait", skill=self.findings.called(_QUESTION))
        self.report("idle-wait", message, item.condition.span, "warning")

    def unchanged(self, place: str, part: Name | SkillCall) -> Phrase:
        """The message about what stays the same while a loop or a wait asks for it.

        Args:
            place: ``loop`` or ``wait``.
            part: what is asked for.
        """
        skill = self.findings.called(_QUESTION)
        if isinstance(part, SkillCall):
            return Phrase("check-told-stays", name=self.findings.called(part.name), skill=skill)
        state = state_of(part.name, self.findings.whens.keys())
        if state is None:
            return Phrase(_UNCHANGED[place], name=part.name, skill=skill)
        event, value = state
        name = f"{event}.{value}" if self.findings.in_python else part.name
        if value == "time":
            code = self.findings.worded("check-time-stays", "check-time-stays-python")
            return Phrase(code, name=name, event=event, sleep=self.findings.called("sleep(2)"))
        code = self.findings.worded(*_SAME_STATE[place])
        return Phrase(code, name=name, event=event, skill=skill)

    # Functions and events.

    def function(self, item: Def) -> None:
        """Report a function that calls itself before it can return."""
        for statement in before_return(item.body):
            match statement:
                case Perform(call=Call(name=name) as call) if self.endings.leads_back(
                    item.name, name
                ):
                    code = self.findings.worded("check-calls-itself", "check-calls-itself-python")
                    message = Phrase(code, name=item.name)
                    self.report("calls-itself", message, call.span, "warning")
                    return

    def event(self, item: When) -> None:
        """Report an event without a condition that nothing starts."""
        runs = item.condition is not None or item.name == START
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
            statement.name not in others
            if isinstance(statement, Activate)
            else name in statement.text
            for statement in self.findings.everything
            if isinstance(statement, Activate | AnyPython)
        )

    def events_behind_loops(self) -> None:
        """Report endless loops that keep events from running: only one thing runs at a time."""
        top = (*self.findings.top, *self.findings.main)
        self.events_behind("", top)
        for name, when in self.findings.whens.items():
            self.events_behind(name, when.body)

    def events_behind(self, place: str, body: tuple[Item, ...]) -> None:
        """Report endless loops in a body, or in a function that it calls.

        Args:
            place: the event whose body it is, "" for what runs before the events.
            body: the statements.
        """
        other = next((when for when in self.findings.whens if when not in {START, place}), None)
        if other is None:
            return
        for loop in self.endings.endless(body):
            is_before = place in {"", START}
            if is_before and any(loop is statement for statement in body):
                self.event_behind(loop, "check-events-never-run", other)
            else:
                held_up = "check-events-held-up" if is_before else "check-events-held-up-by-event"
                self.event_behind(loop, held_up, other)
        for function in self.endings.called_in(body):
            for loop in self.endings.endless(function.body):
                self.event_behind(loop, "check-events-held-up", other)

    def event_behind(self, loop: While, code: str, other: str) -> None:
        if id(loop) not in self.reported:
            self.reported.add(id(loop))
            message = Phrase(self.findings.worded(code, _IN_PYTHON.get(code, code)), name=other)
            self.report("events-never-run", message, loop.span, "warning")

    def leaves(self, item: Item) -> bool:
        """Whether nothing that follows in the same body can ever be reached."""
        if isinstance(item, _JUMPS):
            return True
        if isinstance(item, While):
            return is_endless(item) and not breaks(item.body)
        if isinstance(item, Perform):
            return isinstance(item.call, Call) and item.call.name in self.endings.endless_functions
        if isinstance(item, If) and item.otherwise is not None:
            return all(any(map(self.leaves, body)) for body in bodies(item))
        return False


_CHECKS: Mapping[type, Callable[[FlowChecker, Any], None]] = MappingProxyType(
    {
        Repeat: FlowChecker.repeat,
        ForRange: FlowChecker.counting,
        ForEach: FlowChecker.each,
        While: FlowChecker.loop,
        WaitUntil: FlowChecker.waiting,
        Def: FlowChecker.function,
        When: FlowChecker.event,
    }
)


def _is_idle(body: Body) -> bool:
    return all(isinstance(statement, _NOTHING) for statement in body)


def _spelled(number: float) -> str:
    return repr(number).removesuffix(".0")


def _may_change(node: Expression) -> bool:
    return isinstance(node, Name | Call | SkillCall | RawExpression)


def _unreachable(left: Item) -> Phrase:
    """The message about a statement after one that never continues."""
    line = str(left.span.line)
    if isinstance(left, _JUMPS):
        word = type(left).__name__.lower()
        return Phrase("check-unreachable-after-jump", word=word, line=line)
    if isinstance(left, While):
        return Phrase("check-unreachable-after-loop", line=line)
    if isinstance(left, Perform):
        return Phrase("check-unreachable-after-call", name=left.call.name, line=line)
    return Phrase("check-unreachable-after-branches", line=line)
