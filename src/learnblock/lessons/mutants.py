"""Wrong programs made from a correct one, to find out whether a lesson's checks notice.

A mutant differs by one mistake that learners make: a number, a side, a condition, a statement that
is missing, twice or in the wrong place, a loop that isn't one. Small programs give few of them, so
they get mutants with two mistakes as well.
"""

import random
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from itertools import islice
from typing import Any

from learnblock.blocks import BlockConfiguration, builtin
from learnblock.language.blocktext.format import format as format_program
from learnblock.language.blocktext.parser import parse, recover
from learnblock.language.tree.flow import is_loop
from learnblock.language.tree.nodes import (
    Activate,
    Assign,
    Binary,
    Blank,
    Branch,
    Break,
    Comment,
    Compare,
    Constant,
    Continue,
    Deactivate,
    Def,
    If,
    Import,
    Main,
    Number,
    Pass,
    Perform,
    Program,
    Repeat,
    Setup,
    SkillCall,
    String,
    Unary,
    WaitUntil,
    When,
    While,
    WithoutRobot,
)
from learnblock.lessons.rewriting import Slot, StatementSequence, places, sequences

#: Mutants with two mistakes are added until there are at least this many.
LEAST = 60
#: The number of mutants with one mistake that are changed again.
_CHANGED_AGAIN = 12
#: Up to this number, a mistake by one is a mistake.
_COUNTABLE = 12

#: Statements whose place doesn't matter.
SILENT = (Comment, Blank, Pass, WithoutRobot, Import, Setup, Def, When)
#: Parts of the names of skills that are easily confused.
_CONFUSED = (
    ("left", "right"),
    ("Left", "Right"),
    ("front", "back"),
    ("center", "left"),
    ("floor", "front"),
    ("Joy", "Sadness"),
    ("black", "red"),
    ("happy", "sad"),
    ("down", "up"),
)
_OPPOSITE = {"<": ">=", ">": "<=", "<=": ">", ">=": "<", "==": "!=", "!=": "=="}
TURNED = {"<": ">", ">": "<", "<=": ">=", ">=": "<="}


@dataclass(frozen=True, slots=True)
class Mutant:
    """A wrong program.

    Args:
        source: its Block-Text.
        what: how it differs from the correct one, such as ``line 3: number 40 negated``.
    """

    source: str
    what: str


#: The changed program, and what was changed.
_Change = tuple[Program, str]


def mutants(source: str, seed: int = 0) -> Iterator[Mutant]:
    """Make mutants of a correct program, all different, always the same ones in the same order.

    Args:
        source: the program in Block-Text.
        seed: of the order, so that the first ones are a sample.

    Raises:
        ProgramError: the program is invalid.
    """
    rng = random.Random(seed)  # noqa: S311 - an order, not a secret
    program = parse(source)
    sources = {format_program(program)}
    programs = list(_new(program, "", sources))
    if len(programs) < LEAST:
        again = list(programs)
        rng.shuffle(again)
        for mutant in again[:_CHANGED_AGAIN]:
            programs += islice(_new(parse(mutant.source), f"{mutant.what}; ", sources), LEAST)
        first, more = programs[: len(again)], programs[len(again) :]
        rng.shuffle(more)
        programs = first + more[: LEAST - len(first)]
    rng.shuffle(programs)
    yield from programs


def _new(program: Program, before: str, sources: set[str]) -> Iterator[Mutant]:
    """The mutants with one mistake more that are not among those seen."""
    for mutation, what in _changes(program):
        source = format_program(mutation)
        if source not in sources and not recover(source)[1]:
            sources.add(source)
            yield Mutant(source, before + what)


def _changes(program: Program) -> Iterator[_Change]:
    for place in places(program):
        for kind, change in _NODES.items():
            if isinstance(place.node, kind):
                for new, what in change(place.node):
                    yield place.put(new), f"line {_line(place)}: {what}"
    for sequence in sequences(program):
        for statements, index, what in _reordered(sequence):
            line = sequence.statements[index].span.line
            yield sequence.put(statements), f"line {line}: {what}"


def _line(place: Slot) -> int:
    line: int = place.node.span.line
    return line


# Values.


def _number(node: Number) -> Iterator[tuple[Any, str]]:
    try:
        value = float(node.text) if not node.text.isdigit() else int(node.text)
    except ValueError:
        return
    if value:
        yield Unary("-", node), f"number {node.text} negated"
        yield Number("0"), f"number {node.text} is 0"
    for other, how in other_numbers(value):
        yield Number(f"{other:g}"), f"number {node.text} {how}"


