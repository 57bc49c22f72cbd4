"""Other correct programs made from a correct one, to find out whether a lesson's checks refuse any.

A variation does the same in another way: other names, another kind of loop, a wait in two parts, a
function for a part of the program, a number in a variable, a condition the other way round, events
instead of a decision.
"""

import random
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from functools import reduce
from itertools import count, pairwise
from typing import Any

from learnblock.errors import LearnBlockError
from learnblock.language.blocktext.format import format as format_program
from learnblock.language.blocktext.parser import parse, recover
from learnblock.language.edit.rename import Sort, rename
from learnblock.language.edit.symbols import Symbols
from learnblock.language.tree.nodes import (
    Assign,
    Binary,
    Branch,
    Break,
    Comment,
    Compare,
    Constant,
    Continue,
    Def,
    Else,
    Expression,
    ForEach,
    ForRange,
    If,
    Main,
    Name,
    Number,
    Perform,
    Program,
    Repeat,
    Return,
    SkillCall,
    Unary,
    WaitUntil,
    When,
    While,
)
from learnblock.language.tree.nodes import Call as FunctionCall
from learnblock.language.tree.traversal import statements
from learnblock.lessons.rewriting import StatementSequence, places, sequences

#: Longer loops would not be written out by hand.
_FEW = 4
_OPPOSITE = {"<": ">=", ">": "<=", "<=": ">", ">=": "<", "==": "!=", "!=": "=="}
_TURNED = {"<": ">", ">": "<", "<=": ">=", ">=": "<=", "==": "==", "!=": "!="}


@dataclass(frozen=True, slots=True)
class Variation:
    """Another correct program.

    Args:
        source: its Block-Text.
        what: how it differs, such as ``line 3: a wait in two parts``.
        without: what it no longer has: ``repeat`` or ``loop`` if another construct replaces it. A
            check may ask for that.
    """

    source: str
    what: str
    without: frozenset[str] = frozenset()


#: A changed node or program, what was changed, and what it no longer has.
_Change = tuple[Any, str, frozenset[str]]
_NONE: frozenset[str] = frozenset()


def variations(source: str, seed: int = 0) -> Iterator[Variation]:
    """Make other correct programs, all different, always the same ones in the same order.

    Those with one difference come first, then those with two, and so on: take as many as needed.

    Args:
        source: the program in Block-Text.
        seed: of the order.

    Raises:
        ProgramError: the program is invalid.
    """
    rng = random.Random(seed)  # noqa: S311 - an order, not a secret
    sources = {format_program(parse(source))}
    round_: list[Variation] = [Variation(source, "")]
    while round_:
        others = [new for variation in round_ for new in _new(variation, sources)]
        rng.shuffle(others)
        yield from others
        # Every further round makes some hundred from each: a few go on.
        round_ = others[:20]


def _new(before: Variation, sources: set[str]) -> Iterator[Variation]:
    program = parse(before.source)
    for variant, what, without in _changes(program):
        source = format_program(variant)
        if source not in sources and not recover(source)[1]:
            sources.add(source)
            text = f"{before.what}; {what}" if before.what else what
            yield Variation(source, text, before.without | without)


def _changes(program: Program) -> Iterator[_Change]:
    for place in places(program):
        node, line = place.node, place.node.span.line
        for kind, change in _NODES.items():
            if isinstance(node, kind):
                for new, what, without in change(node):
                    yield place.put(new), f"line {line}: {what}", without
    for sequence in sequences(program):
        yield from _in_sequence(program, sequence)
    yield from _renamed(program)
    yield from _number_in_variable(program)
    yield from _as_events(program)


# Names.


def _renamed(program: Program) -> Iterator[_Change]:
    symbols = Symbols(program)
    kinds: tuple[tuple[Sort, Any], ...] = (
        ("variable", symbols.variables),
        ("function", symbols.functions),
    )
    for sort, names in kinds:
        for name in names:
            try:
                yield rename(program, sort, name, f"my_{name}"), f"{name} renamed", _NONE
            except LearnBlockError:
                continue


def _new_name(program: Program, start: str) -> str:
    text = format_program(program)
    return next(name for n in count(1) if (name := f"{start}{n}") not in text)


