"""Find variables that two calls or parts of a program share, although each should have its own."""

from collections.abc import Iterator, Mapping
from collections.abc import Set as AbstractSet
from dataclasses import dataclass, field
from functools import cached_property
from typing import NamedTuple

from learnblock.i18n import Phrase
from learnblock.language.check.call_graph import reachable, recursive
from learnblock.language.check.endings import LOOPS, START
from learnblock.language.check.findings import Findings, constant
from learnblock.language.tree.markers import raw_names
from learnblock.language.tree.nodes import (
    Assign,
    Body,
    Call,
    Constant,
    Def,
    Expression,
    If,
    Item,
    Name,
    PythonBlock,
    RawExpression,
    Return,
    When,
    While,
)
from learnblock.language.tree.traversal import (
    all_expressions,
    bodies,
    evaluated,
    locals_in,
    own_statements,
    read_expressions,
    set_by,
    statements,
)

#: Nested loops are followed for two rounds only to this depth: each level doubles the work.
_DEEPEST = 4


def check_shared_variables(findings: Findings) -> None:
    """Report variables that should be local to a function or an event."""
    _Checker(findings).run()


class _Source(NamedTuple):
    """Where a variable's value may come from: a call that changed it, or one of those below."""

    function: str
    line: int = 0


#: The part of the program that reads it.
_OWN = _Source("own")
#: Another part of the program.
_ELSEWHERE = _Source("elsewhere")
#: The variables that a part has set, with all sources of their values.
_Values = dict[str, frozenset[_Source]]


@dataclass(slots=True)
class _Part:
    """A function, an event or the rest of the program, and what it does with shared variables.

    Args:
        name: the name of the function or event; empty for the rest.
        body: its statements.
        condition: that of an event, if it has one.
        sets: the shared variables that it sets.
        counts: those that it updates in a loop from their old values.
        takes: those whose value it takes from another part.
        changed: those that it sets, and reads after a call that may have changed them.
    """

    name: str
    body: tuple[Item, ...]
    condition: Expression | None = None
    sets: dict[str, list[Assign]] = field(default_factory=dict)
    counts: set[str] = field(default_factory=set)
    takes: set[str] = field(default_factory=set)
    changed: dict[str, _Source] = field(default_factory=dict)

    def find_shared(self, others: AbstractSet[str]) -> None:
        """Find the shared variables that it sets; `others` are its own, and those left out."""
        for item in own_statements(self.body):
            if isinstance(item, Assign) and isinstance(item.target, Name):
                self.sets.setdefault(item.target.name, []).append(item)
            elif isinstance(item, LOOPS):
                self.counts |= _updated_in(bodies(item)[0])
                if not self.name:
                    self.counts.update(set_by(item))
        self.counts -= others
        for name in others & self.sets.keys():
            del self.sets[name]


