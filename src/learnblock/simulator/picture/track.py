"""The path of a robot as a line coloured by time, and the bar that tells the colours' times."""

import math
from collections.abc import Iterator
from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from learnblock.simulator.colours import RGB
from learnblock.simulator.picture.svg import Paint, Point, Polygon, Polyline, Shape, Text
from learnblock.simulator.picture.view import View, round_step

# Matplotlib's perceptually even map "plasma" (public domain, CC0) at 0/9, 1/9, ... 7/9: its
# yellow end is left out, which would not show on a white floor.
_PLASMA = np.array(
    [
        (13, 8, 135),
        (70, 3, 159),
        (114, 1, 168),
        (156, 23, 158),
        (189, 55, 134),
        (216, 87, 107),
        (237, 121, 83),
        (251, 159, 58),
    ],
    np.float64,
)
STEPS = 96
"""Colours along the path."""
POINTS_A_STEP = 100
"""At most, so that a path of any length makes a small file."""
TOLERANCE = 0.3
"""Pixels by which thinning may move the line."""
LINE = 6.0
"""Width of the path, pixels; its white edge is wider."""
CASING = 10.0
ARROW_GAP = 105.0
"""Pixels of path from one arrowhead to the next, more where there would be over `MOST_ARROWS`."""
MOST_ARROWS = 60
INK: RGB = (45, 48, 56)
PALE: RGB = (110, 114, 124)


@dataclass(frozen=True, slots=True, eq=False)
class Track:
    """A path on the page.

    Args:
        times: shape (n,), s, never falling.
        points: shape (n, 2), pixels.
    """

    times: NDArray[np.float64]
    points: NDArray[np.float64]

    @classmethod
    def of(cls, path: NDArray[np.float64], view: View) -> "Track":
        """The track of a path with rows (time, x, y, ...)."""
        points = [view.at(x, y) for x, y in path[:, 1:3].tolist()]
        return cls(path[:, 0], np.array(points).reshape(-1, 2))

    @property
    def start(self) -> float:
        return float(self.times[0])

    @property
    def end(self) -> float:
        return float(self.times[-1])

    def at(self, time: float) -> Point:
        """The pixel where the robot was at a time."""
        x = np.interp(time, self.times, self.points[:, 0])
        y = np.interp(time, self.times, self.points[:, 1])
        return float(x), float(y)

    def colour(self, time: float) -> RGB:
        """The colour of a time."""
        span = self.end - self.start
        return time_colour((time - self.start) / span if span > 0 else 0.0)

    def pieces(self) -> list[tuple[float, NDArray[np.float64]]]:
        """The thinned path in `STEPS` pieces of equal time: (middle time, points)."""
        edges = np.linspace(self.start, self.end, STEPS + 1)
        inner = np.searchsorted(self.times, edges)
        pieces = []
        for k in range(STEPS):
            ends = self.at(edges[k]), self.at(edges[k + 1])
            within = self.points[inner[k] : inner[k + 1]]
            points = np.vstack([ends[:1], within, ends[1:]])
            pieces.append((float(edges[k] + edges[k + 1]) / 2, _thinned(points)))
        return pieces


def time_colour(part: float) -> RGB:
    """The colour of a time, 0 for the path's start to 1 for its end."""
    place = min(max(part, 0.0), 1.0) * (len(_PLASMA) - 1)
    red, green, blue = (
        round(float(np.interp(place, np.arange(len(_PLASMA)), channel))) for channel in _PLASMA.T
    )
    return red, green, blue


def drawn(track: Track) -> Iterator[Shape]:
    """The line with its white edge and arrowheads in the direction of travel."""
    pieces = track.pieces()
    line = np.vstack([points for _, points in pieces])
    yield Polyline(_points(_thinned(line, POINTS_A_STEP * STEPS)), (255, 255, 255), CASING, 0.9)
    for time, points in pieces:
        yield Polyline(_points(points), track.colour(time), LINE)
    times = np.repeat([time for time, _ in pieces], [len(points) for _, points in pieces])
    yield from _arrows(track, times, line)


