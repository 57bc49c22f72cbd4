"""Which edits are one step of undo: the letters of a word, and a number in a block."""

import re
from collections.abc import Iterator
from dataclasses import dataclass

from learnblock.language.workspace.blocks import Block, Workspace
from learnblock.project.document.document import Document

#: Seconds between two letters of a word that are undone together.
QUICK = 1.0

_WORD_BEGINS = re.compile(r"\s\S|\n")


@dataclass(frozen=True, slots=True)
class Typing:
    """An edit by typing.

    Args:
        view: the edited view.
        moment: the time of the edit.
        start: the first changed character; 0 in blocks.
        removed: the removed characters.
        inserted: the inserted characters.
    """

    view: str
    moment: float
    start: int = 0
    removed: str = ""
    inserted: str = ""

    def goes_on(self, before: "Typing") -> bool:
        """Whether it continues the word that `before` ended in."""
        if self.view != before.view or self.moment - before.moment > QUICK:
            return False
        if self.view == "blocks":
            return True
        if bool(self.removed) != bool(before.removed):
            return False
        if self.removed:
            return self.start in (before.start, before.start - len(self.removed))
        adjoins = self.start == before.start + len(before.inserted)
        return adjoins and not _WORD_BEGINS.search(before.inserted[-1:] + self.inserted)


def looks_alike(first: Document, second: Document) -> bool:
    """Whether two programs look the same in every view."""
    return (
        first.blocktext == second.blocktext
        and first.python == second.python
        and first.workspace == second.workspace
    )


def typed(before: Document, after: Document, now: float) -> Typing | None:
    """Compare two documents; return the typing if that is the only change."""
    view = after.origin
    if view == "blocks":
        same = [*_blocks(before.workspace)] == [*_blocks(after.workspace)]
        return Typing(view, now) if same else None
    old, new = before.text_of(view), after.text_of(view)
    start, removed, inserted = _difference(old, new)
    if removed and inserted:
        return None
    return Typing(view, now, start, removed, inserted)


def _difference(old: str, new: str) -> tuple[int, str, str]:
    """Compare two texts: the first difference, and the removed and inserted characters."""
    shorter = min(len(old), len(new))
    start = _common(old, new, shorter)
    end = _common(old[::-1], new[::-1], shorter - start)
    return start, old[start : len(old) - end], new[start : len(new) - end]


def _common(first: str, second: str, most: int) -> int:
    """Count the equal characters at the start of two texts, at most `most`; by bisection."""
    low, high = 0, most
    while low < high:
        middle = (low + high + 1) // 2
        if first.startswith(second[low:middle], low):
            low = middle
        else:
            high = middle - 1
    return low


def _blocks(workspace: Workspace) -> Iterator[tuple[str, str]]:
    """List every block and its type in order, which fields and places don't change."""
    ahead: list[Block] = [block for stack in workspace.stacks for block in stack]
    while ahead:
        block = ahead.pop()
        yield block.id, block.type
        for slot in block.inputs.values():
            ahead.extend(inner for inner in (slot.block, slot.shadow) if inner is not None)
            ahead.extend(slot.stack)
