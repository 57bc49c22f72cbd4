"""What the pages have received of the drawing on the floor."""

from collections.abc import Sequence
from typing import TYPE_CHECKING

from learnblock.server import messages

if TYPE_CHECKING:
    from learnblock.monitor import Stroke


class Drawn:
    """Finds what a drawing has gained, because sending all of it again would be too much."""

    def __init__(self) -> None:
        #: The strokes that were sent, with the number of their points.
        self._sent: list[tuple[Stroke, int]] = []
        self._is_known = False

    def forget(self) -> None:
        """Send everything with the next message, because a page has joined."""
        self._sent.clear()
        self._is_known = False

    def news(self, strokes: "Sequence[Stroke]") -> messages.Drawing | None:
        """The message about what is new; None if nothing is.

        Args:
            strokes: the drawing now.
        """
        fresh = not self._is_known or not self._continues(strokes)
        if fresh:
            self._sent.clear()
        self._is_known = True
        parts = tuple(filter(None, map(self._part, range(len(strokes)), strokes)))
        return messages.Drawing(fresh, parts) if fresh or parts else None

    def _continues(self, strokes: "Sequence[Stroke]") -> bool:
        """Whether the drawing still has every stroke that was sent, in the same order."""
        return len(strokes) >= len(self._sent) and all(
            stroke is sent for stroke, (sent, _) in zip(strokes, self._sent, strict=False)
        )

    def _part(self, index: int, stroke: "Stroke") -> messages.StrokePart | None:
        if index == len(self._sent):
            self._sent.append((stroke, 0))
        sent = self._sent[index][1]
        # The world may add points meanwhile.
        points = tuple(stroke.points[sent:])
        self._sent[index] = stroke, sent + len(points)
        return messages.StrokePart(index, stroke.colour, stroke.width, points) if points else None
