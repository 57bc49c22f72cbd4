"""What detectors find: plain values that travel between processes.

Columns grow to the right and rows downwards. Thresholds are given for a frame of 320 by 240 pixels
and scale with the frame that a detection carries the size of.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType
from typing import Any

Point = tuple[float, float]

# A tag within this many pixels of the middle column counts as being in the centre.
CENTRE_REACH = 40
# So many pixels of a colour are a line, and so many red and black ones in the centre a crossing.
LINE_PIXELS = 20
CROSSING_PIXELS = 40
# The columns, of a frame 320 wide, between which an object counts as being in the centre.
LEFT_BORDER, RIGHT_BORDER = 120, 200


@dataclass(frozen=True, slots=True)
class Tag:
    """An AprilTag of family 36h11 in a frame.

    Args:
        id: its number, 0 to 586.
        center: (column, row) in pixels.
        corners: (column, row) of the black square's top left, top right, bottom right and bottom
            left, named as they are when the tag stands as `learnblock.simulator.textures.tag`
            draws it.
        distance: from the lens to the tag's centre in mm, or None where the lens or the tag's size
            is not known.
        frame_width: pixels.
        frame_height: pixels.
    """

    id: int
    center: Point
    corners: tuple[Point, Point, Point, Point]
    distance: float | None = None
    frame_width: int = 320
    frame_height: int = 240

    @property
    def offset(self) -> float:
        """Pixels of a frame 320 wide from the middle column; to the right is positive."""
        return (self.center[0] - 0.5 * (self.frame_width - 1)) * 320 / self.frame_width

    @property
    def is_left(self) -> bool:
        return self.offset < -CENTRE_REACH

    @property
    def is_right(self) -> bool:
        return self.offset > CENTRE_REACH

    @property
    def is_center(self) -> bool:
        return abs(self.offset) <= CENTRE_REACH


@dataclass(frozen=True, slots=True)
class LineView:
    """How much of one colour is seen in the left, the center and the right of a frame.

    Args:
        colour: ``black``, ``red`` or ``blue``.
        left: pixels in the left three eighths of the columns.
        center: pixels in the two eighths between.
        right: pixels in the right three eighths.
        frame_width: pixels.
        frame_height: pixels.
    """

    colour: str
    left: int
    center: int
    right: int
    frame_width: int = 320
    frame_height: int = 240

    @property
    def is_there(self) -> bool:
        """Some side has more than 20 pixels."""
        return self.has_more(LINE_PIXELS, max(self.left, self.center, self.right))

    def has_more(self, threshold: int, count: int) -> bool:
        """Whether `count` pixels are more than `threshold` in a frame of 320 by 240."""
        return count * (320 * 240) > threshold * self.frame_width * self.frame_height

    @property
    def is_center(self) -> bool:
        return self.is_there and self._side() == "center"

    @property
    def is_left(self) -> bool:
        return self.is_there and self._side() == "left"

    @property
    def is_right(self) -> bool:
        return self.is_there and self._side() == "right"

    def _side(self) -> str:
        """Where most is; of sides with equally much the center, then the left."""
        counts = {"center": self.center, "left": self.left, "right": self.right}
        return max(counts, key=counts.__getitem__)


@dataclass(frozen=True, slots=True)
class Lines:
    """The lines of each colour in one frame."""

    black: LineView
    red: LineView
    blue: LineView

    @property
    def is_crossing(self) -> bool:
        """A red and a black line meet: the center has more than 40 pixels of each."""
        return all(view.has_more(CROSSING_PIXELS, view.center) for view in (self.red, self.black))


@dataclass(frozen=True, slots=True)
class Face:
    """A face in a frame, by the rectangle around it.

    Args:
        x: column of its left edge, pixels.
        y: row of its top edge, pixels.
        width: pixels.
        height: pixels.
        frame_width: pixels.
        frame_height: pixels.
    """

    x: int
    y: int
    width: int
    height: int
    frame_width: int = 320
    frame_height: int = 240

    @property
    def center(self) -> Point:
        """(column, row) of its middle."""
        return self.x + 0.5 * self.width, self.y + 0.5 * self.height

    @property
    def is_left(self) -> bool:
        """In the left third of the frame."""
        return self._column() == 0

    @property
    def is_right(self) -> bool:
        """In the right third of the frame."""
        return self._column() == 2

    @property
    def is_up(self) -> bool:
        """In the upper third of the frame."""
        return self._row() == 0

    @property
    def is_down(self) -> bool:
        """In the lower third of the frame."""
        return self._row() == 2

    @property
    def is_center(self) -> bool:
        """In the middle one of the frame's three by three cells."""
        return self._column() == 1 and self._row() == 1

    def _column(self) -> int:
        return min(2, int(3 * self.center[0] / self.frame_width))

    def _row(self) -> int:
        return min(2, int(3 * self.center[1] / self.frame_height))


@dataclass(frozen=True, slots=True)
class FaceEmotion:
    """A face in a frame and what it expresses.

    Args:
        face: where it is.
        emotion: ``fear``, ``surprise``, ``anger``, ``sadness``, ``disgust``, ``joy`` or
            ``neutral``, as `learnblock.devices.Emotion` names them.
        confidence: how sure the classifier is, 0 to 1.
    """

    face: Face
    emotion: str
    confidence: float


@dataclass(frozen=True, slots=True)
class ColouredObject:
    """A connected patch of one colour in a frame, by the rectangle around it.

    Args:
        colour: ``red``, ``orange``, ``yellow``, ``green``, ``blue`` or ``purple``.
        center: (column, row) of its centre of mass in pixels.
        area: its pixels.
        x: column of its left edge, pixels.
        y: row of its top edge, pixels.
        width: pixels.
        height: pixels.
        frame_width: pixels.
        frame_height: pixels.
    """

    colour: str
    center: Point
    area: int
    x: int
    y: int
    width: int
    height: int
    frame_width: int = 320
    frame_height: int = 240

    @property
    def is_left(self) -> bool:
        """In the left three eighths of the frame."""
        return self.center[0] * 320 < LEFT_BORDER * self.frame_width

    @property
    def is_right(self) -> bool:
        """In the right three eighths of the frame."""
        return self.center[0] * 320 > RIGHT_BORDER * self.frame_width

    @property
    def is_center(self) -> bool:
        """In the quarter of the frame between."""
        return not self.is_left and not self.is_right


#: What each detector answers, by its name.
KINDS: Mapping[str, Any] = MappingProxyType(
    {
        "lines": Lines,
        "tags": tuple[Tag, ...],
        "objects": tuple[ColouredObject, ...],
        "faces": tuple[Face, ...],
        "emotions": tuple[FaceEmotion, ...],
    }
)
