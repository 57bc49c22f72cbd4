"""Programs that do the right things at the wrong time, to the wrong side or in the wrong case.

Unlike `mutants`, which is a sample of all that learners do wrong, this makes all programs of a few
kinds that a check easily overlooks, as each of them has all parts of the correct one: what it shows
has changed places, it goes the other way, its statements are in another order, the halves of
a decision are exchanged, or a condition has another number.
"""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from itertools import combinations
from typing import Any, Literal

from learnblock.blocks import builtin
from learnblock.blocks.groups import group_of
from learnblock.language.blocktext.format import format as format_program
from learnblock.language.blocktext.parser import parse, recover
from learnblock.language.tree.flow import bounds, condition_of, conditions
from learnblock.language.tree.nodes import (
    Binary,
    Branch,
    Call,
    Compare,
    FString,
    If,
    Number,
    Perform,
    Program,
    SkillCall,
    String,
    Unary,
    When,
)
from learnblock.language.tree.traversal import within
from learnblock.lessons.mutants import SILENT, TURNED, Mutant, other_numbers
from learnblock.lessons.rewriting import places, sequences, substitute

#: Pairs that are swapped.
Kind = Literal["shown", "direction", "half", "order", "limit"]

#: The groups of blocks by which a robot shows something.
_SHOWING = {"show", "sound"}
_SIDES = (("left", "right"), ("Left", "Right"))
#: Which numbers of a skill have a direction.
_DIRECTED = {
    "move_straight": (0,),
    "move_left": (0, 1),
    "move_right": (0, 1),
    "turn_left": (0,),
    "turn_right": (0,),
    "turn": (0,),
    "set_move": (0, 1),
    "drive_distance": (0,),
    "drive_arc": (0, 1),
    "go_to": (0, 1),
}
#: Of these, the numbers that say to which side.
_SIDEWAYS = {"turn": 0, "set_move": 1, "drive_arc": 1}

#: What takes the place of nodes, by the identity of each.
_Changes = dict[int, Any]


def swaps(source: str) -> Iterator[tuple[Kind, Mutant]]:
    """Make all programs of these kinds that differ from a correct one, in its order.

    Args:
        source: the program in Block-Text.

    Raises:
        ProgramError: the program is invalid.
    """
    program = parse(source)
    sources = {format_program(program)}
    for kind, find in _KINDS.items():
        for changes, what in find(program):
            variant = format_program(substitute(program, changes))
            if variant not in sources and not recover(variant)[1]:
                sources.add(variant)
                yield kind, Mutant(variant, what)


def _exchanged(first: Any, second: Any) -> _Changes:
    return {id(first): second, id(second): first}


def _lines(first: Any, second: Any) -> str:
    return f"line {first.span.line} and {second.span.line}"


def _nodes(program: Program) -> list[Any]:
    return [place.node for place in places(program)]


# What it shows, says, plays or prints.


def _shown(program: Program) -> Iterator[tuple[_Changes, str]]:
    nodes = _nodes(program)
    calls = [node.call for node in nodes if isinstance(node, Perform) and _shows(node.call)]
    texts = [node for node in nodes if isinstance(node, String | FString)]
    for kind, nodes in (("shown things", calls), ("texts", texts)):
        for first, second in combinations(nodes, 2):
            yield _exchanged(first, second), f"{_lines(first, second)}: {kind} swapped"


def _shows(call: Call | SkillCall) -> bool:
    if isinstance(call, Call):
        return call.name == "print"
    skill = builtin().get(call.name)
    return call.name == "send" or (skill is not None and group_of(skill.category) in _SHOWING)


# Where it goes.


def _directions(program: Program) -> Iterator[tuple[_Changes, str]]:
    calls = [node for node in _nodes(program) if isinstance(node, SkillCall)]
    mirrored: _Changes = {}
    for call in calls:
        for number in _DIRECTED.get(call.name, ())[: len(call.arguments)]:
            value = call.arguments[number]
            yield {id(value): _negated(value)}, f"line {call.span.line}: {call.name} backwards"
        if (name := _other_side(call.name)) is not None:
            yield (
                {id(call): replace(call, name=name)},
                f"line {call.span.line}: {name} instead of {call.name}",
            )
        mirrored.update(_mirrored(call))
    yield mirrored, "left and right swapped everywhere"
    commands = {key: new for key, new in mirrored.items() if key in _commands(program)}
    yield commands, "left and right swapped in all movements"


