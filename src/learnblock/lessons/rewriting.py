"""Replace nodes of a program."""

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, fields, is_dataclass, replace
from typing import Any

from learnblock.language.tree.nodes import Item, Program


@dataclass(frozen=True, slots=True)
class Slot:
    """A node in a program, and how the program looks with another node there.

    Args:
        node: the node.
        put: returns the program with another node in its place.
    """

    node: Any
    put: Callable[[Any], Program]


@dataclass(frozen=True, slots=True)
class StatementSequence:
    """Statements that run one after another: a body, or the top level.

    Args:
        statements: the statements.
        owner: the node that has them.
        put: returns the program with other statements in their place.
    """

    statements: tuple[Item, ...]
    owner: Any
    put: Callable[[tuple[Any, ...]], Program]


def places(program: Program) -> Iterator[Slot]:
    """Every node of a program, the outer ones first, in source order."""
    yield from _places(program, lambda new: replace(new, python=None))


def sequences(program: Program) -> Iterator[StatementSequence]:
    """Every sequence of statements, the outer ones first, in source order."""
    for place in places(program):
        for name in ("items", "body"):
            statements = getattr(place.node, name, None)
            if isinstance(statements, tuple) and not _is_list(place.node):
                yield StatementSequence(statements, place.node, _putter(place, name))


def substitute(program: Program, changes: Mapping[int, Any]) -> Program:
    """The program with other nodes in the place of some.

    Args:
        program: the program.
        changes: the nodes instead, by the identity of each; nothing inside them is changed.
    """
    result: Program = _substituted(replace(program, python=None), changes)
    return result


def _substituted(node: Any, changes: Mapping[int, Any]) -> Any:
    if isinstance(node, tuple) and not hasattr(node, "_fields"):
        return tuple(_substituted(part, changes) for part in node)
    if not is_dataclass(node) or isinstance(node, type):
        return node
    if id(node) in changes:
        return changes[id(node)]
    parts = {field.name: getattr(node, field.name) for field in fields(node)}
    return replace(node, **{key: _substituted(part, changes) for key, part in parts.items()})


def _is_list(node: Any) -> bool:
    """Whether its items are values."""
    return not isinstance(node, Program) and not hasattr(node, "body")


def _putter(place: Slot, name: str) -> Callable[[tuple[Any, ...]], Program]:
    return lambda statements: place.put(replace(place.node, **{name: statements}))


def _places(node: Any, put: Callable[[Any], Program]) -> Iterator[Slot]:
    yield Slot(node, put)
    for field in fields(node):
        value = getattr(node, field.name)
        # The span of a node is a tuple of numbers.
        if isinstance(value, tuple):
            for index, part in enumerate(value):
                if is_dataclass(part):
                    yield from _places(part, _part_putter(node, put, field.name, index))
        elif is_dataclass(value):
            yield from _places(value, _field_putter(node, put, field.name))


def _field_putter(node: Any, put: Callable[[Any], Program], name: str) -> Callable[[Any], Program]:
    return lambda new: put(replace(node, **{name: new}))


def _part_putter(
    node: Any, put: Callable[[Any], Program], name: str, index: int
) -> Callable[[Any], Program]:
    def changed(new: Any) -> Program:
        parts = getattr(node, name)
        return put(replace(node, **{name: (*parts[:index], new, *parts[index + 1 :])}))

    return changed