class _Checker:
    def __init__(self, findings: Findings) -> None:
        self.findings = findings
        self.functions = {name: self.part(item) for name, item in findings.functions.items()}
        self.events = {name: self.part(item) for name, item in findings.whens.items()}
        self.rest = _Part("", findings.top + findings.main)
        self.rest.find_shared(self.hidden)
        self.reported: set[tuple[int, str]] = set()

    def run(self) -> None:
        setting = [part for part in self.functions.values() if part.sets]
        recursive_parts = [part for part in setting if part.name in self.recursive_names]
        counting = [part for part in self.parts if part.name and part.counts]
        if not (recursive_parts or counting):
            return
        for part in self.parts:
            _Walk(self, part).run()
        for part in recursive_parts:
            self.recursion(part)
        for part in counting:
            self.calls(part)
            self.other_events(part)

    # The parts of the program.

    @cached_property
    def parts(self) -> tuple[_Part, ...]:
        return (*self.functions.values(), *self.events.values(), self.rest)

    def part(self, item: Def | When) -> _Part:
        parameters = item.parameters if isinstance(item, Def) else ()
        part = _Part(item.name, item.body, item.condition if isinstance(item, When) else None)
        part.find_shared(self.hidden.union(locals_in(item.body), parameters))
        return part

    @cached_property
    def hidden(self) -> set[str]:
        """The names in lines of Python, which may do anything with them."""
        blocks = (item for item in self.findings.everything if isinstance(item, PythonBlock))
        inner = (item for block in blocks if block.has_scope for item in statements((block,)))
        return self.findings.raw_names.union(*map(set_by, inner))

    @cached_property
    def calls_of(self) -> Mapping[str, set[str]]:
        """The functions that each function itself calls."""
        return {name: set(self.called_in(part)) for name, part in self.functions.items()}

    @cached_property
    def recursive_names(self) -> set[str]:
        return recursive(self.calls_of)

    @cached_property
    def run_by(self) -> Mapping[str, set[str]]:
        """The functions that run when each of them is called."""
        return {name: reachable((name,), self.calls_of) for name in self.functions}

    def called_in(self, part: _Part) -> Iterator[str]:
        for item in statements(part.body):
            for node in all_expressions(item):
                yield from (call.function for call in self.called(node))

    def called(self, node: Expression) -> Iterator[_Source]:
        """The program's functions that an expression itself calls."""
        if isinstance(node, Call):
            if node.name in self.functions:
                yield _Source(node.name, node.span.line)
        elif isinstance(node, RawExpression):
            for name in sorted(raw_names(node.text.strip()) & self.functions.keys()):
                yield _Source(name, node.span.line)

    @cached_property
    def changed_by(self) -> Mapping[str, set[str]]:
        """The shared variables that a call of each function may set."""
        return {
            function: {name for inner in run for name in self.functions[inner].sets}
            for function, run in self.run_by.items()
        }

    # What is reported.

    def recursion(self, part: _Part) -> None:
        """Report what a function needs after it has called itself, when the inner call sets it."""
        others = [other for other in self.parts if other is not part]
        for name, call in part.changed.items():
            run = self.run_by[call.function]
            used = any(name in other.takes or name in other.changed for other in others)
            given = any(name in self.functions[inner].sets for inner in run - {part.name})
            fixed = all(map(_is_fixed, part.sets.get(name, ())))
            if part.name in run and not (used or given or fixed or name in part.takes):
                self.report("check-shared-in-recursion", part, name, line=str(call.line))

    def calls(self, part: _Part) -> None:
        """Report a counter of a function that is called in a loop with the same counter."""
        if part is not self.functions.get(part.name):
            return
        for other in self.parts:
            for name in sorted(part.counts & other.counts & other.changed.keys() - part.takes):
                call = other.changed[name]
                if other is not part and part.name in self.run_by[call.function]:
                    self.report("check-shared-counter", part, name, line=str(call.line))

    def other_events(self, part: _Part) -> None:
        """Report a counter of an event, or of what it calls, if another event counts with it."""
        if not self.is_repeated(part):
            return
        for event in self.events.values():
            if event is part or event.name == START:
                continue
            for name in sorted(part.counts & event.takes - part.takes):
                if any(map(_is_update, event.sets.get(name, ()))):
                    self.report("check-shared-by-events", part, name, event=event.name)

    def is_repeated(self, part: _Part) -> bool:
        """Whether events run a part again and again; what runs at the start prepares the others."""
        if part is self.events.get(part.name):
            return part.name != START
        return part.name in self.run_by_events

    @cached_property
    def run_by_events(self) -> set[str]:
        """The functions that events other than the start run."""
        events = (event for event in self.events.values() if event.name != START)
        called = {name for event in events for name in self.called_in(event)}
        return reachable(called, self.calls_of)

    def report(self, code: str, part: _Part, name: str, **values: str) -> None:
        if (id(part), name) in self.reported:
            return
        self.reported.add((id(part), name))
        first = part.sets[name][0]
        in_notation = self.findings.worded(code, f"{code}-python")
        message = Phrase(in_notation, name=name, owner=part.name, **values)
        self.findings.report("shared-variable", message, first.target.span, "warning")