def _negated(value: Any) -> Any:
    is_negative = isinstance(value, Unary) and value.operator == "-"
    return value.operand if is_negative else Unary("-", value)


def _other_side(name: str) -> str | None:
    for first, second in _SIDES:
        for here, there in ((first, second), (second, first)):
            if here in name and (new := name.replace(here, there)) in builtin():
                return new
    return None


def _mirrored(call: SkillCall) -> _Changes:
    """The call with the other side."""
    if (name := _other_side(call.name)) is not None:
        return {id(call): replace(call, name=name)}
    number = _SIDEWAYS.get(call.name)
    if number is None or number >= len(call.arguments):
        return {}
    arguments = list(call.arguments)
    arguments[number] = _negated(arguments[number])
    return {id(call): replace(call, arguments=tuple(arguments))}


def _commands(program: Program) -> set[int]:
    return {id(node.call) for node in _nodes(program) if isinstance(node, Perform)}


# In which order.


def _orders(program: Program) -> Iterator[tuple[_Changes, str]]:
    for sequence in sequences(program):
        nodes = [node for node in sequence.statements if not isinstance(node, SILENT)]
        for first, second in combinations(nodes, 2):
            yield _exchanged(first, second), f"{_lines(first, second)}: statements swapped"
    calls = [node for node in _nodes(program) if isinstance(node, Perform)]
    for first, second in combinations(calls, 2):
        yield _exchanged(first, second), f"{_lines(first, second)}: commands swapped"


# What it does in which case.


def _halves(program: Program) -> Iterator[tuple[_Changes, str]]:
    nodes = _nodes(program)
    for node in nodes:
        if isinstance(node, If):
            halves = [*node.branches, *([node.otherwise] if node.otherwise else [])]
            yield from _bodies(halves)
            yield from _negations(node.branches)
        elif not isinstance(node, Branch) and condition_of(node) is not None:
            yield from _negations([node])
    yield from _bodies([node for node in nodes if isinstance(node, When)])


def _bodies(halves: Sequence[Any]) -> Iterator[tuple[_Changes, str]]:
    for first, second in combinations(halves, 2):
        changes = {
            id(first): replace(first, body=second.body),
            id(second): replace(second, body=first.body),
        }
        yield changes, f"{_lines(first, second)}: what is inside swapped"


def _negations(nodes: Sequence[Any]) -> Iterator[tuple[_Changes, str]]:
    for node in nodes:
        condition = node.condition
        is_negative = isinstance(condition, Unary) and condition.operator == "not"
        new = condition.operand if is_negative else Unary("not", condition)
        yield {id(condition): new}, f"line {node.span.line}: condition negated"


# Up to where, how often, how near.


def _limits(program: Program) -> Iterator[tuple[_Changes, str]]:
    for node in _nodes(program):
        # An `if` is among the nodes with each of its branches.
        own_conditions = () if isinstance(node, If) else conditions(node)
        parts = (part for limit in (*own_conditions, *bounds(node)) for part in within(limit))
        for part in parts:
            for new, how in _other_limits(part):
                yield {id(part): new}, f"line {node.span.line}: {how}"


def _other_limits(part: Any) -> Iterator[tuple[Any, str]]:
    match part:
        case Number(text=text):
            for value, how in other_numbers(float(text)):
                yield Number(f"{value:g}"), f"limit {text} {how}"
            yield Number(f"{float(text) * 4:g}"), f"limit {text} four times as large"
            yield Number("0"), f"limit {text} is 0"
        case Compare(operators=(operator,)) if operator in TURNED:
            yield replace(part, operators=(TURNED[operator],)), f"{operator!r} is the other way"
        case Binary(operator="and" | "or" as operator):
            other = "or" if operator == "and" else "and"
            yield replace(part, operator=other), f"{operator!r} is {other!r}"


_KINDS: dict[Kind, Callable[[Program], Iterator[tuple[_Changes, str]]]] = {
    "shown": _shown,
    "direction": _directions,
    "half": _halves,
    "order": _orders,
    "limit": _limits,
}
