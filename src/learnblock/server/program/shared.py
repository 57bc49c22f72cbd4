"""A program that several pages edit at the same time."""

from collections.abc import Callable

from learnblock.server import messages
from learnblock.server.program.document import Document
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
        #: Who wrote the text that can't be parsed, if there is one.
        self._unread_by: Shown | None = None

    @property
    def document(self) -> Document:
        """The current program."""
        return self.revisions.document

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
        if by and found.left is not None:
            # An edit of blocks that can't be parsed has no text; the next one has the same base.
            by.left(edit.view, found.left)
        return found

    def change(self, edit: Callable[[Document], Document]) -> None:
        """Change the program.

        Raises:
            LearnBlockError: the edit is impossible; nothing has changed.
        """
        self.revisions.push(edit(self.document).settled())

    def replace(self, edit: Callable[[Document], Document]) -> None:
        """Change the program without a step of undo, for example when the robot changes."""
        self.revisions.replace(edit(self.document).settled())

    def undo(self) -> None:
        """Undo the last edit, if there is one."""
        self.revisions.undo()
        self.document.settled()

    def redo(self) -> None:
        """Redo the last undone edit, if there is one."""
        self.revisions.redo()
        self.document.settled()

    def update(self, page: Shown) -> messages.Document:
        """Return the message that brings a page up to date."""
        now = self.revisions
        return page.update(now.document, now.number, can_undo=now.can_undo, can_redo=now.can_redo)
