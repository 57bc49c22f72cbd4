"""Headings, poses and curves.

Headings are degrees, clockwise seen from above, so forward is (cos h, -sin h).
"""

import math

import msgspec

ARC_STEP = 3.0
"""Degrees between the points of a sampled arc: at a radius of 400 mm the error is 0.14 mm."""

Point = tuple[float, float]


# Why: docs/decisions.md, "Steps and rays call pymunk's library directly"
class Pose(msgspec.Struct, frozen=True):
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
