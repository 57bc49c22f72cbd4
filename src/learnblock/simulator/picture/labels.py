"""Positions for labels: near their objects, apart from each other, and off the path if possible."""

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from learnblock.simulator.picture.svg import Point

DISTANCES = (0.0, 14.0, 32.0, 56.0, 86.0, 120.0)
"""The distances to try, in this order, in pixels."""
DIRECTIONS = 16
GAP = 4.0
"""Pixels between two labels."""
DISTANCE_COST = 0.06
"""The covered path points that outweigh placing a label one pixel farther away."""
BUSY_MARGIN = 6.0
"""The preferred distance in pixels between a label and the middle of the path."""
LEADER_STEP = 6.0
"""Pixels between the points that represent the line from a label to its object."""
LEADER_WEIGHT = 8
"""The number of path points that one of these equals."""


_NO_POINTS = np.empty((0, 2))


@dataclass(frozen=True, slots=True)
class Rectangle:
    """A rectangle on the page."""

    left: float
    top: float
    right: float
    bottom: float

    def overlaps(self, other: "Rectangle") -> bool:
        """Whether the boxes are closer together than `GAP`."""
        return (
            self.left < other.right + GAP
            and other.left < self.right + GAP
            and self.top < other.bottom + GAP
            and other.top < self.bottom + GAP
        )

    def holds(self, other: "Rectangle") -> bool:
        return (
            self.left <= other.left
            and self.top <= other.top
            and other.right <= self.right
            and other.bottom <= self.bottom
        )

    def grown(self, margin: float) -> "Rectangle":
        return Rectangle(
            self.left - margin, self.top - margin, self.right + margin, self.bottom + margin
        )

    @classmethod
    def around(cls, center: Point, radius: float) -> "Rectangle":
        x, y = center
        return cls(x - radius, y - radius, x + radius, y + radius)


@dataclass(frozen=True, slots=True)
class Spot:
    """The position of a label.

    Args:
        head: the middle of its icon, or the end of its text nearer to its object.
        side: 1 if the text runs to the right of the head, -1 if to the left.
        box: the whole label.
    """

    head: Point
    side: int
    box: Rectangle


class LabelSpace:
    """The page while labels are placed on it.

    Args:
        bounds: the area that no label may leave.
        busy: shape (n, 2), pixels that labels should not cover.
    """

    def __init__(self, bounds: Rectangle, busy: NDArray[np.float64]) -> None:
        self._bounds = bounds
        self._busy = busy
        self._taken: list[Rectangle] = []

    def take(self, box: Rectangle) -> None:
        """Keep all later labels off a box."""
        self._taken.append(box)

    def place(
        self, anchor: Point, icon: float, text: float, clear: float, *, leader: bool = True
    ) -> Spot | None:
        """The best place that is free, which is then taken; None if nothing is free.

        Args:
            anchor: the point to be labelled.
            icon: the icon's radius.
            text: the text's width.
            clear: how far from the anchor the icon must stay.
            leader: whether a line is drawn from the anchor, which should not cross a label either.
        """
        best, least = None, math.inf
        for distance in DISTANCES:
            for index in range(DIRECTIONS):
                angle = 2 * math.pi * (index + 0.5) / DIRECTIONS
                spot = _spot(anchor, clear + icon + distance, angle, icon, text)
                lead = _leader(anchor, spot) if leader else _NO_POINTS
                cost = self._cost(anchor, lead, spot.box) + distance * DISTANCE_COST
                if cost < least:
                    best, least = spot, cost
        if best is not None:
            self.take(best.box)
        if best is not None and leader:
            self._busy = np.vstack([self._busy, *[_leader(anchor, best)] * LEADER_WEIGHT])
        return best

    def _cost(self, anchor: Point, leader: NDArray[np.float64], box: Rectangle) -> float:
        if not self._bounds.holds(box) or any(box.overlaps(other) for other in self._taken):
            return math.inf
        # Every leader crosses the boxes that contain the anchor.
        crossed = sum(
            _count(leader, b) for b in self._taken if not b.holds(Rectangle.around(anchor, 0))
        )
        return _count(self._busy, box.grown(BUSY_MARGIN)) + LEADER_WEIGHT * crossed


def _leader(anchor: Point, spot: Spot) -> NDArray[np.float64]:
    """Points every few pixels between an object and its label."""
    count = 2 + int(math.dist(anchor, spot.head) / LEADER_STEP)
    return np.linspace(anchor, spot.head, count)


def _count(points: NDArray[np.float64], box: Rectangle) -> int:
    x, y = points[:, 0], points[:, 1]
    within = (x > box.left) & (x < box.right) & (y > box.top) & (y < box.bottom)
    return int(np.count_nonzero(within))


def _spot(anchor: Point, distance: float, angle: float, icon: float, text: float) -> Spot:
    x = anchor[0] + distance * math.cos(angle)
    y = anchor[1] + distance * math.sin(angle)
    side = 1 if math.cos(angle) > 0 else -1
    far = x + side * (icon + text)
    near = x - side * icon
    half = max(icon, 10.0)
    return Spot((x, y), side, Rectangle(min(near, far), y - half, max(near, far), y + half))
