"""The path of a robot as a line coloured by time, with arrowheads in the direction of travel."""

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from learnblock.simulator.colours import RGB
from learnblock.simulator.picture.palette import PALE, WHITE, time_colour
from learnblock.simulator.picture.svg import Paint, Point, Polygon, Polyline, Shape
from learnblock.simulator.picture.view import PictureView

STEPS = 96
"""The number of colours along the path."""
POINTS_A_STEP = 100
"""The maximum number of points, so that a path of any length makes a small file."""
TOLERANCE = 0.3
"""The number of pixels by which thinning may move the line."""
LINE = 6.0
"""The width of the path in pixels; its white edge is wider."""
EDGE = 10.0
THIN_LINE = 2.0
ARROW_GAP = 105.0
"""Pixels between arrowheads, more if there would be over `MOST_ARROWS`."""
MOST_ARROWS = 48
ARROW_SLACK = 5.0
"""Pixels before and behind an arrowhead over which its direction is measured."""


@dataclass(frozen=True, slots=True, eq=False)
class Track:
    """A thinned path on the page.

    Args:
        points: shape (n, 2), in pixels.
        parts: shape (n,), the fraction of the path's time that has passed, 0 to 1.
        along: shape (n,), pixels from the start along the path.
    """

    points: NDArray[np.float64]
    parts: NDArray[np.float64]
    along: NDArray[np.float64]

    @classmethod
    def of(
        cls,
        path: Sequence[tuple[float, float, float, float]],
        view: PictureView,
        span: tuple[float, float] | None = None,
    ) -> "Track":
        """The track of a path of (time in s, x in mm, y in mm, heading); it has at least one.

        Args:
            path: the path.
            view: the mapping to pixels.
            span: the times of the first and the last colour; by default those of the path.
        """
        times = np.array([time for time, *_ in path])
        points = np.array([view.at(x, y) for _, x, y, _ in path])
        pieces = _pieces(times, points)
        line = np.vstack(pieces)
        steps = np.hypot(*np.diff(line, axis=0).T)
        within = [np.linspace(k, k + 1, len(piece)) / STEPS for k, piece in enumerate(pieces)]
        parts = _of_span(np.concatenate(within), (times[0], times[-1]), span)
        return cls(line, parts, np.concatenate([[0.0], np.cumsum(steps)]))

    @property
    def length(self) -> float:
        """The length in pixels."""
        return float(self.along[-1])

    def at(self, place: float) -> Point:
        """The pixel at this distance along the path."""
        x, y = (float(np.interp(place, self.along, self.points[:, i])) for i in (0, 1))
        return x, y

    def colour(self, place: float) -> RGB:
        """The colour at this distance along the path."""
        return time_colour(float(np.interp(place, self.along, self.parts)))

    def spread(self, gap: float) -> NDArray[np.float64]:
        """Points every `gap` pixels along the path: shape (m, 2)."""
        places = np.arange(0.0, self.length + gap, gap)
        return np.column_stack([np.interp(places, self.along, self.points[:, i]) for i in (0, 1)])

    def drawn(self) -> Iterator[Shape]:
        """The line with its white edge and arrowheads."""
        yield Polyline(_values(self.points), WHITE, EDGE, 0.9)
        step = np.minimum((self.parts * STEPS).astype(int), STEPS - 1)
        for k in range(STEPS):
            places = np.flatnonzero(step == k)
            if not len(places):
                continue
            # A line ends where the next one begins.
            piece = self.points[places[0] : places[-1] + 2]
            yield Polyline(_values(piece), time_colour((k + 0.5) / STEPS), LINE)
        yield from self._arrows()

    def thinly_drawn(self) -> Iterator[Shape]:
        """A thin dotted line, which covers nothing."""
        yield Polyline(_values(self.points), PALE, THIN_LINE, 0.6, dash=(1.0, 5.0))

    def _arrows(self) -> Iterator[Shape]:
        gap = max(ARROW_GAP, self.length / MOST_ARROWS)
        for place in np.arange(gap / 2, self.length - 12, gap).tolist():
            back, tip = self.at(place - ARROW_SLACK), self.at(place + ARROW_SLACK)
            # Where the path turns back on itself, it has no direction to show.
            if math.dist(back, tip) > ARROW_SLACK:
                yield _arrowhead(self.at(place), back, tip, self.colour(place))


def _of_span(
    parts: NDArray[np.float64], own: tuple[float, float], span: tuple[float, float] | None
) -> NDArray[np.float64]:
    """Fractions of a path's own time as fractions of a longer time."""
    if span is None or span == own or span[0] == span[1]:
        return parts
    times = own[0] + parts * (own[1] - own[0])
    return (times - span[0]) / (span[1] - span[0])


def _pieces(times: NDArray[np.float64], points: NDArray[np.float64]) -> list[NDArray[np.float64]]:
    """The path in each of `STEPS` parts of the time, thinned."""
    edges = np.linspace(times[0], times[-1], STEPS + 1)
    ends = np.column_stack([np.interp(edges, times, points[:, i]) for i in (0, 1)])
    first = np.searchsorted(times, edges)
    ways = (points[first[k] : first[k + 1]] for k in range(STEPS))
    return [
        _thinned(np.vstack([ends[k : k + 1], way, ends[k + 1 : k + 2]]))
        for k, way in enumerate(ways)
    ]


def _thinned(points: NDArray[np.float64]) -> NDArray[np.float64]:
    """Thin points by Ramer, Douglas and Peucker, then evenly if there are still too many."""
    simple = cv2.approxPolyDP(points.astype(np.float32)[:, None], TOLERANCE, closed=False)
    inner = np.asarray(simple, np.float64).reshape(-1, 2)[1:-1]
    if len(inner) > POINTS_A_STEP - 2:
        inner = inner[np.linspace(0, len(inner) - 1, POINTS_A_STEP - 2).round().astype(int)]
    return np.vstack([points[:1], inner, points[-1:]])


def _arrowhead(place: Point, back: Point, tip: Point, colour: RGB) -> Polygon:
    angle = math.atan2(tip[1] - back[1], tip[0] - back[0])
    x, y = math.cos(angle), math.sin(angle)
    corners = [(11.0, 0.0), (-7.0, 8.0), (-3.5, 0.0), (-7.0, -8.0)]
    points = [(place[0] + f * x - s * y, place[1] + f * y + s * x) for f, s in corners]
    return Polygon(points, Paint(colour, WHITE, 1.6))


def _values(points: NDArray[np.float64]) -> list[Point]:
    return [(x, y) for x, y in points.tolist()]
