"""A program that several pages edit at the same time."""

from collections.abc import Callable

from learnblock.server import messages
from learnblock.server.program.document import Document
from learnblock.server.program.edits import Edits
from learnblock.server.program.merging import Edit, Merged, merged
from learnblock.server.program.revisions import Revisions
from learnblock.server.program.shown import Shown


class SharedProgram:
    """The current program, with undo and redo, and the revisions that edits are based on.

    Its methods can be slow for long programs.

    Args:
        document: the program.
    """

    def __init__(self, document: Document) -> None:
        self.revisions = Revisions(document)
        self._edits = Edits(document)
        #: Who wrote the text that can't be parsed, if there is one.
        self._unread_by: Shown | None = None

    @property
    def document(self) -> Document:
        """The current program."""
        return self._edits.document

    def merge(self, edit: Edit, by: Shown | None = None) -> Merged:
        """Merge an edit.

        Args:
            edit: the edit.
            by: the program as shown by the page that made the edit; None for another program.
        """
        keeps_unread = by is None or self._unread_by is not by
        found = merged(self.document, edit, keeps_unread=keeps_unread)
        self.change(lambda _: found.document)
        unread = found.document.unread
        if unread is None or unread.view == edit.view:
            self._unread_by = by
        if by and not (edit.view == "blocks" and found.alone.unread):
            # An edit of blocks that can't be parsed has no text; the next one has the same base.
            by.left(edit.view, found.alone.text_of(edit.view))
        return found

    def change(self, edit: Callable[[Document], Document]) -> None:
        """Change the program.

        Raises:
            LearnBlockError: the edit is impossible; nothing has changed.
        """
        self._edits.push(edit(self.document).settled())
        self.revisions.add(self.document)

    def replace(self, edit: Callable[[Document], Document]) -> None:
        """Change the program without a step of undo, for example when the robot changes."""
        self._edits.replace(edit(self.document).settled())
        self.revisions.add(self.document)

    def undo(self) -> None:
        """Undo the last edit, if there is one."""
        self._edits.undo()
        self.revisions.add(self.document.settled())

    def redo(self) -> None:
        """Redo the last undone edit, if there is one."""
        self._edits.redo()
        self.revisions.add(self.document.settled())

    def update(self, page: Shown) -> messages.Document:
        """Return the message that brings a page up to date."""
        number = self.revisions.last.number
        return page.update(
            self.document, number, can_undo=self._edits.can_undo, can_redo=self._edits.can_redo
        )
