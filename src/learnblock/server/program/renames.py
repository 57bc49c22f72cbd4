"""A rename in the blocks: Blockly makes it in its own blocks, and not in the Python within them."""

import re
from dataclasses import dataclass

from learnblock.language.rename import Sort
from learnblock.language.workspace import Block, Workspace

_SORTS: dict[str, Sort] = {
    "procedures_defnoreturn": "function",
    "procedures_defreturn": "function",
    "lb_when": "when",
}


@dataclass(frozen=True)
class Rename:
    """Something has another name.

    Args:
        sort: what.
        name: as it was called.
        new: as it is called now.
    """

    sort: Sort
    name: str
    new: str

    def is_left_in(self, text: str) -> bool:
        """Whether the old name still stands somewhere, be it in a comment."""
        return bool(re.search(rf"\b(?:state_|time_)?{re.escape(self.name)}\b", text))


def rename_between(before: Workspace, after: Workspace) -> Rename | None:
    """The one thing that has another name than before, if it is one."""
    old, new = _names(before), _names(after)
    changed = [key for key, name in new.items() if old.get(key, name) != name]
    if len(changed) != 1:
        return None
    sort, _ = key = changed[0]
    return Rename(sort, old[key], new[key])


def _names(workspace: Workspace) -> dict[tuple[Sort, str], str]:
    """What has a name, by its sort and its id."""
    found: dict[tuple[Sort, str], str] = {
        ("variable", variable.id): variable.name for variable in workspace.variables
    }
    for first, *_ in workspace.stacks:
        sort, name = _SORTS.get(first.type), _name(first)
        if sort and name:
            found[sort, first.id] = name
    return found


def _name(block: Block) -> str:
    name = block.fields.get("NAME")
    return name if isinstance(name, str) else ""
