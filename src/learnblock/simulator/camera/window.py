"""The part of a picture that an outline covers."""

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from learnblock.simulator.camera.vectors import Point, Vector

# Pixels with their centre on an edge belong to both neighbours, so that there is no gap.
EDGE_SLACK = 1e-3


@dataclass(frozen=True, slots=True)
class Window:
    """Columns left..right and rows top..bottom of the picture; right and bottom are exclusive."""

    left: int
    top: int
    right: int
    bottom: int

    @classmethod
    def around(cls, outline: Sequence[Point], width: int, height: int) -> "Window":
        xs, ys = [x for x, _ in outline], [y for _, y in outline]
        return cls(
            max(0, math.ceil(min(xs) - EDGE_SLACK)),
            max(0, math.ceil(min(ys) - EDGE_SLACK)),
            min(width, math.floor(max(xs) + EDGE_SLACK) + 1),
            min(height, math.floor(max(ys) + EDGE_SLACK) + 1),
        )

    @property
    def is_empty(self) -> bool:
        return self.left >= self.right or self.top >= self.bottom

    @property
    def slices(self) -> tuple[slice, slice]:
        return slice(self.top, self.bottom), slice(self.left, self.right)

    def meets(self, other: "Window") -> bool:
        """Whether they have pixels in common."""
        across = max(self.left, other.left) < min(self.right, other.right)
        return across and max(self.top, other.top) < min(self.bottom, other.bottom)

    def shift(self, plane: Vector) -> Vector:
        """An affine function of the picture's pixels as a function of the window's pixels."""
        a, b, c = plane
        return a, b, c + a * self.left + b * self.top


def edges(outline: Sequence[Point], window: Window) -> Iterator[Vector]:
    """For each side of the outline that crosses the window, its distance to a pixel as an affine
    function, at least zero inside.
    """
    for (x, y), (next_x, next_y) in zip(outline, (*outline[1:], outline[0]), strict=True):
        length = math.hypot(next_x - x, next_y - y)
        if length == 0:
            continue
        a, b = (y - next_y) / length, (next_x - x) / length
        edge = (a, b, EDGE_SLACK - a * x - b * y)
        if not _is_nowhere_negative(edge, window):
            yield edge


def bounds(plane: Vector, window: Window) -> tuple[float, float]:
    """The lowest and the highest value of an affine function at the pixels of a window."""
    a, b, c = plane
    along = sorted((a * window.left, a * (window.right - 1)))
    down = sorted((b * window.top, b * (window.bottom - 1)))
    return along[0] + down[0] + c, along[1] + down[1] + c


def _is_nowhere_negative(plane: Vector, window: Window) -> bool:
    a, b, c = plane
    column = window.left if a > 0 else window.right - 1
    row = window.top if b > 0 else window.bottom - 1
    return a * column + b * row + c >= 0