class _Walk:
    """Follows a part of the program in the order in which it runs."""

    def __init__(self, checker: _Checker, part: _Part) -> None:
        self.checker, self.part = checker, part
        self.loops = 0

    def run(self) -> None:
        if self.part.condition is not None:
            self.expression(self.part.condition, {})
        self.block(self.part.body, {})

    def block(self, body: tuple[Item, ...], values: _Values | None) -> _Values | None:
        """The values after a body; None if its end is never reached."""
        for item in body:
            if values is None:
                return None
            values = self.statement(item, values)
        return values

    def statement(self, item: Item, values: _Values) -> _Values | None:
        if isinstance(item, Def | When) or (isinstance(item, PythonBlock) and item.has_scope):
            return values
        if isinstance(item, If):
            return self.branches(item, values)
        if isinstance(item, LOOPS):
            return self.loop(item, values)
        if isinstance(item, PythonBlock):
            for body in bodies(item):
                values = _joined(values, self.block(body, values)) or values
            return values
        changed = dict(values)
        for expression in read_expressions(item):
            self.expression(expression, changed)
        for name in set_by(item):
            changed[name] = frozenset((_OWN,))
        return None if isinstance(item, Return) else changed

    def branches(self, item: If, values: _Values) -> _Values | None:
        after: _Values | None = None
        for branch in item.branches:
            values = dict(values)
            self.expression(branch.condition, values)
            after = _joined(after, self.block(branch.body, values))
        last = values if item.otherwise is None else self.block(item.otherwise.body, values)
        return _joined(after, last)

    def loop(self, item: Item, values: _Values) -> _Values:
        values = dict(values)
        if not isinstance(item, While):
            for expression in read_expressions(item):
                self.expression(expression, values)
        self.loops += 1
        for _ in range(2 if self.loops <= _DEEPEST else 1):
            values = self.round(item, values)
        self.loops -= 1
        return values

    def round(self, item: Item, values: _Values) -> _Values:
        """The values after one round of a loop, or before it."""
        values = dict(values)
        if isinstance(item, While):
            self.expression(item.condition, values)
        inner = values | dict.fromkeys(set_by(item), frozenset((_OWN,)))
        return _joined(values, self.block(bodies(item)[0], inner)) or values

    def expression(self, expression: Expression, values: _Values) -> None:
        for node in evaluated(expression):
            if isinstance(node, Name):
                self.read(node.name, values)
            elif isinstance(node, RawExpression):
                for name in raw_names(node.text.strip()):
                    self.read(name, values)
            for call in self.checker.called(node):
                self.call(call, values)

    def read(self, name: str, values: _Values) -> None:
        for source in values.get(name, (_ELSEWHERE,)):
            if source == _ELSEWHERE:
                self.part.takes.add(name)
            elif source != _OWN:
                self.part.changed.setdefault(name, source)

    def call(self, call: _Source, values: _Values) -> None:
        for name in self.checker.changed_by[call.function]:
            sources = values.get(name, frozenset((_ELSEWHERE,)))
            if _OWN in sources:
                values[name] = sources | {call}


def _updated_in(body: Body) -> set[str]:
    """The variables that a loop updates from their old values."""
    return {
        name
        for item in own_statements(body)
        if isinstance(item, Assign) and _is_update(item)
        for name in set_by(item)
    }


def _is_update(item: Assign) -> bool:
    """Whether the new value of a variable depends on the one before."""
    names = {node.name for node in evaluated(item.value) if isinstance(node, Name)}
    return item.operator != "=" or not names.isdisjoint(set_by(item))


def _is_fixed(item: Assign) -> bool:
    is_literal = isinstance(item.value, Constant) or constant(item.value) is not None
    return item.operator == "=" and is_literal


def _joined(one: _Values | None, other: _Values | None) -> _Values | None:
    """The values after either of two ways through the program."""
    if one is None or other is None:
        return other if one is None else one
    elsewhere = frozenset((_ELSEWHERE,))
    return {
        name: one.get(name, elsewhere) | other.get(name, elsewhere)
        for name in one.keys() | other.keys()
    }
