"""The bar that shows the time of each colour of the path."""

import math
from collections.abc import Iterator

from learnblock.simulator.picture.palette import INK, PALE, WHITE, time_colour
from learnblock.simulator.picture.svg import (
    Paint,
    Point,
    Polygon,
    Polyline,
    Shape,
    SvgText,
    rectangle,
)
from learnblock.simulator.picture.view import round_step

WIDTH = 18.0
"""Pixels."""
PIECES = 96
TICKS = 7
"""The approximate number of times on the bar."""


def drawn(start: float, end: float, corner: Point, height: float) -> Iterator[Shape]:
    """The colours from `start` (below) to `end` (above), labelled in seconds.

    Args:
        start: the start time in s.
        end: the end time in s.
        corner: the upper left corner in pixels.
        height: the height in pixels.
    """
    left, top = corner
    for k in range(PIECES):
        # All extend to the top, each over the previous one: side by side they would show seams.
        piece = rectangle(left, top, WIDTH, height * (1 - k / PIECES))
        yield Polygon(piece, Paint(time_colour((k + 0.5) / PIECES)))
    yield Polygon(rectangle(left, top, WIDTH, height), Paint(stroke=WHITE, width=1.5))
    yield SvgText((left - 2, top - 16), "time", 15, PALE, bold=True)
    right = left + WIDTH
    for time in ticks(start, end):
        y = top + height * (1 - (time - start) / max(end - start, 1e-9))
        yield Polyline([(right + 3, y), (right + 9, y)], PALE, 1.5, cap="butt")
        yield SvgText((right + 14, y + 5), f"{time:g} s", 15, INK)


def ticks(start: float, end: float) -> list[float]:
    """Round times from `start` to `end`."""
    step = round_step(max(end - start, 0.01) / TICKS)
    first, last = math.ceil(start / step - 1e-6), math.floor(end / step + 1e-6)
    return [k * step for k in range(first, last + 1)]
