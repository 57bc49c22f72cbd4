"""Headings, and the polylines of lines on the floor.

Headings are degrees, clockwise seen from above, so forward is (cos h, -sin h).
"""

import math
from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

ARC_STEP = 3.0
"""Degrees between the points of a sampled arc: at a radius of 400 mm the error is 0.14 mm."""

Point = tuple[float, float]
Points = NDArray[np.float64]
"""Points of shape (n, 2) in mm."""


@dataclass(frozen=True, slots=True)
class Pose:
    """A position in mm and a heading in degrees."""

    x: float
    y: float
    heading: float

    def ahead(self, distance: float) -> "Pose":
        """The pose `distance` mm further along the heading."""
        x, y = forward(self.heading)
        return Pose(self.x + distance * x, self.y + distance * y, self.heading)

    def along_arc(self, angle: float, radius: float) -> "Pose":
        """The pose after a curve of `radius` mm by `angle` degrees, to the right if positive."""
        side = math.copysign(radius, angle)
        x, y = forward(self.heading + 90)
        center_x, center_y = self.x + side * x, self.y + side * y
        end_x, end_y = forward(self.heading + angle + 90)
        return Pose(center_x - side * end_x, center_y - side * end_y, self.heading + angle)


def forward(heading: float) -> Point:
    """The unit vector of a heading."""
    radians = math.radians(heading)
    return math.cos(radians), -math.sin(radians)


def wrapped(angle: float) -> float:
    """The same direction in degrees from -180 (included) to 180."""
    return (angle + 180.0) % 360.0 - 180.0


def arc(start: Pose, angle: float, radius: float) -> list[Point]:
    """The curve of `Pose.along_arc` every `ARC_STEP` degrees, without its start."""
    pieces = max(1, math.ceil(abs(angle) / ARC_STEP))
    poses = [start.along_arc(angle * i / pieces, radius) for i in range(1, pieces + 1)]
    return [(pose.x, pose.y) for pose in poses]


@dataclass(frozen=True, slots=True, eq=False)
class Polyline:
    """A chain of straight pieces.

    Args:
        points: at least two, no two neighbours at the same position.
    """

    points: Points

    @classmethod
    def through(cls, points: Iterable[Point]) -> "Polyline":
        """Create a polyline through `points`, without consecutive duplicates."""
        array = np.array(list(points), np.float64)
        moved = np.hypot(*np.diff(array, axis=0).T) > 1e-9
        return cls(array[np.concatenate([[True], moved])])

    @property
    def length(self) -> float:
        """Its length in mm."""
        return float(np.hypot(*np.diff(self.points, axis=0).T).sum())

    def nearest(self, x: float, y: float) -> tuple[float, float]:
        """The distance of (x, y) from the line, and of the nearest point along it, both in mm."""
        starts = self.points[:-1]
        sides = np.diff(self.points, axis=0)
        lengths = np.hypot(sides[:, 0], sides[:, 1])
        offsets = np.array([x, y]) - starts
        parts = np.clip((offsets * sides).sum(axis=1) / lengths**2, 0.0, 1.0)
        gaps = offsets - parts[:, None] * sides
        distances = np.hypot(gaps[:, 0], gaps[:, 1])
        piece = int(distances.argmin())
        along = lengths[:piece].sum() + parts[piece] * lengths[piece]
        return float(distances[piece]), float(along)
