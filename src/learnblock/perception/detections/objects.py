"""The results of the detector of coloured objects."""

from dataclasses import dataclass

from learnblock.perception.detections.points import Point

# The columns, of a frame 320 wide, between which an object is in the centre.
LEFT_BORDER, RIGHT_BORDER = 120, 200


@dataclass(frozen=True, slots=True)
class ColouredObject:
    """A connected patch of one colour in a frame, as the rectangle around it.

    Args:
        colour: ``red``, ``orange``, ``yellow``, ``green``, ``blue`` or ``purple``.
        center: (column, row) of its centre of mass in pixels.
        area: the number of its pixels.
        x: column of its left edge, pixels.
        y: row of its top edge, pixels.
        width: in pixels.
        height: in pixels.
        frame_width: in pixels.
        frame_height: in pixels.
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
    def share(self) -> float:
        """The part of the frame that it covers, 0 to 1."""
        return self.area / (self.frame_width * self.frame_height)

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
