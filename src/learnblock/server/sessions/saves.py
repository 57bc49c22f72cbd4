"""The past contents of an open project's file, to find what another program has changed in it."""

from collections import Counter, deque
from dataclasses import dataclass

from learnblock.server.messages import View
from learnblock.server.program.revisions import Revision
from learnblock.server.projects.project import Project

#: An editor in which a file was opened more saves ago overwrites what was written since.
MOST_SAVES = 50


@dataclass(frozen=True)
class Saved:
    """The content of the file after a save.

    Args:
        project: the project.
        revision: its program.
    """

    project: Project
    revision: Revision


class Saves:
    """The last saves of a project.

    Args:
        first: the content of the file when the project was opened.
    """

    def __init__(self, first: Saved) -> None:
        self._saves = deque([first], maxlen=MOST_SAVES)

    @property
    def last(self) -> Saved:
        """The last save."""
        return self._saves[-1]

    def add(self, saved: Saved) -> None:
        """Record a save."""
        self._saves.append(saved)

    def edited(self, view: View, text: str) -> Saved:
        """The save that another program has most likely edited: the one that differs least.

        An editor may have read the file some saves ago; its author has not changed what was saved
        since. A text that equals an earlier save is an edit of the last save: its author has
        undone what came after.

        Args:
            view: the view in which it was edited.
            text: the text that the other program has written.
        """
        if any(saved.revision.text(view) == text for saved in self._saves):
            return self.last
        lines = Counter(text.split("\n"))
        return min(reversed(self._saves), key=lambda saved: _distance(saved, view, lines))


def _distance(saved: Saved, view: View, lines: Counter[str]) -> int:
    """How many lines differ, wherever they are."""
    before = Counter(saved.revision.text(view).split("\n"))
    return (before - lines).total() + (lines - before).total()
