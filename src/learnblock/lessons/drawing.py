"""Programs as drawings of blocks."""

from collections.abc import Mapping
from dataclasses import dataclass

from learnblock.blocks.known import all_configurations
from learnblock.errors import LearnBlockError
from learnblock.language import Workspace, parse, to_workspace
from learnblock.language.tree.extents import every, extents

#: The longest program that is drawn.
LONGEST_DRAWING = 4000


@dataclass(frozen=True, slots=True)
class ProgramDrawing:
    """A program as blocks.

    Args:
        workspace: the blocks.
        lines: the first line of each statement in the text, from 1, by the id of its block.
        ends: the last lines, by the same.
    """

    workspace: Workspace
    lines: Mapping[str, int]
    ends: Mapping[str, int]


def drawing_of(text: str) -> ProgramDrawing | None:
    """The blocks of a program in Block-Text, and their lines; None if it has mistakes."""
    try:
        program = parse(text, "lesson.bt")
        drawn = to_workspace(program, all_configurations())
    except (LearnBlockError, RecursionError):
        return None
    blocks = [drawn.block_ids.get(id(node)) for node in every(program)]
    places = [
        (block, line, end)
        for block, (line, end) in zip(blocks, extents(program), strict=True)
        if block and line
    ]
    return ProgramDrawing(
        drawn.workspace,
        {block: line for block, line, _ in places},
        {block: end for block, _, end in places},
    )


def drawn_program(text: str) -> Workspace | None:
    """The blocks of a program in Block-Text; None if it has mistakes."""
    drawing = drawing_of(text)
    return drawing.workspace if drawing else None


def drawn_part(source: str) -> Workspace | None:
    """The blocks of a program, or of some of its statements; None if they can't be drawn."""
    if len(source) > LONGEST_DRAWING:
        return None
    body = source.strip("\n")
    if body.startswith("elif "):
        # The page writes "else" before the drawing of the "if".
        body = body.removeprefix("el")
    inner = "\n".join(f"    {line}" for line in body.split("\n"))
    is_head = body.endswith(":") and "\n" not in body
    parts = [f"main:\n{inner}\nend\n"]
    if is_head:
        # A line such as "repeat 4:" begins a statement.
        parts.append(f"main:\n{inner}\n        pass\n    end\nend\n")
    workspace = next(filter(None, map(drawn_program, parts)), None)
    if workspace:
        return _without_head(workspace)
    # "main:" or "def go():" begins a part of the program.
    return drawn_program(f"{body}\n    pass\nend\n" if is_head else source)


def _without_head(workspace: Workspace) -> Workspace | None:
    """The statements inside of ``main``, as a stack of their own."""
    for first, *_ in workspace.stacks:
        for slot in first.inputs.values():
            if slot.stack:
                return Workspace([slot.stack], workspace.variables)
    return None
