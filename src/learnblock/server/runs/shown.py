"""The program as shown by a page, so that the page receives only changes."""

from collections import Counter
from typing import TypeVar

from learnblock.i18n import Phrase
from learnblock.project.document.revisions import Revisions
from learnblock.project.document.shared import SharedProgram
from learnblock.project.document.views import Problem, View
from learnblock.server import messages

Content = TypeVar("Content")

#: A page lists at most this many problems of a view: thousands would slow down page and server.
MOST_PROBLEMS = 200


class ShownProgram:
    """The program as shown by a page: what it has sent and received.

    Args:
        number: how many programs of this project the page has shown before.

    Attributes:
        number: the same; an edit with another number is for an earlier program.
        edit: the number of its last edit.
    """

    def __init__(self, number: int = 0) -> None:
        self.number = number
        self.edit = 0
        self._views: dict[View, object] = {}
        #: The revision that its last edit was made on, and its edits of each view since.
        self._revision = 0
        self._own: dict[View, str] = {}

    def edited(self, edit: int, view: View, content: object, left: str | None) -> None:
        """Record that the page has edited a view.

        Args:
            edit: the number of the edit.
            view: the view.
            content: the view after the edit.
            left: the text that the edit has left in it, see `Document.text_of`; None for blocks
                that can't be parsed: the next edit has the same base.
        """
        self.edit = edit
        self._views[view] = content
        self._keep(view, left)

    def repeated(self, edit: int, view: View, left: str | None) -> None:
        """Record that the page has repeated an edit, which it may no longer show.

        See `edited`.
        """
        self.edit = edit
        self._views.pop(view, None)
        self._keep(view, left)

    def base(self, view: View, revision: int, revisions: Revisions) -> str | None:
        """The text that the page's next edit is made on; None if it is forgotten.

        Args:
            view: the view that it edits.
            revision: the revision that it shows, apart from its own edits.
            revisions: those of the program.
        """
        if revision != self._revision:
            self._revision = revision
            self._own.clear()
        if view in self._own:
            return self._own[view]
        return revisions.text(revision, view)

    def update(self, program: SharedProgram) -> messages.Document:
        """Return the message that brings the page up to date."""
        document, revisions = program.document, program.revisions
        return messages.Document(
            edit=self.edit,
            revision=revisions.number,
            origin=document.origin,
            blocktext=self._new("blocktext", document.blocktext),
            python=self._new("python", document.python),
            workspace=self._new("blocks", document.workspace),
            places=document.places,
            problems=_fewer(document.problems),
            stale=document.stale,
            asked=document.asked,
            can_undo=revisions.can_undo,
            can_redo=revisions.can_redo,
        )

    def _keep(self, view: View, left: str | None) -> None:
        if left is not None:
            self._own[view] = left

    def _new(self, view: View, content: Content) -> Content | None:
        if self._views.get(view) == content:
            return None
        self._views[view] = content
        return content


def _fewer(problems: tuple[Problem, ...]) -> tuple[Problem, ...]:
    """At most `MOST_PROBLEMS` of each view, errors before warnings, and how many are left out."""
    most = max(Counter(problem.view for problem in problems).values(), default=0)
    if most <= MOST_PROBLEMS:
        return problems
    shown: list[Problem] = []
    count: Counter[View] = Counter()
    for problem in sorted(problems, key=lambda problem: problem.severity != "error"):
        count[problem.view] += 1
        if count[problem.view] <= MOST_PROBLEMS:
            shown.append(problem)
    left = Phrase("server-more-problems", count=most - MOST_PROBLEMS)
    return (*shown, Problem("more-problems", left, "warning", shown[-1].view))