def other_numbers(value: float) -> Iterator[tuple[float, str]]:
    """Numbers that learners write instead of another, and how each differs."""
    if value == int(value) and 0 < value <= _COUNTABLE:
        yield value + 1, "one more"
        yield value - 1, "one less"
    if value:
        yield value / 2 if value % 2 else value // 2, "halved"
        yield value * 2, "doubled"
    else:
        yield 1, "is 1"


def _string(node: String) -> Iterator[tuple[Any, str]]:
    if len(node.value) > 1:
        yield String(node.value[1:]), "text without its first letter"
        middle = len(node.value) // 2
        typo = node.value[:middle] + node.value[middle + 1 :]
        yield String(typo), "text with a letter missing"
    yield String("something"), "another text"


def _sign(node: Unary) -> Iterator[tuple[Any, str]]:
    yield node.operand, f"without {node.operator!r}"


def _binary(node: Binary) -> Iterator[tuple[Any, str]]:
    other = {"and": "or", "or": "and", "+": "-", "-": "+", "*": "/", "/": "*"}.get(node.operator)
    if other:
        yield replace(node, operator=other), f"{node.operator!r} is {other!r}"
    if node.operator in {"and", "or"}:
        yield node.left, "second part of the condition missing"
        yield node.right, "first part of the condition missing"


def _compare(node: Compare) -> Iterator[tuple[Any, str]]:
    for table in (_OPPOSITE, TURNED):
        for index, operator in enumerate(node.operators):
            if operator in table:
                operators = list(node.operators)
                operators[index] = table[operator]
                new = replace(node, operators=tuple(operators))
                yield new, f"{operator!r} is {table[operator]!r}"


def _constant(node: Constant) -> Iterator[tuple[Any, str]]:
    if isinstance(node.value, bool):
        yield Constant(not node.value), f"{node.value} is {not node.value}"


# Calls.


def _skill_call(node: SkillCall) -> Iterator[tuple[Any, str]]:
    skills = builtin()
    for first, second in _CONFUSED:
        for wrong, right in ((first, second), (second, first)):
            name = node.name.replace(right, wrong)
            if name != node.name and name in skills and _fits(node, skills[name]):
                yield replace(node, name=name), f"{name} instead of {node.name}"
    if node.name in skills:
        yield from _given(node, skills[node.name])
    if len(node.arguments) > 1:
        swapped = (node.arguments[1], node.arguments[0], *node.arguments[2:])
        yield replace(node, arguments=swapped), "arguments swapped"


def _fits(call: SkillCall, skill: BlockConfiguration) -> bool:
    needed = sum(parameter.required for parameter in skill.parameters)
    return needed <= len(call.arguments) <= len(skill.parameters) and not call.keywords


def _given(call: SkillCall, skill: BlockConfiguration) -> Iterator[tuple[Any, str]]:
    """The call with another value for the first parameter that it leaves out."""
    left_out = skill.parameters[len(call.arguments) : len(call.arguments) + 1]
    for parameter in left_out:
        default = parameter.default
        if call.keywords or isinstance(default, bool) or not isinstance(default, int | float):
            continue
        for value, how in ((-default, "negated"), (default * 3, "three times as large")):
            new: Any = Number(f"{abs(value):g}")
            new = Unary("-", new) if value < 0 else new
            yield replace(call, arguments=(*call.arguments, new)), f"{parameter.name} {how}"


# Statements.


def _conditional(node: Any) -> Iterator[tuple[Any, str]]:
    """A statement with a condition, with others."""
    if node.condition is None:
        return
    condition = node.condition
    if not isinstance(condition, Constant):
        opposite = (
            condition.operand
            if isinstance(condition, Unary) and condition.operator == "not"
            else Unary("not", condition)
        )
        yield replace(node, condition=opposite), "condition negated"
        yield replace(node, condition=Constant(value=True)), "condition always true"
        yield replace(node, condition=Constant(value=False)), "condition never true"


def _if(node: If) -> Iterator[tuple[Any, str]]:
    if len(node.branches) > 1:
        for index in range(len(node.branches)):
            branches = node.branches[:index] + node.branches[index + 1 :]
            yield replace(node, branches=branches), "a branch missing"
        first, second, *rest = node.branches
        swapped = (replace(first, body=second.body), replace(second, body=first.body), *rest)
        yield replace(node, branches=swapped), "branches swapped"
    if node.otherwise is not None:
        yield replace(node, otherwise=None), "'else' missing"
        last = node.branches[-1]
        branches = (*node.branches[:-1], replace(last, body=node.otherwise.body))
        otherwise = replace(node.otherwise, body=last.body)
        yield replace(node, branches=branches, otherwise=otherwise), "'else' swapped"
    else:
        branch = node.branches[0]
        yield While(branch.condition, branch.body), "'while' instead of 'if'"


