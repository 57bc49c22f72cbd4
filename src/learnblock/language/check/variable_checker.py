"""Find variables that are never set, or read before, also in the functions that are called."""

from collections import Counter
from collections.abc import Generator, Iterable, Iterator
from dataclasses import dataclass, field, replace
from itertools import chain

from learnblock.errors import nearest
from learnblock.i18n import Phrase
from learnblock.language.blocktext.names import state_of
from learnblock.language.blocktext.other_names import QUESTIONS, VALUES
from learnblock.language.check.endings import LOOPS
from learnblock.language.check.findings import Findings, unknown
from learnblock.language.check.walks import exhaust
from learnblock.language.tree.characters import write_instead
from learnblock.language.tree.markers import raw_names
from learnblock.language.tree.nodes import (
    Binary,
    Body,
    Call,
    Conditional,
    Def,
    Expression,
    If,
    Item,
    Name,
    PythonBlock,
    RawExpression,
    When,
)
from learnblock.language.tree.traversal import (
    all_expressions,
    bodies,
    locals_in,
    read_expressions,
    set_by,
    statements,
    within,
)

#: What is left of a walk: it yields the walks through a body or a function on its way.
_Steps = Generator["_Steps", None, None]

# Python sets these in every file.
_PYTHONS_OWN = frozenset(("__name__", "__file__"))


def check_variables(findings: Findings) -> None:
    """Report variables that are never set, and then those that are read too early."""
    _Values(findings).run()
    _Order(findings).run()


class _Values:
    """Finds variables that are never set."""

    def __init__(self, findings: Findings) -> None:
        self.findings = findings
        self.known = findings.assigned | set(findings.whens)

    def run(self) -> None:
        for item in (*self.findings.program.items, *self.findings.main):
            self.never_set(item)

    def never_set(self, item: Item) -> None:
        own = set(item.parameters) if isinstance(item, Def) else set()
        for statement in statements((item,)):
            for node in _evaluated(statement):
                if isinstance(node, Name):
                    self.read(node, own)

    def read(self, node: Name, own: set[str]) -> None:
        findings, name = self.findings, node.name
        if name in findings.assigned or name in own or findings.imports or name in _PYTHONS_OWN:
            return
        if name.startswith(("state_", "time_")):
            return
        findings.report("unknown-name", self.advice(name, own), node.span)

    def instead(self, name: str) -> str | None:
        """Our value, or question for the robot, in place of one of another language."""
        question = QUESTIONS.get(name, "")
        if question.partition("(")[0] in self.findings.skills:
            return self.findings.called(question)
        return VALUES.get(name)

    def advice(self, name: str, own: set[str]) -> Phrase:
        if name in self.findings.whens:
            return Phrase("check-when-as-variable", name=name)
        if name in self.findings.functions:
            return Phrase("check-function-as-variable", name=name)
        if (instead := self.instead(name)) is not None:
            return write_instead(name, instead)
        if name in self.findings.skills:
            return Phrase("check-skill-as-name", name=name, skill=self.findings.called(name))
        return unknown("name", name, nearest(name, self.known | own))


@dataclass(frozen=True, slots=True)
class _Scope:
    """The variables that may be set where a statement runs.

    Args:
        known: the shared variables that may be set.
        own: the parameters, loop variables and local variables of the function.
        bound: those of them that may be set.
        in_loop: what the loops around set, each as often as statements set it.
        maybe: what other branches may have set in an earlier round of these loops.
    """

    known: set[str]
    own: frozenset[str] = frozenset()
    bound: set[str] = field(default_factory=set)
    in_loop: Counter[str] = field(default_factory=Counter)
    maybe: frozenset[str] = frozenset()

    def has(self, name: str) -> bool:
        return name in (self.bound if name in self.own else self.known) or name in self.maybe

    def bind(self, name: str) -> None:
        (self.bound if name in self.own else self.known).add(name)


