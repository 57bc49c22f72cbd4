"""Programs as drawings of blocks."""

from collections.abc import Mapping
from dataclasses import dataclass

from learnblock.blocks.known import all_configurations
from learnblock.errors import LearnBlockError
from learnblock.language import Workspace, parse, to_workspace
from learnblock.language.tree.extents import every

#: The longest program that is drawn.
LONGEST_DRAWING = 4000


@dataclass(frozen=True, slots=True)
class ProgramDrawing:
    """A program as blocks.

    Args:
        workspace: the blocks.
        lines: the first line of each statement in the text, from 1, by the id of its block.
    """

    workspace: Workspace
    lines: Mapping[str, int]


def drawing_of(text: str) -> ProgramDrawing | None:
    """The blocks of a program in Block-Text, and their lines; None if it has mistakes."""
    try:
        program = parse(text, "lesson.bt")
        drawn = to_workspace(program, all_configurations())
    except (LearnBlockError, RecursionError):
        return None
    blocks = ((drawn.block_ids.get(id(node)), node.span.line) for node in every(program))
    return ProgramDrawing(
        drawn.workspace, {block: line for block, line in blocks if block and line}
    )


def drawn_program(text: str) -> Workspace | None:
    """The blocks of a program in Block-Text; None if it has mistakes."""
    drawing = drawing_of(text)
    return drawing.workspace if drawing else None
