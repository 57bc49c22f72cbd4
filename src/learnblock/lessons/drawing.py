"""Programs as drawings of blocks."""

from learnblock.blocks.known import all_configurations
from learnblock.errors import LearnBlockError
from learnblock.language import Workspace, parse, to_workspace

#: The longest program that is drawn.
LONGEST_DRAWING = 4000


def drawn_program(text: str) -> Workspace | None:
    """The blocks of a program in Block-Text; None if it has mistakes."""
    try:
        return to_workspace(parse(text, "lesson.bt"), all_configurations()).workspace
    except (LearnBlockError, RecursionError):
        return None
