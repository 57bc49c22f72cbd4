"""Find what could end a loop or a wait, during which no other line runs and no event."""

from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from functools import cached_property
from operator import eq, ge, gt, le, lt, ne
from types import MappingProxyType
from typing import Any

from learnblock.language.blocktext.names import state_of
from learnblock.language.check.call_graph import callers_of, cycles
from learnblock.language.check.findings import Findings, constant
from learnblock.language.check.types import KNOWN, Type, Types
from learnblock.language.tree.nodes import (
    Activate,
    AnyPython,
    Assign,
    Body,
    Break,
    Call,
    Compare,
    Constant,
    Deactivate,
    Def,
    Expression,
    ForEach,
    ForRange,
    If,
    Index,
    Item,
    Name,
    Perform,
    PythonBlock,
    PythonLine,
    Raw,
    RawExpression,
    Repeat,
    Return,
    SkillCall,
    Statement,
    Unary,
    WaitUntil,
    While,
)
from learnblock.language.tree.traversal import (
    all_expressions,
    bodies,
    locals_in,
    set_by,
    statements,
    within,
)

LOOPS = (While, Repeat, ForEach, ForRange)
#: The event that runs at the start, without a condition.
START = "start"
#: The functions that may answer differently each time.
_VARYING = frozenset(("elapsedTime", "random", "random_fraction", "choice", "input"))
#: The functions that change the items of their first argument.
_CHANGING = frozenset(
    ("append", "extend", "insert", "remove", "pop", "clear", "sort", "reverse", "shuffle")
)
#: The skills that return the last command to the robot, which only another command changes.
_TOLD = frozenset(
    (
        *("is_moving_straight", "is_moving_left", "is_moving_right"),
        *("is_turning", "is_turning_left", "is_turning_right"),
        *("is_Joy", "is_Sadness", "is_Surprised", "is_Disgust", "is_Angry", "is_Scared"),
        "is_Neutral",
    )
)
#: The skills that leave the current movement as it is.
_IDLE = frozenset(("sleep", "wait_until_still", "reset_timer"))
_ORDERS: Mapping[str, Callable[[Any, Any], bool]] = MappingProxyType(
    {"==": eq, "!=": ne, "<": lt, "<=": le, ">": gt, ">=": ge}
)
#: The types of values that have no items to change.
_PLAIN = KNOWN - {Type.LIST, Type.DICTIONARY}


@dataclass(slots=True)
class Effects:
    """What statements may change, also through the functions that they call.

    Args:
        names: the variables that they set.
        items: the variables whose items they change.
        started: the events that they activate.
        stopped: the events that they deactivate.
        commands: whether they tell the robot to do something.
        anything: whether they may change anything, as raw Python may.
    """

    names: set[str] = field(default_factory=set)
    items: set[str] = field(default_factory=set)
    started: set[str] = field(default_factory=set)
    stopped: set[str] = field(default_factory=set)
    commands: bool = False
    anything: bool = False


