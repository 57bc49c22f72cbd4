"""The results of the detector of lines."""

from dataclasses import dataclass

# The minimum pixels of a colour in a line, and of red and black in the centre of a crossing.
LINE_PIXELS = 20
CROSSING_PIXELS = 40


@dataclass(frozen=True, slots=True)
class LineView:
    """The amount of one colour in the left, the centre and the right of a frame.

    Args:
        colour: ``black``, ``red`` or ``blue``.
        left: pixels in the left three eighths of the columns.
        center: pixels in the two eighths between.
        right: pixels in the right three eighths.
        frame_width: in pixels.
        frame_height: in pixels.
    """

    colour: str
    left: int
    center: int
    right: int
    frame_width: int = 320
    frame_height: int = 240

    @property
    def is_there(self) -> bool:
        """Whether any side contains more than 20 line pixels."""
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
        """The side with the most pixels; if equal, the center, then the left."""
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
        """Whether a red and a black line meet: the center has more than 40 pixels of each."""
        return all(view.has_more(CROSSING_PIXELS, view.center) for view in (self.red, self.black))