class _Order:
    """Follows a program in the order in which it runs.

    A variable set in one branch counts as set: only definite errors are reported.
    """

    def __init__(self, findings: Findings) -> None:
        self.findings = findings
        self.functions = findings.functions
        self.reported: set[str] = set()
        self.followed: set[tuple[str, bool]] = set()

    def run(self) -> None:
        program, whens = self.findings.program, self.findings.whens
        known = set(self.findings.raw_names)
        blocks = (item for item in self.findings.everything if isinstance(item, PythonBlock))
        # Something else may run them, in an order that only the run knows.
        known.update(*(self.sets(body) for block in blocks for body in bodies(block)))
        known.update(*(self.sets(self.functions[name].body) for name in self.called_in_raw()))
        runs = [item for item in program.items if not isinstance(item, Def | When)]
        if self.findings.in_python:
            # The text runs from top to bottom; the tree has definitions first.
            runs.sort(key=lambda statement: statement.span.line)
        self.walk((*runs, *self.findings.main), _Scope(known))
        self.events(list(whens.values()), known)

    def events(self, whens: list[When], known: set[str]) -> None:
        start = [when for when in whens if when.name == "start" and when.condition is None]
        for when in start:
            self.event(when, known, Counter())
        for when in whens:
            # The first cycle evaluates every condition before it runs an event.
            exhaust(self.expressions(_certain(when.condition), _Scope(known)))
        sets = {when.name: set(self.sets(when.body)) for when in whens}
        for when in whens:
            # Each runs again and again, after any other.
            others = (names for name, names in sets.items() if name != when.name)
            self.event(when, known.union(*others), self.sets(when.body))

    def event(self, when: When, known: set[str], again: Counter[str]) -> None:
        own = frozenset(locals_in(when.body))
        self.walk(when.body, _Scope(known, own, self.bound_in_raw(own), in_loop=again))

    def bound_in_raw(self, own: frozenset[str]) -> set[str]:
        """The local variables that a line of Python may set."""
        return set(own & self.findings.raw_names)

    def called_in_raw(self) -> set[str]:
        """The functions that parts in raw Python may call at any time."""
        names = set(self.findings.raw_names)
        for item in self.findings.everything:
            for node in all_expressions(item):
                if isinstance(node, RawExpression):
                    names |= raw_names(node.text.strip())
        return names & self.functions.keys()

    def sets(self, body: Body) -> Counter[str]:
        """The variables that statements set, also through the functions that they call."""
        names = Counter(chain.from_iterable(map(set_by, statements(body))))
        seen: set[str] = set()
        ahead = list(self.called_in(body))
        while ahead:
            name = ahead.pop()
            inner = self.functions[name].body
            names.update(chain.from_iterable(map(set_by, statements(inner))))
            if name not in seen:
                seen.add(name)
                ahead += self.called_in(inner)
        return names

    def called_in(self, body: Body) -> Iterator[str]:
        for item in statements(body):
            for node in all_expressions(item):
                if isinstance(node, Call) and node.name in self.functions:
                    yield node.name

    def walk(self, body: Iterable[Item], scope: _Scope) -> None:
        exhaust(self.block(body, scope))

    def block(self, body: Iterable[Item], scope: _Scope) -> _Steps:
        for item in body:
            yield from self.statement(item, scope)

    def statement(self, item: Item, scope: _Scope) -> _Steps:
        yield from self.expressions(_evaluated(item), scope)
        for name in set_by(item):
            scope.bind(name)
        if isinstance(item, PythonBlock) and item.has_scope:
            return
        for body in bodies(item):
            yield self.block(body, self.inner(item, body, scope))

    def inner(self, item: Item, body: Body, scope: _Scope) -> _Scope:
        """The scope of a body of a statement."""
        if isinstance(item, LOOPS):
            return replace(scope, in_loop=scope.in_loop + self.sets(body))
        if isinstance(item, If) and scope.in_loop:
            return replace(scope, maybe=scope.maybe | (scope.in_loop - self.sets(body)).keys())
        return scope

    def expressions(self, expressions: Iterable[Expression], scope: _Scope) -> _Steps:
        nodes = list(expressions)
        for node in nodes:
            if isinstance(node, Call) and node.name in self.functions:
                yield from self.call(self.functions[node.name], scope)
        for node in nodes:
            if isinstance(node, Name):
                self.read(node, scope)

    def call(self, function: Def, scope: _Scope) -> _Steps:
        """Follow the first call of a function: later, the same variables are set and more."""
        key = (function.name, bool(scope.maybe))
        if key in self.followed:
            return
        self.followed.add(key)
        own = frozenset((*locals_in(function.body), *function.parameters))
        bound = {*function.parameters, *self.bound_in_raw(own)}
        yield self.block(function.body, _Scope(scope.known, own, bound, maybe=scope.maybe))

    def read(self, node: Name, scope: _Scope) -> None:
        name = node.name
        if state_of(name, self.findings.whens.keys()) is not None:
            return
        if scope.has(name) or name in self.reported or name not in self.findings.assigned:
            return
        self.reported.add(name)
        self.findings.report(
            "unset-variable", Phrase("check-read-before-set", name=name), node.span
        )


def _evaluated(item: Item) -> Iterator[Expression]:
    """The expressions that a statement evaluates, without its target and the bodies inside it."""
    for expression in read_expressions(item):
        yield from within(expression)


def _certain(condition: Expression | None) -> Iterator[Expression]:
    """The parts of a condition that are evaluated in any case."""
    ahead = [] if condition is None else [condition]
    while ahead:
        node = ahead.pop()
        if isinstance(node, Binary) and node.operator in {"and", "or"}:
            ahead.append(node.left)
        elif isinstance(node, Conditional):
            ahead.append(node.condition)
        else:
            yield from within(node)
