"""Undo and redo, whichever view an edit was made in."""

import re
import time
import zlib
from collections import deque
from collections.abc import Callable, Iterator
from dataclasses import dataclass

import msgspec

from learnblock.language.workspace.blocks import Block, Workspace
from learnblock.server.program.document import Document
from learnblock.server.program.notations import Target

MOST_STEPS = 500
#: The limit of all compressed steps together, in bytes.
MOST_BYTES = 32 * 1024 * 1024
#: Seconds between two letters of a word that are undone together.
QUICK = 1.0

_WORD_BEGINS = re.compile(r"\s\S|\n")
_read_workspace = msgspec.json.Decoder(Workspace).decode


class Edits:
    """The current document, and those before and after it.

    Args:
        document: the first document.
        now: returns the time of a monotonic clock in seconds.
    """

    def __init__(self, document: Document, now: Callable[[], float] = time.monotonic) -> None:
        self._document = document
        self._now = now
        self._past: deque[_Moment] = deque(maxlen=MOST_STEPS)
        self._future: list[_Moment] = []
        self._typing: _Typing | None = None

    @property
    def document(self) -> Document:
        """The current document."""
        return self._document

    @property
    def can_undo(self) -> bool:
        return bool(self._past)

    @property
    def can_redo(self) -> bool:
        return bool(self._future)

    def push(self, document: Document) -> None:
        """Add an edit; letters of one word typed in quick succession are one step."""
        if _looks_alike(document, self._document):
            self._document = document
            return
        typing = _typed(self._document, document, self._now())
        if not (typing and self._typing and self._past and typing.goes_on(self._typing)):
            self._past.append(_Moment.of(self._document))
            self._forget()
        self._typing, self._document = typing, document
        self._future.clear()

    def replace(self, document: Document) -> None:
        """Replace the document without recording an edit, for example when the robot changes."""
        self._document = document

    def undo(self) -> None:
        """Undo the last edit, if there is one."""
        if self._past:
            self._future.append(_Moment.of(self._document))
            self._go_to(self._past.pop())

    def redo(self) -> None:
        """Redo the last undone edit, if there is one."""
        if self._future:
            self._past.append(_Moment.of(self._document))
            self._go_to(self._future.pop())

    def _go_to(self, moment: "_Moment") -> None:
        self._document = moment.document(self._document.target)
        self._typing = None

    def _forget(self) -> None:
        size = sum(moment.size for moment in self._past)
        while size > MOST_BYTES:
            size -= self._past.popleft().size


@dataclass(frozen=True, slots=True)
class _Moment:
    """A compressed document, because 500 documents with 1000 blocks each would need much memory."""

    blocktext: bytes
    python: bytes | None
    workspace: bytes

    @classmethod
    def of(cls, document: Document) -> "_Moment":
        python = document.python_by_hand
        return cls(
            _packed(document.blocktext.encode("utf-8", "surrogatepass")),
            None if python is None else _packed(python.encode("utf-8", "surrogatepass")),
            _packed(msgspec.json.encode(document.workspace)),
        )

    def document(self, target: Target) -> Document:
        return Document.from_text(
            _unpacked(self.blocktext),
            target.robot_module,
            target.configurations,
            _read_workspace(zlib.decompress(self.workspace)),
            None if self.python is None else _unpacked(self.python),
            equipment=target.equipment,
        )

    @property
    def size(self) -> int:
        return len(self.blocktext) + len(self.python or b"") + len(self.workspace)


def _packed(data: bytes) -> bytes:
    return zlib.compress(data, level=1)


def _unpacked(data: bytes) -> str:
    return zlib.decompress(data).decode("utf-8", "surrogatepass")


def _looks_alike(one: Document, other: Document) -> bool:
    return (
        one.blocktext == other.blocktext
        and one.python == other.python
        and one.workspace == other.workspace
    )


@dataclass(frozen=True, slots=True)
class _Typing:
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

    def goes_on(self, before: "_Typing") -> bool:
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


def _typed(before: Document, after: Document, now: float) -> _Typing | None:
    """Compare two documents; return the typing if that is the only change."""
    view = after.origin
    if view == "blocks":
        same = [*_blocks(before.workspace)] == [*_blocks(after.workspace)]
        return _Typing(view, now) if same else None
    old, new = before.text_of(view), after.text_of(view)
    start, removed, inserted = _difference(old, new)
    if removed and inserted:
        return None
    return _Typing(view, now, start, removed, inserted)


def _difference(old: str, new: str) -> tuple[int, str, str]:
    """Compare two texts: the first difference, and the removed and inserted characters."""
    shorter = min(len(old), len(new))
    start = _common(old, new, shorter)
    end = _common(old[::-1], new[::-1], shorter - start)
    return start, old[start : len(old) - end], new[start : len(new) - end]


def _common(one: str, other: str, most: int) -> int:
    """Count the equal characters at the start of two texts, at most `most`; by bisection."""
    low, high = 0, most
    while low < high:
        middle = (low + high + 1) // 2
        if one.startswith(other[low:middle], low):
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
        for given in block.inputs.values():
            ahead.extend(one for one in (given.block, given.shadow) if one is not None)
            ahead.extend(given.stack)
