"""Workspaces written as Block-Text, with what only blocks have: holes, and loose stacks.

    main:
        repeat ___:
            function.turn(90)
        end
    end
    --- loose
    function.stop_bot()

`___` is an empty input. Below ``--- loose`` are statements without a hat, below ``--- value`` a
value that is plugged in nowhere, and below ``--- also`` another part of the workspace, such as a
second main block.
"""

import re

from learnblock.blocks import builtin
from learnblock.language import Workspace, parse, to_workspace
from learnblock.language.workspace.blocks import Block, Input
from workspaces import blocks

HOLE = "___"
_SECTION = re.compile(r"^--- (loose|value|also)$\n?", re.MULTILINE)


def drawn(text: str) -> Workspace:
    """Return the workspace that is written as a text."""
    result = Workspace()
    first, *rest = _SECTION.split(text)
    sections = [("also", first), *zip(rest[::2], rest[1::2], strict=True)]
    for part, (kind, section) in enumerate(sections):
        before = Workspace(variables=result.variables)
        program = parse(f"{HOLE} = {section}" if kind == "value" else section)
        workspace = to_workspace(program, builtin(), before).workspace
        result.variables = list(dict.fromkeys([*result.variables, *workspace.variables]))
        holes = {variable.id for variable in result.variables if variable.name == HOLE}
        for block in blocks(workspace):
            _empty(block, holes)
            block.id = f"{part}{block.id}"
        result.stacks += [_taken(stack, kind) for stack in workspace.stacks]
    return result


def label(block: Block, workspace: Workspace) -> str:
    """Return the type of a block and what its fields show, to name it in a test."""
    names = {variable.id: variable.name for variable in workspace.variables}
    values = [
        names[value["id"]] if isinstance(value, dict) else value for value in block.fields.values()
    ]
    return " ".join([block.type, *(str(value).removesuffix(".0") for value in values)])


def _taken(stack: list[Block], kind: str) -> list[Block]:
    """The blocks of a section, without the start block that `to_workspace` puts above them."""
    if kind == "also":
        return stack
    inner = stack[0].inputs["DO"].stack
    return inner if kind == "loose" else [inner[0].inputs["VALUE"].block]


def _empty(block: Block, holes: set[str]) -> None:
    """Take the holes out of the inputs of a block."""
    for name, plug in block.inputs.items():
        variable = plug.block and plug.block.fields.get("VAR")
        if isinstance(variable, dict) and variable["id"] in holes:
            block.inputs[name] = Input(shadow=plug.shadow)
