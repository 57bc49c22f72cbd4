"""The last states of a program, on which pages may still base their edits."""

from collections import deque
from dataclasses import dataclass

from learnblock.server.messages import View
from learnblock.server.program.document import Document

#: The limits of the kept revisions, of which the last one always stays.
MOST_REVISIONS = 256
MOST_CHARACTERS = 16 * 1024 * 1024


@dataclass(frozen=True)
class Revision:
    """The texts of a program at one time; see `Document.text_of`.

    Args:
        number: counts the changes of the program.
        blocktext: the text in Block-Text, which may have errors.
        python: the text in Python, which may have errors.
        blocks: the program of the blocks, as Block-Text.
    """

    number: int
    blocktext: str
    python: str
    blocks: str

    def text(self, view: View) -> str:
        """The program as that view showed it."""
        return {"blocktext": self.blocktext, "python": self.python, "blocks": self.blocks}[view]


class Revisions:
    """The last revisions of a program.

    Args:
        document: the first one.
    """

    def __init__(self, document: Document) -> None:
        self._kept: deque[Revision] = deque(maxlen=MOST_REVISIONS)
        self.add(document)

    @property
    def last(self) -> Revision:
        """The current revision."""
        return self._kept[-1]

    def add(self, document: Document) -> None:
        """Record a change of the program."""
        number = self._kept[-1].number + 1 if self._kept else 1
        texts = (document.text_of(view) for view in ("blocktext", "python", "blocks"))
        self._kept.append(Revision(number, *texts))
        while len(self._kept) > 1 and sum(map(_size, self._kept)) > MOST_CHARACTERS:
            self._kept.popleft()

    def find(self, number: int) -> Revision | None:
        """The revision with a number; None once it is forgotten."""
        index = number - self._kept[0].number
        return self._kept[index] if 0 <= index < len(self._kept) else None


def _size(revision: Revision) -> int:
    return len(revision.blocktext) + len(revision.python) + len(revision.blocks)
