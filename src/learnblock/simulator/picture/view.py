"""The part of the world that is shown, and the mapping from its positions to pixels."""

import math
from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from learnblock.simulator.picture.svg import Point

WIDTH = 1200.0
"""The width of the page in pixels; all lengths below are in pixels."""
MARGIN = 56.0
HEADER = 116.0
FOOTER = 78.0
BAR_COLUMN = 118.0
"""Space beside the world, for the colour bar."""
TALLEST = 1000.0
LOWEST = 300.0

AROUND = 25.0
"""The margin in mm shown around the floor, or around a path that leaves it."""


@dataclass(frozen=True, slots=True)
class PictureView:
    """The world on the page.

    Args:
        scale: pixels per mm.
        middle: the pixel of (`x`, `y`).
        x: mm of the middle of the shown part.
        y: the same for y.
        plot: width and height of the part of the page that shows the world, pixels.
    """

    scale: float
    middle: Point
    x: float
    y: float
    plot: tuple[float, float]

    def at(self, x: float, y: float) -> Point:
        """The pixel of a position in mm; north is up."""
        middle_x, middle_y = self.middle
        return middle_x + (x - self.x) * self.scale, middle_y - (y - self.y) * self.scale

    def all(self, points: Iterable[Point]) -> list[Point]:
        return [self.at(x, y) for x, y in points]

    def placed(self, outline: Iterable[Point], x: float, y: float, heading: float) -> list[Point]:
        """An outline given as (forward, left) in mm from a pose."""
        cosine, sine = math.cos(math.radians(heading)), math.sin(math.radians(heading))
        return self.all(
            (x + forward * cosine + left * sine, y - forward * sine + left * cosine)
            for forward, left in outline
        )

    @property
    def page_height(self) -> float:
        return HEADER + self.plot[1] + FOOTER


def fitted(floor: tuple[float, float], places: NDArray[np.float64], *, bar: bool) -> PictureView:
    """The largest view of the floor that also contains all positions.

    Args:
        floor: the size of the floor in mm.
        places: shape (n, 2), mm.
        bar: whether to leave room for the colour bar on the right.
    """
    corner = np.array(floor) / 2
    shown = np.vstack([places, corner, -corner])
    low, high = shown.min(axis=0) - AROUND, shown.max(axis=0) + AROUND
    east_west, north_south = (high - low).tolist()
    width = WIDTH - 2 * MARGIN - (BAR_COLUMN if bar else 0.0)
    scale = min(width / east_west, TALLEST / north_south)
    height = max(LOWEST, north_south * scale)
    x, y = ((low + high) / 2).tolist()
    return PictureView(scale, (MARGIN + width / 2, HEADER + height / 2), x, y, (width, height))


def round_step(least: float) -> float:
    """The smallest of 1, 2, 5, 10, 20, ... and their tenths that is not below `least`."""
    power = 10.0 ** math.floor(math.log10(least))
    return next(power * factor for factor in (1, 2, 5, 10) if power * factor >= least * 0.999999)