class Endings:
    """What could end the loops and waits of a program."""

    def __init__(self, findings: Findings) -> None:
        self.findings = findings
        self.functions, self.whens = findings.functions, findings.whens

    def fixed(self, item: While | WaitUntil) -> Name | SkillCall | None:
        """A part of a condition that nothing changes while it is asked again and again.

        None if something may change the condition, or if it has no such part.
        """
        effects = self.effects(item.body if isinstance(item, While) else ())
        if effects.anything or (isinstance(item, While) and self.leaves(item)):
            return None
        parts = self.parts(item.condition)
        if any(self.varies(part, item, effects) for part in parts):
            return None
        return next((part for part in parts if isinstance(part, Name | SkillCall)), None)

    def fixed_exit(self, loop: While) -> tuple[Expression, Name | SkillCall] | None:
        """The condition of the way out of an endless loop, and its part that nothing changes.

        None if there is no way out, or one that may be taken in a later round.
        """
        effects = self.effects(loop.body)
        exit_ = None
        for guards in _exits(loop.body, ()):
            fixed = next(
                filter(None, (self._fixed_guard(guard, loop, effects) for guard in guards)), None
            )
            if fixed is None or effects.anything:
                return None
            exit_ = exit_ or fixed
        return exit_

    def _fixed_guard(
        self, condition: Expression, loop: While, effects: Effects
    ) -> tuple[Expression, Name | SkillCall] | None:
        parts = self.parts(condition)
        if any(self.varies(part, loop, effects) for part in parts):
            return None
        source = next((part for part in parts if isinstance(part, Name | SkillCall)), None)
        return None if source is None else (condition, source)

    def parts(self, condition: Expression) -> list[Expression]:
        """The parts of a condition and of the functions that it calls."""
        expressions = within(condition)
        for function in self.called(expressions):
            expressions += [
                node for item in statements(function.body) for node in all_expressions(item)
            ]
        return expressions

    def varies(self, part: Expression, item: Item, effects: Effects) -> bool:
        """Whether a part of a condition may have another value the next time."""
        match part:
            case RawExpression():
                return True
            case SkillCall(name=name):
                return name not in _TOLD or effects.commands
            case Call(name=name):
                return self.call_varies(name)
            case Name(name=name):
                return self.name_varies(name, item, effects)
        return False

    def call_varies(self, name: str) -> bool:
        if function := self.functions.get(name):
            own = self.effects(function.body)
            changes = own.names or own.items or own.started or own.stopped
            return bool(changes or own.commands or own.anything)
        return name in _VARYING or name in _CHANGING or not self.is_known(name)

    def is_known(self, name: str) -> bool:
        return self.findings.is_of_language(name)

    def name_varies(self, name: str, item: Item, effects: Effects) -> bool:
        if name in self.findings.raw_names or name in effects.names:
            return True
        state = state_of(name, self.whens.keys())
        if state is None:
            is_unknown = name not in self.findings.assigned | self.parameters
            return is_unknown or (bool(effects.items) and not self.is_plain(name))
        event, value = state
        if event in effects.started | effects.stopped:
            return True
        return value == "time" and self.may_be_active(event, item)

    @cached_property
    def parameters(self) -> set[str]:
        return {name for function in self.functions.values() for name in function.parameters}

    def is_plain(self, name: str) -> bool:
        """Whether a variable never holds a list or dictionary, which has other names as well."""
        return self.types.variables.get(name) in _PLAIN

    @cached_property
    def types(self) -> Types:
        return Types(self.findings)

    # Where statements run.

    def may_be_active(self, event: str, item: Item) -> bool:
        """Whether an event may be active where a statement runs."""
        places = self.places(item)
        if not places or event in places or event in self.findings.raw_names:
            return True
        if places - {"", START}:
            return (
                self.whens[event].condition is not None or event in self.effects(self.all).started
            )
        return event in self.effects(self.beginning).started

    @cached_property
    def all(self) -> tuple[Item, ...]:
        return self.findings.program.items + self.findings.main

    @cached_property
    def beginning(self) -> tuple[Item, ...]:
        """What runs before the events do."""
        start = self.whens.get(START)
        return self.findings.top + self.findings.main + (() if start is None else start.body)

    def places(self, item: Item) -> set[str]:
        """The events in which a statement runs, "" for outside of them."""
        return {name for name, items in self._places.items() if id(item) in items}

    @cached_property
    def _places(self) -> dict[str, set[int]]:
        roots: dict[str, tuple[Item, ...]] = {"": self.findings.top + self.findings.main}
        roots |= {name: when.body for name, when in self.whens.items()}
        return {name: set(map(id, self.reached(body))) for name, body in roots.items()}

    def called_in(self, body: tuple[Item, ...]) -> list[Def]:
        """The functions that a body calls, also by each other."""
        return self.called(node for item in statements(body) for node in all_expressions(item))

    def reached(self, body: tuple[Item, ...]) -> Iterator[Item]:
        """The statements of a body, and those of the functions that it calls."""
        yield from statements(body)
        for function in self.called_in(body):
            yield from statements(function.body)

    def called(self, nodes: Iterable[Expression]) -> list[Def]:
        """The functions that are called, also by each other."""
        functions: dict[str, Def] = {}
        ahead = [node.name for node in nodes if isinstance(node, Call)]
        while ahead:
            name = ahead.pop()
            function = self.functions.get(name)
            if function is None or name in functions:
                continue
            functions[name] = function
            inner = (node for item in statements(function.body) for node in all_expressions(item))
            ahead += [node.name for node in inner if isinstance(node, Call)]
        return list(functions.values())

    # What statements change.

    def effects(self, body: tuple[Item, ...]) -> Effects:
        effects = Effects()
        for item in statements(body):
            self._add(item, effects)
        for function in self.called_in(body):
            inner = Effects()
            for item in statements(function.body):
                self._add(item, inner)
            local = {*function.parameters, *locals_in(function.body)}
            effects.names |= inner.names - local
            effects.items |= inner.items
            effects.started |= inner.started
            effects.stopped |= inner.stopped
            effects.commands |= inner.commands
            effects.anything |= inner.anything
        return effects

    def _add(self, item: Item, effects: Effects) -> None:
        effects.names.update(set_by(item))
        match item:
            case Activate(name=name):
                effects.started.add(name)
            case Deactivate(name=name):
                effects.stopped.add(name)
            case Assign(target=Index(value=value)):
                effects.items.add(_root(value))
            case Raw() | PythonLine() | PythonBlock():
                effects.anything = True
        for node in all_expressions(item):
            match node:
                case RawExpression():
                    effects.anything = True
                case SkillCall(name=name):
                    effects.commands |= name not in _IDLE and not self.is_question(name)
                case Call(name=name, arguments=arguments) if name not in self.functions:
                    effects.anything |= not self.is_known(name)
                    if name in _CHANGING and arguments:
                        effects.items.add(_root(arguments[0]))

    def is_question(self, name: str) -> bool:
        skill = self.findings.skills.get(name)
        return skill is not None and skill.returns_value

    # Endless loops and calls.

    def leads_back(self, caller: str, called: str) -> bool:
        """Whether a call of one function leads back to its caller before it returns."""
        return caller == called or self._cycles[caller] == self._cycles.get(called)

    @cached_property
    def _cycles(self) -> dict[str, int]:
        return cycles(self._first_calls)

    @cached_property
    def _first_calls(self) -> dict[str, set[str]]:
        """The functions that each function itself calls before it can return."""
        return {name: set(self._called_first(item.body)) for name, item in self.functions.items()}

    def _called_first(self, body: Body) -> Iterator[str]:
        for item in before_return(body):
            match item:
                case Perform(call=Call(name=name)) if name in self.functions:
                    yield name

    @cached_property
    def endless_functions(self) -> set[str]:
        """The functions that never return."""
        looping = [name for name, item in self.functions.items() if _loops(item.body)]
        return callers_of(looping, self._first_calls)

    def endless(self, body: tuple[Item, ...]) -> Iterator[While]:
        """The outermost loops of a body that never end once they have begun."""
        for item in body:
            if isinstance(item, While) and is_endless(item) and not self.leaves(item):
                yield item
            else:
                for inner in bodies(item):
                    yield from self.endless(inner)

    def leaves(self, loop: While) -> bool:
        """Whether a ``break``, a ``return``, or raw Python that may contain one, leaves a loop."""
        returns = any(
            isinstance(statement, Return | AnyPython) for statement in statements(loop.body)
        )
        return returns or breaks(loop.body)


