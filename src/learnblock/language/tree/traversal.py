"""Find the statements and expressions inside the nodes of a tree."""

from collections.abc import Callable, Iterator
from dataclasses import fields, is_dataclass, replace
from typing import Any, TypeVar, cast

from learnblock.language.tree.nodes import (
    Assign,
    Binary,
    Body,
    Call,
    Compare,
    Conditional,
    Def,
    Dictionary,
    Expression,
    ForEach,
    ForRange,
    FString,
    If,
    Index,
    Item,
    List,
    Main,
    Name,
    Perform,
    PythonBlock,
    Repeat,
    Return,
    Setup,
    SkillCall,
    Span,
    Unary,
    WaitUntil,
    When,
    While,
)

Moved = TypeVar("Moved", bound=Any)


def targets(node: Item | Main) -> tuple[Name, ...]:
    """The variables that a statement itself sets, where it names them."""
    match node:
        case Assign(target=Name() as target) | ForRange(target=target):
            return (target,)
        case ForEach(targets=names):
            return names
    return ()


def set_by(node: Item | Main) -> tuple[str, ...]:
    """The names of the variables that a statement itself sets; its bodies are ignored."""
    return tuple(target.name for target in targets(node))


def locals_in(body: Body) -> dict[str, Name]:
    """The variables that a function has for itself, each where it is first set."""
    own = (
        item
        for item in own_statements(body)
        if isinstance(item, ForEach | ForRange) or (isinstance(item, Assign) and item.is_local)
    )
    names: dict[str, Name] = {}
    for item in own:
        for target in targets(item):
            names.setdefault(target.name, target)
    return names


def _if_bodies(node: If) -> tuple[Body, ...]:
    bodies = tuple(branch.body for branch in node.branches)
    return bodies if node.otherwise is None else (*bodies, node.otherwise.body)


def _own_body(node: Any) -> tuple[Body, ...]:
    return (node.body,)


_BODIES: dict[type, Callable[[Any], tuple[Body, ...]]] = {
    If: _if_bodies,
    While: _own_body,
    Repeat: _own_body,
    ForEach: _own_body,
    ForRange: _own_body,
    Def: _own_body,
    When: _own_body,
    Main: _own_body,
    PythonBlock: lambda node: tuple(part.body for part in node.parts),
}


def bodies(node: Item | Main) -> tuple[Body, ...]:
    """The bodies directly inside a statement or an item of the top level, in order."""
    get = _BODIES.get(type(node))
    return () if get is None else get(node)


def statements(body: tuple[Item, ...]) -> Iterator[Item]:
    """Every statement of a body and of the bodies inside it, in source order."""
    ahead: list[Item] = list(reversed(body))
    while ahead:
        statement = ahead.pop()
        yield statement
        for inner in reversed(bodies(statement)):
            ahead.extend(reversed(inner))


def own_statements(body: tuple[Item, ...]) -> Iterator[Item]:
    """Every statement of a body that shares its variables: without those of inner functions."""
    return _statements_outside(body, lambda block: block.has_scope)


def statements_at_once(body: tuple[Item, ...]) -> Iterator[Item]:
    """The statements that run when a body does: not those of the functions in it."""
    return _statements_outside(body, lambda block: block.defers)


def _statements_outside(
    body: tuple[Item, ...], is_apart: Callable[[PythonBlock], bool]
) -> Iterator[Item]:
    """Every statement of a body, without those inside blocks of Python that are apart."""
    for statement in body:
        yield statement
        if not (isinstance(statement, PythonBlock) and is_apart(statement)):
            for inner in bodies(statement):
                yield from _statements_outside(inner, is_apart)


def _range_parts(node: ForRange) -> tuple[Expression, ...]:
    parts = (node.target, node.start, node.stop)
    return parts if node.step is None else (*parts, node.step)


def _optional(value: Expression | None) -> tuple[Expression, ...]:
    return () if value is None else (value,)


def _arguments(node: Any) -> tuple[Expression, ...]:
    if not node.keywords:
        return cast("tuple[Expression, ...]", node.arguments)
    return (*node.arguments, *(keyword.value for keyword in node.keywords))


def _entries(node: Dictionary) -> tuple[Expression, ...]:
    """The keys and values, in the order of the source."""
    return tuple(part for pair in zip(node.keys, node.values, strict=True) for part in pair)


_EXPRESSIONS: dict[type, Callable[[Any], tuple[Expression, ...]]] = {
    Perform: lambda node: (node.call,),
    Assign: lambda node: (node.target, node.value),
    If: lambda node: tuple(branch.condition for branch in node.branches),
    While: lambda node: (node.condition,),
    Repeat: lambda node: (node.count,),
    ForEach: lambda node: (*node.targets, node.values),
    ForRange: _range_parts,
    WaitUntil: lambda node: (node.condition,),
    Return: lambda node: _optional(node.value),
    When: lambda node: _optional(node.condition),
    Setup: _arguments,
}
_OPERANDS: dict[type, Callable[[Any], tuple[Expression, ...]]] = {
    Call: _arguments,
    SkillCall: _arguments,
    FString: lambda node: node.parts,
    List: lambda node: node.items,
    Dictionary: _entries,
    Index: lambda node: (node.value, node.index),
    Unary: lambda node: (node.operand,),
    Binary: lambda node: (node.left, node.right),
    Compare: lambda node: node.operands,
    Conditional: lambda node: (node.yes, node.condition, node.no),
}


def expressions(node: Item | Main) -> tuple[Expression, ...]:
    """The expressions of a statement, except those in its bodies."""
    get = _EXPRESSIONS.get(type(node))
    return () if get is None else get(node)


def read_expressions(node: Item | Main) -> tuple[Expression, ...]:
    """The expressions whose values a statement needs, except those in its bodies.

    ``x += 1`` needs its target's, and ``x = 1`` does not.
    """
    parts = expressions(node)
    is_changed = isinstance(node, Assign) and node.operator != "="
    # A statement's targets are its first expressions.
    return parts if is_changed else parts[len(targets(node)) :]


def all_expressions(node: Item | Main) -> Iterator[Expression]:
    """The expressions of a statement and those inside them, except those in its bodies."""
    for expression in expressions(node):
        yield from within(expression)


def moved(expression: Moved, span: Span) -> Moved:
    """An expression with all its parts at one place."""
    changed: dict[str, Any] = {"span": span}
    for field in fields(expression):
        value = getattr(expression, field.name)
        if isinstance(value, tuple) and field.name != "span":
            changed[field.name] = tuple(
                moved(part, span) if is_dataclass(part) else part for part in value
            )
        elif is_dataclass(value):
            changed[field.name] = moved(value, span)
    return replace(expression, **changed)


def within(expression: Expression) -> list[Expression]:
    """An expression and all expressions inside it."""
    nodes = [expression]
    for node in nodes:
        get = _OPERANDS.get(type(node))
        if get is not None:
            nodes.extend(get(node))
    return nodes


def evaluated(expression: Expression) -> Iterator[Expression]:
    """An expression and all expressions inside it, in the order in which their values are found."""
    nodes: list[Expression] = []
    ahead = [expression]
    while ahead:
        node = ahead.pop()
        nodes.append(node)
        get = _OPERANDS.get(type(node))
        if get is not None:
            ahead.extend(get(node))
    return reversed(nodes)
