"""The one history of a program: a log of its revisions, by number.

Every change adds a revision, and everything that looks back says just a number of it: a page what
its edit was made on, undo and redo where they lead, and the file what was saved in it. The current
revision is a `Document`, and so are the last steps of undo, so that undo parses and checks nothing
again. All others are packed, texts and blocks, because 500 documents with 1,000 blocks each would
need more than a gigabyte. A revision that no number leads to any more is forgotten. What must
outlive the server is in files: the project, and the versions that `History` keeps of it.
"""

import time
import zlib
from collections import Counter, deque
from collections.abc import Callable
from dataclasses import dataclass

import msgspec

from learnblock.language.workspace.blocks import Workspace
from learnblock.project.document.document import VIEWS, Document
from learnblock.project.document.keystrokes import Typing, looks_alike, typed
from learnblock.project.document.notations import Target
from learnblock.project.document.views import View

#: The last revisions, on which pages may still base their edits.
MOST_REVISIONS = 256
MOST_STEPS = 500
#: An editor in which a file was opened more saves ago overwrites what was written since.
MOST_SAVES = 50
#: The limit of the steps of undo that are documents, in characters; each takes about 80 bytes.
MOST_CHARACTERS = 500_000
#: The limit of all packed revisions together, in bytes.
MOST_BYTES = 32 * 1024 * 1024

_read_workspace = msgspec.json.Decoder(Workspace).decode


# Why: docs/decisions.md, "Undo is the server's"
class Revisions:
    """The current program, and those before and after it.

    Args:
        document: the first one, which is also what is in the file.
        now: returns the time of a monotonic clock in seconds.

    Attributes:
        number: counts the changes of the program.
    """

    def __init__(self, document: Document, now: Callable[[], float] = time.monotonic) -> None:
        self.number = 1
        self._log: dict[int, Document | _Packed] = {1: document}
        self._past: deque[int] = deque(maxlen=MOST_STEPS)
        self._future: list[int] = []
        self._saves: tuple[int, ...] = (1,)
        self._typing: Typing | None = None
        self._now = now

    @property
    def document(self) -> Document:
        """The current program."""
        document = self._log[self.number]
        assert isinstance(document, Document)  # noqa: S101 - only others are packed
        return document

    def text(self, number: int, view: View) -> str | None:
        """The program as a view showed it, see `Document.text_of`; None once it is forgotten."""
        document = self._log.get(number)
        return document.text_of(view) if document else None

    # Changes.

    def push(self, document: Document) -> None:
        """Add an edit; letters of one word typed in quick succession are one step of undo."""
        before = self.document
        if looks_alike(document, before):
            self._add(document)
            return
        typing = typed(before, document, self._now())
        if not (typing and self._typing and self._past and typing.goes_on(self._typing)):
            self._past.append(self.number)
        self._future.clear()
        self._typing = typing
        self._add(document)

    def replace(self, document: Document) -> None:
        """Add a change that is no step of undo, for example when the robot changes."""
        self._add(document)

    # Undo.

    @property
    def can_undo(self) -> bool:
        return bool(self._past)

    @property
    def can_redo(self) -> bool:
        return bool(self._future)

    def undo(self) -> None:
        """Undo the last edit, if there is one."""
        if self._past:
            self._future.append(self.number)
            self._go_to(self._past.pop())

    def redo(self) -> None:
        """Redo the last undone edit, if there is one."""
        if self._future:
            self._past.append(self.number)
            self._go_to(self._future.pop())

    def _go_to(self, number: int) -> None:
        self._typing = None
        self._add(_restored(self._log[number], self.document.target))

    # The file.

    def saved(self, number: int) -> None:
        """Record that a revision is what the file has now."""
        if number in self._log:
            # A new tuple, because another thread may be reading the old one.
            self._saves = (*self._saves, number)[-MOST_SAVES:]

    def edited(self, view: View, text: str) -> int:
        """The save that another program has most likely edited: the one that differs least.

        An editor may have read the file some saves ago; its author has not changed what was saved
        since. A text that equals an earlier save is an edit of the last save: its author has
        undone what came after.

        Args:
            view: the view in which it was edited.
            text: the text that the other program has written.
        """
        numbers = (number for number in self._saves if number in self._log)
        saves = {number: self._log[number].text_of(view) for number in numbers}
        if text in saves.values():
            return max(saves)
        lines = Counter(text.split("\n"))
        return min(reversed(saves), key=lambda number: _distance(saves[number], lines))

    # The log.

    def _add(self, document: Document) -> None:
        self.number += 1
        self._log[self.number] = document
        self._forget()
        self._pack()

    def _forget(self) -> None:
        steps = {*self._past, *self._future, *self._saves}
        oldest = self.number - MOST_REVISIONS
        self._log = {
            number: revision
            for number, revision in self._log.items()
            if number > oldest or number in steps
        }

    def _pack(self) -> None:
        """Pack all revisions but the current one and the last steps of undo, within the limits."""
        steps, characters, size = {*self._past, *self._future}, 0, 0
        for number in sorted(self._log, reverse=True)[1:]:
            revision = self._log[number]
            if isinstance(revision, Document):
                characters += (number in steps) * _characters(revision)
                if number in steps and characters <= MOST_CHARACTERS:
                    continue
                revision = self._log[number] = _Packed.of(revision)
            size += revision.size
            if size > MOST_BYTES and number != self._saves[-1]:
                self._drop(number)

    def _drop(self, number: int) -> None:
        del self._log[number]
        for steps in (self._past, self._future):
            if number in steps:
                steps.remove(number)


@dataclass(frozen=True, slots=True)
class _Packed:
    """A compressed document."""

    texts: dict[View, bytes]
    by_hand: bool
    workspace: bytes

    @classmethod
    def of(cls, document: Document) -> "_Packed":
        return cls(
            {view: _compressed(document.text_of(view)) for view in VIEWS},
            document.python_by_hand is not None,
            zlib.compress(msgspec.json.encode(document.workspace), level=1),
        )

    def text_of(self, view: View) -> str:
        return zlib.decompress(self.texts[view]).decode("utf-8", "surrogatepass")

    def document(self, target: Target) -> Document:
        return Document.from_text(
            self.text_of("blocktext"),
            target.robot_module,
            target.configurations,
            _read_workspace(zlib.decompress(self.workspace)),
            self.text_of("python") if self.by_hand else None,
            equipment=target.equipment,
            drivetrain=target.drivetrain,
        )

    @property
    def size(self) -> int:
        return sum(map(len, self.texts.values())) + len(self.workspace)


def _compressed(text: str) -> bytes:
    return zlib.compress(text.encode("utf-8", "surrogatepass"), level=1)


def _characters(document: Document) -> int:
    return len(document.blocktext) + len(document.python)


def _restored(revision: Document | _Packed, target: Target) -> Document:
    """An earlier program for the robot and the skills of today."""
    if isinstance(revision, _Packed):
        return revision.document(target)
    if revision.target == target:
        return revision
    if revision.target.configurations == target.configurations:
        return revision.with_robot(target.robot_module, target.equipment, target.drivetrain)
    return _Packed.of(revision).document(target)


def _distance(before: str, lines: Counter[str]) -> int:
    """How many lines differ, wherever they are."""
    old = Counter(before.split("\n"))
    return (old - lines).total() + (lines - old).total()
