"""Find the lines of each statement of a program."""

from collections.abc import Iterable, Mapping
from itertools import takewhile

from learnblock.language.tree.nodes import Item, Main, Program
from learnblock.language.tree.traversal import statements

#: First and last line, from 1; (0, 0) means nowhere.
Extent = tuple[int, int]
NOWHERE: Extent = (0, 0)


def every(program: Program) -> list[Item | Main]:
    """Every item and statement of a program, including `main`, in source order."""
    main = () if program.main is None else (program.main,)
    # `statements` also enters the bodies of items.
    return list(statements((*program.items, *main)))


def extents(program: Program, written: Mapping[int, Extent] | None = None) -> tuple[Extent, ...]:
    """The lines of `every` statement of a program.

    Args:
        program: the tree.
        written: the lines from the writer of the text, by the `id()` of the node; None for a tree
            with the spans of its own text.
    """
    if written is None:
        return tuple(map(_of_span, every(program)))
    return tuple(written.get(id(node), NOWHERE) for node in every(program))


def _of_span(node: Item | Main) -> Extent:
    # Some comments have only a start.
    return node.span.line, max(node.span.line, node.span.end_line)


def moved(lines: Iterable[Extent], before: str, after: str) -> tuple[Extent, ...]:
    """Move lines of the text `before` to `after`, which was edited in one place."""
    old, new = before.split("\n"), after.split("\n")
    above = _common(old, new)
    below = min(_common(old[::-1], new[::-1]), min(len(old), len(new)) - above)

    def place(line: int) -> int:
        if line <= above:
            return line
        if line > len(old) - below:
            return line + len(new) - len(old)
        # Within the edit, a removed line moves to the next one.
        return min(line, max(len(new) - below, above + 1))

    return tuple((place(first), place(last)) for first, last in lines)


def _common(first: list[str], other: list[str]) -> int:
    """The number of equal lines at the beginning of two texts."""
    return sum(
        1 for _ in takewhile(lambda pair: pair[0] == pair[1], zip(first, other, strict=False))
    )
