"""The blank lines of the top level: those from the layout and those from the author.

A blank line separates definitions, ``main`` and the robot's setup; a comment directly above one
belongs to it. These blank lines are not in the tree, so that adding them does not change it.
"""

from collections.abc import Iterable, Sequence
from typing import NamedTuple

from learnblock.language.tree.nodes import (
    Blank,
    Comment,
    Def,
    Import,
    Item,
    Main,
    PythonBlock,
    PythonLine,
    Setup,
    When,
    WithoutRobot,
)

SET_APART = (Def, When, Main, Setup)


class Placed(NamedTuple):
    """An item and its separation from the previous one.

    Args:
        item: anything but a `Blank`.
        apart: whether the layout separates it from the previous one.
        blank: whether the author wrote a blank line before it.
        leads: the definition that it is or, for a comment, that it is directly above.
    """

    item: Item | Main
    apart: bool
    blank: bool
    leads: Item | Main | None


def is_definition(item: Item | Main | None) -> bool:
    """Whether an item of the top level defines a function, an event or a class."""
    return isinstance(item, Def | When) or (isinstance(item, PythonBlock) and item.has_scope)


def placed(items: Sequence[Item | Main]) -> list[Placed]:
    """Every item except `Blank`, and its separation from the previous one."""
    result: list[Placed] = []
    previous: Item | Main | None = None
    blank = False
    for item, leads in zip(items, _leads(items), strict=True):
        if isinstance(item, Blank):
            blank = previous is not None
            continue
        apart = previous is not None and _apart(previous, item, leads)
        result.append(Placed(item, apart, blank, leads))
        previous, blank = item, False
    return result


def normalized(items: Iterable[Item | Main]) -> list[Item | Main]:
    """The items without the blank lines that the layout writes anyway."""
    result: list[Item | Main] = []
    for item, apart, blank, _ in placed(list(items)):
        if blank and not apart:
            result.append(Blank())
        result.append(item)
    return result


def is_set_apart(item: Item | Main) -> bool:
    """Whether blank lines are above and below an item."""
    return isinstance(item, SET_APART) or is_definition(item)


def is_lead(item: Item | Main) -> bool:
    """Whether an item belongs to the one below it: a comment or a decorator."""
    return isinstance(item, Comment) or (isinstance(item, PythonLine) and item.text[:1] == "@")


def prologue_length(items: Sequence[Item]) -> int:
    """The number of items above the robot's import in Python.

    These are the items up to the last ``import`` in the first lines, or else the comment at the
    beginning of the file, if a blank line follows it.
    """
    imports = 0
    for index, item in enumerate(items):
        if isinstance(item, Import):
            imports = index + 1
        elif not isinstance(item, Comment | Blank):
            break
    return imports or _heading_length(items)


def _heading_length(items: Sequence[Item]) -> int:
    for index, item in enumerate(items):
        if not isinstance(item, Comment):
            return index if isinstance(item, Blank) else 0
    return 0


def _leads(items: Sequence[Item | Main]) -> list[Item | Main | None]:
    leads: list[Item | Main | None] = []
    below: Item | Main | None = None
    for item in reversed(items):
        if is_set_apart(item):
            below = item
        elif not is_lead(item):
            below = None
        leads.append(below)
    return leads[::-1]


def _apart(previous: Item | Main, item: Item | Main, leads: Item | Main | None) -> bool:
    if is_set_apart(previous) or isinstance(previous, WithoutRobot):
        return True
    if isinstance(previous, Import):
        return not isinstance(item, Import)
    return leads is not None and not is_lead(previous)