def spread(track: Track, gap: float) -> NDArray[np.float64]:
    """Points every `gap` pixels along the thinned path: shape (n, 2)."""
    line = np.vstack([points for _, points in track.pieces()])
    along = _along(line)
    places = np.arange(0.0, along[-1] + gap, gap)
    return np.column_stack([np.interp(places, along, line[:, i]) for i in (0, 1)])


def bar(track: Track, left: float, top: float, height: float) -> Iterator[Shape]:
    """The colours from the start's time (below) to the end's, labelled in seconds."""
    width, pieces = 18.0, 80
    for k in range(pieces):
        low, high = top + height * (1 - k / pieces), top + height * (1 - (k + 1) / pieces)
        # Each piece reaches a little under the next, or the paper would shine through.
        corners = _rectangle(left, min(low + 0.6, top + height), left + width, high)
        yield Polygon(corners, Paint(time_colour((k + 0.5) / pieces)))
    frame = _rectangle(left, top + height, left + width, top)
    yield Polygon(frame, Paint(stroke=(255, 255, 255), width=1.5))
    yield Text((left - 2, top - 16), "time", 15, PALE, bold=True)
    for time in _ticks(track.start, track.end):
        y = top + height * (1 - (time - track.start) / max(track.end - track.start, 1e-9))
        yield Polyline([(left + width + 3, y), (left + width + 9, y)], PALE, 1.5, cap="butt")
        yield Text((left + width + 14, y + 5), f"{time:g} s", 15, INK)


def _ticks(start: float, end: float) -> list[float]:
    step = round_step(max(end - start, 0.01) / 7)
    first = math.ceil(start / step - 1e-9)
    return [k * step for k in range(first, math.floor(end / step + 1e-9) + 1)]


def _arrows(track: Track, times: NDArray[np.float64], line: NDArray[np.float64]) -> Iterator[Shape]:
    along = _along(line)
    gap = max(ARROW_GAP, float(along[-1]) / MOST_ARROWS)
    for place in np.arange(gap / 2, along[-1] - 12, gap).tolist():
        back, tip = _on(line, along, place - 5), _on(line, along, place + 5)
        colour = track.colour(float(np.interp(place, along, times)))
        if math.dist(back, tip) > 5:
            yield _arrowhead(
                _on(line, along, place), math.atan2(tip[1] - back[1], tip[0] - back[0]), colour
            )


def _arrowhead(place: Point, angle: float, colour: RGB) -> Polygon:
    x, y = math.cos(angle), math.sin(angle)
    corners = [(11.0, 0.0), (-7.0, 8.0), (-3.5, 0.0), (-7.0, -8.0)]
    points = [(place[0] + f * x - s * y, place[1] + f * y + s * x) for f, s in corners]
    return Polygon(points, Paint(colour, (255, 255, 255), 1.6))


def _along(line: NDArray[np.float64]) -> NDArray[np.float64]:
    steps = np.hypot(*np.diff(line, axis=0).T)
    return np.concatenate([[0.0], np.cumsum(steps)])


def _on(line: NDArray[np.float64], along: NDArray[np.float64], place: float) -> Point:
    x, y = (float(np.interp(place, along, line[:, i])) for i in (0, 1))
    return x, y


def _thinned(points: NDArray[np.float64], most: int = POINTS_A_STEP) -> NDArray[np.float64]:
    """By Ramer, Douglas and Peucker, then evenly if there are still too many."""
    kept = points
    if len(points) > 2:
        simple = cv2.approxPolyDP(points.astype(np.float32)[:, None], TOLERANCE, closed=False)
        kept = np.asarray(simple, np.float64).reshape(-1, 2)
    if len(kept) > most:
        kept = kept[np.linspace(0, len(kept) - 1, most).round().astype(int)]
    return kept


def _points(array: NDArray[np.float64]) -> list[Point]:
    return [(float(x), float(y)) for x, y in array]


def _rectangle(left: float, bottom: float, right: float, top: float) -> list[Point]:
    return [(left, bottom), (right, bottom), (right, top), (left, top)]
