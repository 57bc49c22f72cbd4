"""The program as shown by a page, so that the page receives only changes."""

from typing import TypeVar

from learnblock.server import messages
from learnblock.server.messages import View
from learnblock.server.program.edits import Edits

Content = TypeVar("Content")


class Shown:
    """The program as shown by a page: what it has sent and received.

    `edit` is the number of its last edit.
    """

    def __init__(self) -> None:
        self.edit = 0
        self._views: dict[View, object] = {}

    def edited(self, edit: int, view: View, content: object) -> None:
        """Record that the page has edited a view."""
        self.edit = edit
        self._views[view] = content

    def update(self, edits: Edits) -> messages.Document:
        """Return the message that brings the page up to date."""
        document = edits.document
        return messages.Document(
            edit=self.edit,
            origin=document.origin,
            blocktext=self._new("blocktext", document.blocktext),
            python=self._new("python", document.python),
            workspace=self._new("blocks", document.workspace),
            places=document.places,
            problems=document.problems,
            stale=document.stale,
            can_undo=edits.can_undo,
            can_redo=edits.can_redo,
        )

    def _new(self, view: View, content: Content) -> Content | None:
        if self._views.get(view) == content:
            return None
        self._views[view] = content
        return content
