"""Lines on the floor, as chains of straight pieces."""

import math
from collections.abc import Iterable
from dataclasses import dataclass
from functools import cached_property
from operator import itemgetter

import numpy as np
from numpy.typing import NDArray

from learnblock.simulator.geometry import Point

CELL = 20.0
"""The side in mm of the squares for which a polyline remembers its nearest pieces."""
TIES = 1 + 1e-9
"""Squared distances that differ by less than this factor may be the same distance."""

Points = NDArray[np.float64]
"""Points of shape (n, 2) in mm."""
Piece = tuple[float, float, float, float, float, float, float]
"""A straight piece: its start (x, y), its side (x, y), the square of its length, how far along the
line it begins, and its length."""


@dataclass(frozen=True, eq=False)
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
        return float(self._lengths.sum())

    def nearest(self, x: float, y: float) -> tuple[float, float]:
        """The distance of (x, y) from the line, and of the nearest point along it, both in mm."""
        cell = int(x // CELL), int(y // CELL)
        pieces = self._cells.get(cell)
        if pieces is None:
            pieces = self._cells[cell] = self._pieces_near(cell)
        return min(_least_distances(x, y, pieces), key=_DISTANCE)

    def distance(self, x: float, y: float) -> float:
        """The distance of (x, y) from the line in mm."""
        return self.nearest(x, y)[0]

    @cached_property
    def _sides(self) -> Points:
        return np.diff(self.points, axis=0)

    @cached_property
    def _lengths(self) -> NDArray[np.float64]:
        return np.hypot(self._sides[:, 0], self._sides[:, 1])

    @cached_property
    def _squares(self) -> NDArray[np.float64]:
        return self._lengths**2

    @cached_property
    def _begins(self) -> list[float]:
        """How far along the line each piece begins."""
        return [float(self._lengths[:piece].sum()) for piece in range(len(self._lengths))]

    @cached_property
    def _pieces(self) -> list[Piece]:
        begins = np.array(self._begins)[:, None]
        columns = self.points[:-1], self._sides, self._squares[:, None], begins
        rows = np.hstack((*columns, self._lengths[:, None])).tolist()
        return [(a, b, c, d, e, f, g) for a, b, c, d, e, f, g in rows]

    # Why: docs/decisions.md, "Nothing is computed twice that cannot have changed"
    @cached_property
    def _cells(self) -> dict[tuple[int, int], list[Piece]]:
        """For each square of the plane in use, the pieces that may be nearest to a point in it."""
        return {}

    def _pieces_near(self, cell: tuple[int, int]) -> list[Piece]:
        distances = self._distances(*((index + 0.5) * CELL for index in cell))
        # A point of the square is at most half a diagonal from its middle.
        reach = distances.min() + CELL * 1.4143
        return [self._pieces[piece] for piece in np.flatnonzero(distances <= reach)]

    def _distances(self, x: float, y: float) -> NDArray[np.float64]:
        """The distance of (x, y) from each piece in mm."""
        offsets = np.array([x, y]) - self.points[:-1]
        parts = np.clip((offsets * self._sides).sum(axis=1) / self._squares, 0.0, 1.0)
        gaps = offsets - parts[:, None] * self._sides
        distances: NDArray[np.float64] = np.hypot(gaps[:, 0], gaps[:, 1])
        return distances


_DISTANCE = itemgetter(0)


def _least_distances(x: float, y: float, pieces: Iterable[Piece]) -> list[tuple[float, float]]:
    """How far (x, y) is from the nearest piece, and that along the line; several if it may be any.

    Squares of distances decide first, because roots take longer.
    """
    limit, distances = math.inf, []
    for start_x, start_y, side_x, side_y, square_length, begin, length in pieces:
        east, north = x - start_x, y - start_y
        part = (east * side_x + north * side_y) / square_length
        if part < 0.0:
            part = 0.0
        elif part > 1.0:
            part = 1.0
        east -= part * side_x
        north -= part * side_y
        square = east * east + north * north
        if square <= limit:
            distances.append((square, east, north, begin + part * length))
            limit = min(limit, square * TIES)
    # The absolute value of a complex number is the C library's hypotenuse, as in numpy;
    # `math.hypot` may differ in the last bit, which a sensor at the edge of a line would notice.
    return [(abs(complex(e, n)), along) for square, e, n, along in distances if square <= limit]