def before_return(body: Body) -> Iterator[Statement]:
    """The statements of a body that run whenever it does, up to one that may contain a return."""
    for item in body:
        if any(isinstance(statement, Return | AnyPython) for statement in statements((item,))):
            return
        yield item


def _loops(body: Body) -> bool:
    """Whether a body never ends because of a loop of its own."""
    return any(
        isinstance(item, While) and is_endless(item) and not breaks(item.body)
        for item in before_return(body)
    )


def is_endless(loop: While) -> bool:
    """Whether the condition of a loop is always true, as in ``while 1 == 1:``."""
    return _truth(loop.condition) is True


def _truth(condition: Expression) -> bool | None:
    """Whether a condition without variables is true; None if that is not certain."""
    match condition:
        case Constant(value=value):
            return bool(value)
        case Unary(operator="not", operand=operand):
            truth = _truth(operand)
            return None if truth is None else not truth
        case Compare(operators=(operator,), operands=(left, right)) if operator in _ORDERS:
            values = constant(left), constant(right)
            same = isinstance(values[0], str) is isinstance(values[1], str)
            return _ORDERS[operator](*values) if same and None not in values else None
    literal = constant(condition)
    return None if literal is None else bool(literal)


def breaks(body: Body) -> bool:
    """Whether a ``break``, or raw Python that may contain one, leaves the loop of this body."""
    for item in body:
        if isinstance(item, Break | AnyPython):
            return True
        if not isinstance(item, LOOPS) and any(map(breaks, bodies(item))):
            return True
    return False


def _exits(body: Body, guards: tuple[Expression, ...]) -> Iterator[tuple[Expression, ...]]:
    """The conditions that lead to each way out of a loop, or to one that is not certain."""
    for item in body:
        if isinstance(item, Break | Return | AnyPython):
            yield guards
        elif isinstance(item, If):
            conditions: tuple[Expression, ...] = ()
            for branch in item.branches:
                conditions += (branch.condition,)
                yield from _exits(branch.body, guards + conditions)
            if item.otherwise is not None:
                yield from _exits(item.otherwise.body, guards + conditions)
        elif any(isinstance(statement, Return | AnyPython) for statement in statements((item,))):
            yield ()


def _root(node: Expression) -> str:
    """The variable whose items are changed, "" if there is none."""
    while isinstance(node, Index):
        node = node.value
    return node.name if isinstance(node, Name) else ""
