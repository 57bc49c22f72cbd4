"""Renames in the blocks: Blockly renames in its blocks, but not in the raw Python within them."""

import re
from dataclasses import dataclass

from learnblock.language.edit.rename import Sort
from learnblock.language.workspace.blocks import Block, Workspace
from learnblock.language.workspace.types import WHENS

_SORTS: dict[str, Sort] = {
    "procedures_defnoreturn": "function",
    "procedures_defreturn": "function",
    **dict.fromkeys(WHENS, "when"),
}


@dataclass(frozen=True)
class Rename:
    """A change of a name.

    Args:
        sort: variable, function or when.
        name: the old name.
        new: the new name.
    """

    sort: Sort
    name: str
    new: str

    def is_left_in(self, text: str) -> bool:
        """Whether the old name still occurs in a text, even in a comment."""
        return bool(re.search(rf"\b(?:state_|time_)?{re.escape(self.name)}\b", text))


def rename_between(before: Workspace, after: Workspace) -> Rename | None:
    """Find the single changed name; None if there is none or more than one."""
    old, new = _names(before), _names(after)
    keys = [key for key, name in new.items() if old.get(key, name) != name]
    if len(keys) != 1:
        return None
    sort, _ = key = keys[0]
    return Rename(sort, old[key], new[key])


def _names(workspace: Workspace) -> dict[tuple[Sort, str], str]:
    """List all names by sort and id."""
    names: dict[tuple[Sort, str], str] = {
        ("variable", variable.id): variable.name for variable in workspace.variables
    }
    for first, *_ in workspace.stacks:
        sort, name = _SORTS.get(first.type), _name(first)
        if sort and name:
            names[sort, first.id] = name
    return names


def _name(block: Block) -> str:
    name = block.fields.get("NAME")
    return name if isinstance(name, str) else ""
