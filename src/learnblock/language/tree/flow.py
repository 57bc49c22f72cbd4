"""What a statement does with the flow of a program; who asks here needs no list of statements."""

from collections.abc import Iterator
from typing import Any, TypeGuard

from learnblock.language.tree.nodes import (
    Branch,
    Expression,
    ForEach,
    ForRange,
    If,
    Repeat,
    WaitUntil,
    When,
    While,
)

Counted = Repeat | ForEach | ForRange
Loop = While | Counted


def is_loop(node: Any) -> TypeGuard[Loop]:
    """Whether it may run its body several times, one after the other."""
    return isinstance(node, Loop)


def is_counted(node: Any) -> TypeGuard[Counted]:
    """Whether it is a loop that knows its rounds before the first."""
    return isinstance(node, Counted)


def is_endless(node: Any) -> TypeGuard[Loop]:
    """Whether it is a loop that only a ``break`` or a ``return`` can leave."""
    return isinstance(node, While) and node.is_endless


def is_waiting(node: Any) -> bool:
    """Whether it only lets time pass, until something happens."""
    return isinstance(node, WaitUntil)


def condition_of(node: Any) -> Expression | None:
    """What a loop, a wait, a `when` or a branch asks before it goes on, if it asks anything."""
    return node.condition if isinstance(node, While | WaitUntil | When | Branch) else None


def conditions(node: Any) -> Iterator[Expression]:
    """All that a statement asks before it goes on: an `if` asks once for each of its branches."""
    for part in node.branches if isinstance(node, If) else (node,):
        if (condition := condition_of(part)) is not None:
            yield condition


def bounds(node: Any) -> tuple[Expression, ...]:
    """The numbers that say how often a loop runs, where it names them."""
    match node:
        case Repeat(count=count):
            return (count,)
        case ForRange(start=start, stop=stop):
            return (start, stop)
    return ()