def _number_in_variable(program: Program) -> Iterator[_Change]:
    """A number that a skill is given, in a variable that is set first."""
    if not isinstance(program.main, Main):
        return
    name = _new_name(program, "number_")
    for place in places(program):
        call = place.node
        if not isinstance(call, SkillCall) or not call.arguments:
            continue
        first = call.arguments[0]
        if isinstance(first, Number):
            variant = place.put(replace(call, arguments=(Name(name), *call.arguments[1:])))
            setting = Assign(Name(name), "=", first)
            items = (*_imports(variant), setting, *_rest(variant))
            yield replace(variant, items=items), f"number {first.text} in a variable", _NONE


def _is_heading(item: Any) -> bool:
    return type(item).__name__ in {"WithoutRobot", "Import", "Setup"}


def _imports(program: Program) -> tuple[Any, ...]:
    return tuple(item for item in program.items if _is_heading(item))


def _rest(program: Program) -> tuple[Any, ...]:
    return tuple(item for item in program.items if not _is_heading(item))


# Events.


def _as_events(program: Program) -> Iterator[_Change]:
    """A decision that a program makes forever, as an event for each of its cases."""
    match program.main:
        case Main(body=(*before, While(body=(If() as decision, *after)) as loop)):
            pass
        case _:
            return
    if not loop.is_endless or decision.otherwise is None or _leaves_or_goes_on(loop.body):
        return
    cases = [(branch.condition, branch.body) for branch in decision.branches]
    cases.append((Constant(value=True), decision.otherwise.body))
    earlier: tuple[Expression, ...] = ()
    whens = []
    for number, (condition, body) in enumerate(cases, 1):
        parts = [_opposite(former) for former in earlier]
        if number < len(cases):
            parts.append(condition)
        state = reduce(lambda left, right: Binary("and", left, right), parts)
        whens.append(When(_new_name(program, f"case_{number}"), state, (*body, *after)))
        earlier = (*earlier, condition)
    start = (When("start", None, tuple(before)),) if before else ()
    variant = replace(program, items=(*program.items, *start, *whens), main=None)
    yield variant, "an event for each case", frozenset({"loop", "forever", "if", "else"})


# Loops and conditions.


def _endless(node: While) -> Iterator[_Change]:
    if node.is_endless:
        always = Compare(("==",), (Number("1"), Number("1")))
        yield (
            replace(node, condition=always),
            "a loop with a condition that holds",
            frozenset({"forever"}),
        )
    elif not _leaves_or_goes_on(node.body):
        leave = If((Branch(_opposite(node.condition), (Break(),)),))
        body = (leave, *node.body)
        yield While(Constant(value=True), body), "a loop that is left inside", _NONE


def _counted(node: Repeat) -> Iterator[_Change]:
    if not isinstance(node.count, Number) or not node.count.text.isdigit():
        return
    name = _unused_in(node, "turn_")
    counted = ForRange(Name(name), Number("1"), node.count, None, node.body)
    yield counted, "a loop that counts", frozenset({"repeat"})


def _unused_in(node: Repeat, start: str) -> str:
    text = repr(node)
    return next(name for n in count(1) if (name := f"{start}{n}") not in text)


def _leaves_or_goes_on(body: tuple[Any, ...]) -> bool:
    return any(isinstance(node, Break | Continue | Return) for node in statements(body))


def _if(node: If) -> Iterator[_Change]:
    if len(node.branches) == 1 and node.otherwise is not None:
        branch, otherwise = node.branches[0], node.otherwise
        turned = Branch(_opposite(branch.condition), otherwise.body)
        yield If((turned,), Else(branch.body)), "condition the other way round", _NONE
    if len(node.branches) > 1:
        first, *rest = node.branches
        inner = If(tuple(rest), node.otherwise)
        yield If((first,), Else((inner,))), "'elif' as 'if' in 'else'", _NONE


def _opposite(condition: Expression) -> Expression:
    match condition:
        case Unary(operator="not", operand=operand):
            return operand
        case Compare(operators=(operator,), operands=operands) if operator in _OPPOSITE:
            return Compare((_OPPOSITE[operator],), operands)
        case _:
            return Unary("not", condition)


def _wait_until(node: WaitUntil) -> Iterator[_Change]:
    wait = Perform(SkillCall("sleep", (Number("0.02"),)))
    yield While(_opposite(node.condition), (wait,)), "a loop that waits", _NONE


def _compare(node: Compare) -> Iterator[_Change]:
    if len(node.operators) == 1 and node.operators[0] in _TURNED:
        left, right = node.operands
        turned = Compare((_TURNED[node.operators[0]],), (right, left))
        yield turned, "comparison the other way round", _NONE


