"""The lines in which each statement of a program stands."""

from collections.abc import Mapping

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
        return tuple((node.span.line, node.span.end_line) for node in every(program))
    return tuple(written.get(id(node), NOWHERE) for node in every(program))
