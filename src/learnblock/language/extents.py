"""The lines in which each statement of a program stands."""

from collections.abc import Iterable, Mapping
from itertools import takewhile

from learnblock.language.nodes import Item, Main, Program, statements

#: First and last line, from 1; (0, 0) is nowhere.
Extent = tuple[int, int]
NOWHERE: Extent = (0, 0)


def every(program: Program) -> list[Item | Main]:
    """Every item and statement of a program, `main` among them, in order of the text."""
    main = () if program.main is None else (program.main,)
    # `statements` goes into whatever has a body.
    return list(statements((*program.items, *main)))


def extents(program: Program, written: Mapping[int, Extent] | None = None) -> tuple[Extent, ...]:
    """The lines of `every` statement of a program.

    Args:
        program: the tree.
        written: what the writer of the text says, by identity of the node; None for a tree whose
            spans tell where its author wrote it.
    """
    if written is None:
        return tuple(map(_of_span, every(program)))
    return tuple(written.get(id(node), NOWHERE) for node in every(program))


def _of_span(node: Item | Main) -> Extent:
    # Of some comments it is known only where they begin.
    return node.span.line, max(node.span.line, node.span.end_line)


def moved(lines: Iterable[Extent], before: str, after: str) -> tuple[Extent, ...]:
    """Where the lines of the text `before` stand in `after`, which was edited in one place."""
    old, new = before.split("\n"), after.split("\n")
    above = _common(old, new)
    below = min(_common(old[::-1], new[::-1]), min(len(old), len(new)) - above)

    def place(line: int) -> int:
        if line <= above:
            return line
        if line > len(old) - below:
            return line + len(new) - len(old)
        # Within the edit; what was taken out stood where now the next line stands.
        return min(line, max(len(new) - below, above + 1))

    return tuple((place(first), place(last)) for first, last in lines)


def _common(one: list[str], other: list[str]) -> int:
    """How many lines two texts begin with alike."""
    return sum(1 for _ in takewhile(lambda pair: pair[0] == pair[1], zip(one, other, strict=False)))
