"""The hints for a run, which its pages are given one level after the other."""

from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from learnblock.server import messages
from learnblock.server.sessions import lesson_view as view

if TYPE_CHECKING:
    from learnblock.lessons.hints import Hint


@dataclass(frozen=True)
class HintSeries:
    """Hints, the best first, of which the first levels have been given.

    Args:
        hints: all of them; each has at least one level.
        given: how many levels have been given, those of the first hint first.
    """

    hints: "tuple[Hint, ...]" = ()
    given: int = 0

    @property
    def has_more(self) -> bool:
        """Whether there is a level that has not been given."""
        return self.given < sum(len(hint.levels) for hint in self.hints)

    def longer(self) -> "HintSeries":
        """With the next level of the last hint given, or with the first one of the next hint."""
        return replace(self, given=self.given + 1)

    def shown(self) -> Iterator[messages.LessonHint]:
        """What has been given, as pages show it."""
        left = self.given
        for hint in self.hints:
            if left <= 0:
                return
            # Why it was chosen is for the teacher: it may say what to change.
            yield messages.LessonHint(tuple(map(view.words, hint.levels[:left])))
            left -= len(hint.levels)