def _while(node: While) -> Iterator[tuple[Any, str]]:
    yield If((Branch(node.condition, node.body),)), "'if' instead of the loop"
    if node.is_endless:
        yield Repeat(Number("3"), node.body), "3 times instead of forever"
    else:
        yield replace(node, condition=Constant(value=True)), "forever"


def _repeat(node: Repeat) -> Iterator[tuple[Any, str]]:
    yield Repeat(Number("1"), node.body), "only once"
    yield While(Constant(value=True), node.body), "forever"


def _assign(node: Assign) -> Iterator[tuple[Any, str]]:
    if node.operator != "=":
        yield replace(node, operator="="), f"'=' instead of {node.operator!r}"
        other = {"+=": "-=", "-=": "+="}.get(node.operator)
        if other:
            yield replace(node, operator=other), f"{other!r} instead of {node.operator!r}"


def _activation(node: Activate | Deactivate) -> Iterator[tuple[Any, str]]:
    other = Deactivate if isinstance(node, Activate) else Activate
    yield other(node.name), "activate and deactivate confused"


def _wait_until(node: WaitUntil) -> Iterator[tuple[Any, str]]:
    yield from _conditional(node)
    yield Perform(SkillCall("sleep", (Number("1"),))), "a wait of a second instead"


_NODES: dict[type, Callable[[Any], Iterator[tuple[Any, str]]]] = {
    Number: _number,
    String: _string,
    Unary: _sign,
    Binary: _binary,
    Compare: _compare,
    Constant: _constant,
    SkillCall: _skill_call,
    Branch: _conditional,
    If: _if,
    When: _conditional,
    WaitUntil: _wait_until,
    Repeat: _repeat,
    Assign: _assign,
    Activate: _activation,
    Deactivate: _activation,
}


def _loop(node: While) -> Iterator[tuple[Any, str]]:
    if not node.is_endless:
        yield from _conditional(node)
    yield from _while(node)


_NODES[While] = _loop


# Sequences of statements. Each change is the new sequence, where it was changed, and how.


def _reordered(sequence: StatementSequence) -> Iterator[tuple[tuple[Any, ...], int, str]]:
    statements = sequence.statements
    for index, statement in enumerate(statements):
        before, after = statements[:index], statements[index + 1 :]
        if isinstance(statement, Comment | Blank | WithoutRobot | Import | Setup):
            continue
        if not isinstance(statement, Def | When):
            yield (*before, *after) or (Pass(),), index, "statement missing"
        if isinstance(statement, SILENT):
            continue
        yield (*before, statement, *statements[index:]), index, "statement twice"
        if after and not isinstance(after[0], SILENT):
            yield (*before, after[0], statement, *after[1:]), index, "statements swapped"
        yield from _moved(sequence, index)
    yield from _wrapped(sequence)


def _moved(sequence: StatementSequence, index: int) -> Iterator[tuple[tuple[Any, ...], int, str]]:
    """A loop that has one statement more or less."""
    loop = sequence.statements[index]
    if not is_loop(loop):
        return
    before, after = sequence.statements[:index], sequence.statements[index + 1 :]
    if len(loop.body) > 1:
        outer = (*before, replace(loop, body=loop.body[:-1]), loop.body[-1], *after)
        yield outer, index, "last statement outside the loop"
        outer = (*before, loop.body[0], replace(loop, body=loop.body[1:]), *after)
        yield outer, index, "first statement before the loop"
    if after and not isinstance(after[0], SILENT):
        inner = replace(loop, body=(*loop.body, after[0]))
        yield (*before, inner, *after[1:]), index, "next statement in the loop"
    inner_only = (*before, *(node for node in loop.body if not isinstance(node, Break | Continue)))
    yield (*inner_only, *after), index, "loop missing"


def _wrapped(sequence: StatementSequence) -> Iterator[tuple[tuple[Any, ...], int, str]]:
    statements: Any = sequence.statements
    if not statements or not isinstance(sequence.owner, Main | When):
        return
    yield (Repeat(Number("2"), statements),), 0, "everything twice"
    if not any(isinstance(node, While) and node.is_endless for node in statements):
        yield (While(Constant(value=True), statements),), 0, "everything forever"
    for index in range(1, len(statements)):
        if not isinstance(statements[index - 1], SILENT):
            yield statements[:index], index, "everything from here missing"