def _both(node: Binary) -> Iterator[_Change]:
    if node.operator in {"and", "or"}:
        other = "or" if node.operator == "and" else "and"
        inner = Binary(other, _opposite(node.left), _opposite(node.right))
        yield Unary("not", inner), f"{node.operator!r} by {other!r}", _NONE


def _assign(node: Assign) -> Iterator[_Change]:
    operator = node.operator.removesuffix("=")
    if operator in {"+", "-", "*"} and isinstance(node.target, Name):
        value = Binary(operator, node.target, node.value)
        yield Assign(node.target, "=", value), f"{node.operator!r} written out", _NONE


_NODES: dict[type, Callable[[Any], Iterator[_Change]]] = {
    While: _endless,
    Repeat: _counted,
    If: _if,
    WaitUntil: _wait_until,
    Compare: _compare,
    Binary: _both,
    Assign: _assign,
}


# Sequences of statements.


def _in_sequence(program: Program, sequence: StatementSequence) -> Iterator[_Change]:
    for index, statement in enumerate(sequence.statements):
        before, after = sequence.statements[:index], sequence.statements[index + 1 :]
        line = f"line {statement.span.line}"
        for new, what, without in _instead(statement):
            yield sequence.put((*before, *new, *after)), f"{line}: {what}", without
    if isinstance(sequence.owner, Main | When):
        yield sequence.put((Comment("My program"), *sequence.statements)), "a comment", _NONE
        yield from _extracted(program, sequence)


def _instead(statement: Any) -> Iterator[tuple[tuple[Any, ...], str, frozenset[str]]]:
    match statement:
        case Perform(call=SkillCall(name="sleep", arguments=(Number() as seconds,))):
            half = Perform(SkillCall("sleep", (Number(f"{float(seconds.text) / 2:g}"),)))
            # Shorter waits are the steps of a loop.
            if float(seconds.text) >= 0.1:
                yield (half, half), "a wait in two parts", _NONE
        case Perform(call=SkillCall(name="stop_bot", arguments=())):
            stop = SkillCall("set_move", (Number("0"), Number("0")))
            yield (Perform(stop),), "stopped by its speed", _NONE
            yield (statement, statement), "stopped twice", _NONE
        case Perform(call=SkillCall(name="turn_90_right" | "turn_90_left" | "turn_back" as name)):
            angles = {"turn_90_right": "90", "turn_90_left": "90", "turn_back": "180"}
            angle: Any = Number(angles[name])
            angle = Unary("-", angle) if name == "turn_90_left" else angle
            yield (Perform(SkillCall("turn", (angle,))),), "turned by its angle", _NONE
        case Perform(call=SkillCall(name="turn", arguments=(Number(text="180"),))):
            around = SkillCall("turn", (Unary("-", Number("180")),))
            yield (Perform(around),), "turned around to the left", _NONE
        case Repeat(count=Number(text=text), body=body) if text.isdigit():
            if not _leaves_or_goes_on(body):
                yield _counting(statement), "a counter in a loop", frozenset({"repeat"})
            if 0 < int(text) <= _FEW and not _leaves_or_goes_on(body):
                yield body * int(text), "written out", frozenset({"repeat", "loop"})
                fewer = Repeat(Number(f"{int(text) - 1}"), body)
                yield (fewer, *body), "the last round written out", _NONE


def _counting(node: Repeat) -> tuple[Any, ...]:
    """The same loop with a variable that counts its rounds."""
    name = Name(_unused_in(node, "round_"))
    count_on = Assign(name, "+=", Number("1"))
    loop = While(Compare(("<",), (name, node.count)), (*node.body, count_on))
    return Assign(name, "=", Number("0")), loop


def _extracted(program: Program, sequence: StatementSequence) -> Iterator[_Change]:
    """Two statements as a function of their own."""
    name = _new_name(program, "part_")
    body: Any = sequence.statements
    for index, pair in enumerate(pairwise(body)):
        if _is_local(pair):
            continue
        before, after = sequence.statements[:index], sequence.statements[index + 2 :]
        variant = sequence.put((*before, Perform(FunctionCall(name)), *after))
        items = (*variant.items, Def(name, (), pair))
        line = pair[0].span.line
        yield replace(variant, items=items), f"line {line}: a function for two statements", _NONE


def _is_local(pair: tuple[Any, ...]) -> bool:
    """Whether statements mean something else in a function: jumps, and what belongs to the top."""
    inner = list(statements(pair))
    return _leaves_or_goes_on(tuple(inner)) or any(
        isinstance(node, Def | When | ForEach | ForRange | Comment) for node in inner
    )
