"""Whether the goals of a world can be reached, on a grid over its floor.

The check is on the robot's side: it reports a goal only if no robot of this width gets there, so it
ignores objects that can be pushed, and how a robot has to turn.
"""

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise
from types import MappingProxyType
from typing import Literal

import cv2
import numpy as np
from numpy.typing import NDArray

from learnblock.i18n import Phrase
from learnblock.simulator.geometry import Point, forward
from learnblock.simulator.goal_description import Follow, Reach, Show, Stop, Tour, Visit
from learnblock.simulator.physics import BOARD_THICKNESS
from learnblock.simulator.props import solid_props
from learnblock.simulator.world_description import Box, Cylinder, Face, Tag, WorldFile

ROBOT_RADIUS = 60.0
"""Half of a robot's width in mm, where the robot is not known."""
MOST_CELLS = 500
"""The largest number of cells on a side of the grid."""
SMALLEST_CELL = 5.0
"""The smallest side of a cell in mm."""
LINE_STEP = 20.0
"""The distance in mm between the places of a line that are checked."""
SHIFT = 4
"""The binary digits after the point of the coordinates that OpenCV draws."""

What = Literal["wall", "box", "cylinder", "board", "prop", "border"]
Mask = NDArray[np.bool_]

_BEHIND: MappingProxyType[What, str] = MappingProxyType(
    {
        "wall": "world-goal-behind-wall",
        "box": "world-goal-behind-box",
        "cylinder": "world-goal-behind-cylinder",
        "board": "world-goal-behind-board",
        "prop": "world-goal-behind-prop",
        "border": "world-goal-behind-border",
    }
)


@dataclass(frozen=True, slots=True)
class Unreachable:
    """A goal that no robot can reach.

    Args:
        kind: the kind of goal, as in a world's file.
        index: its place among the goals of this kind.
        reason: the message for the user.
    """

    kind: str
    index: int
    reason: Phrase


def unreachable_goals(world: WorldFile, radius: float = ROBOT_RADIUS) -> tuple[Unreachable, ...]:
    """Find the goals that a robot can't reach from any start.

    Args:
        world: a valid world.
        radius: half of the robot's width in mm.
    """
    floor = _Floor(world, radius)
    return tuple(_blocked_goals(world, floor)) if any(world.goal.all()) else ()


def _blocked_goals(world: WorldFile, floor: "_Floor") -> Iterator[Unreachable]:
    for kind, index, goal in world.goal.all():
        needed = _Needed.of(world, goal)
        if needed is None or needed.within(floor.reached()):
            continue
        reason = Phrase(floor.reason(needed), name=goal.name)
        yield Unreachable(kind, index, reason)


@dataclass(frozen=True, slots=True)
class _Reached:
    """The part of the floor that a robot's middle can reach.

    Args:
        grid: the cells.
        cells: whether each can be reached.
    """

    grid: "_Grid"
    cells: Mask

    def has(self, place: Point, radius: float, front: float | None = None) -> bool:
        """Whether some of a disc, or of its half to a heading, can be reached."""
        x, y = self.grid.x - place[0], self.grid.y - place[1]
        near = np.hypot(x, y) <= radius + self.grid.cell
        if front is not None:
            ahead, north = forward(front)
            near &= ahead * x + north * y > 0
        return bool((near & self.cells).any())

    def share(self, places: NDArray[np.float64], distance: float) -> float:
        """The share of places that have something reachable within a distance."""
        if not self.cells.any():
            return 0.0
        away = cv2.distanceTransform((~self.cells).astype(np.uint8), cv2.DIST_L2, 5)
        rows, columns = self.grid.cells_at(places)
        limit = distance / self.grid.cell + 1
        return float((away[rows, columns] <= limit).mean())


@dataclass(frozen=True, slots=True)
class _Needed:
    """What has to be reached for a goal.

    Args:
        places: the middles of discs, all of which are needed.
        radius: of these discs, mm.
        front: the heading of the half of the disc that is needed; None for all of it.
        share: the share of places of a line that is enough; None if all are needed.
    """

    places: Sequence[Point]
    radius: float
    front: float | None = None
    share: float | None = None

    @classmethod
    def of(cls, world: WorldFile, goal: object) -> "_Needed | None":
        """What a goal needs; None if it can be reached anywhere."""
        match goal:
            case Reach(object=None) | Stop() | Show(radius=float()):
                return cls([(goal.x, goal.y)], goal.radius or 0.0)
            case Tour():
                return cls(goal.points, goal.radius)
            case Visit():
                tag = next(tag for tag in world.tag if tag.id == goal.id)
                return cls([(tag.x, tag.y)], goal.distance, front=tag.heading)
            case Follow():
                line = next(line for line in world.line if line.name == goal.line)
                places = list(_along([*map(_point, line.polyline().points)]))
                return cls(places, goal.distance, share=goal.fraction)
        return None

    def within(self, reached: _Reached) -> bool:
        """Whether it can be reached."""
        if self.share is not None:
            places = np.array(self.places, np.float64)
            # The check of the goal itself forgives gaps.
            return reached.share(places, self.radius) >= self.share - 0.02
        return all(reached.has(place, self.radius, self.front) for place in self.places)


class _Grid:
    """The floor in square cells, from west to east and from north to south.

    Args:
        world: the world with the floor.
    """

    def __init__(self, world: WorldFile) -> None:
        self.size = world.floor.size
        self.cell = max(SMALLEST_CELL, max(self.size) / MOST_CELLS)
        columns, rows = (max(1, math.ceil(side / self.cell)) for side in self.size)
        self.shape = rows, columns

    @cached_property
    def x(self) -> NDArray[np.float64]:
        """The x of each column of cells."""
        return np.asarray(
            (np.arange(self.shape[1]) + 0.5) * self.cell - self.size[0] / 2, np.float64
        )

    @cached_property
    def y(self) -> NDArray[np.float64]:
        """The y of each row of cells, as a column."""
        rows = self.size[1] / 2 - (np.arange(self.shape[0]) + 0.5) * self.cell
        return np.asarray(rows[:, None], np.float64)

    def cells_at(self, places: NDArray[np.float64]) -> tuple[NDArray[np.intp], NDArray[np.intp]]:
        """The rows and columns of the cells nearest to places."""
        columns = (places[:, 0] + self.size[0] / 2) / self.cell
        rows = (self.size[1] / 2 - places[:, 1]) / self.cell
        last_row, last_column = self.shape[0] - 1, self.shape[1] - 1
        return (
            np.clip(rows, 0, last_row).astype(np.intp),
            np.clip(columns, 0, last_column).astype(np.intp),
        )

    def pixels(self, points: Iterable[Point]) -> NDArray[np.int32]:
        """Points as OpenCV draws them, with `SHIFT` digits after the point."""
        east, north = self.size[0] / 2, self.size[1] / 2
        cells = [((x + east) / self.cell - 0.5, (north - y) / self.cell - 0.5) for x, y in points]
        return np.round(np.array(cells) * (1 << SHIFT)).astype(np.int32)


class _Floor:
    """What a robot of some width can reach on a floor with obstacles.

    Args:
        world: the world.
        radius: half of the robot's width in mm.
    """

    def __init__(self, world: WorldFile, radius: float) -> None:
        self._world = world
        self._radius = radius
        self._grid = _Grid(world)

    def reached(self, without: What | None = None) -> _Reached:
        """What can be reached from any start, perhaps without one sort of obstacle."""
        if without is None:
            return self._reached
        return self._reach([mask for what, mask in self._masks.items() if what != without])

    def reason(self, needed: _Needed) -> str:
        """The message that names the obstacle without which something could be reached."""
        if not needed.within(self._reach([])):
            return "world-goal-off-floor"
        for what in self._masks:
            if needed.within(self.reached(what)):
                return _BEHIND[what]
        return "world-goal-behind-things"

    @cached_property
    def _reached(self) -> _Reached:
        return self._reach([*self._masks.values()])

    def _reach(self, masks: Sequence[Mask]) -> _Reached:
        free = np.ones(self._grid.shape, np.bool_)
        for mask in masks:
            free &= ~mask
        if not free.any():
            return _Reached(self._grid, free)
        _, areas = cv2.connectedComponents(free.astype(np.uint8), connectivity=4)
        starts = {areas[cell] for cell in self._starts(free)}
        return _Reached(self._grid, np.isin(areas, list(starts)))

    def _starts(self, free: Mask) -> Iterator[tuple[int, int]]:
        """The free cells nearest to the starts: a robot on a blocked start is put next to it."""
        rows, columns = np.nonzero(free)
        starts = [(start.x, start.y) for start in self._world.start] or [(0.0, 0.0)]
        for row, column in zip(*self._grid.cells_at(np.array(starts)), strict=True):
            nearest = np.argmin((rows - row) ** 2 + (columns - column) ** 2)
            yield int(rows[nearest]), int(columns[nearest])

    @cached_property
    def _masks(self) -> Mapping[What, Mask]:
        """Where each sort of obstacle leaves no room for a robot's middle."""
        drawn = {what: self._widened(shapes) for what, shapes in _obstacles(self._world).items()}
        if self._world.floor.border:
            drawn["border"] = self._near_border()
        return drawn

    def _widened(self, shapes: Sequence["_Shape"]) -> Mask:
        free = np.ones(self._grid.shape, np.uint8)
        for shape in shapes:
            shape.draw(free, self._grid)
        away = cv2.distanceTransform(free, cv2.DIST_L2, 5)
        # A cell less, so that rounding never closes a gap.
        return np.asarray(away * self._grid.cell < self._radius - self._grid.cell)

    def _near_border(self) -> Mask:
        room = self._radius - self._grid.cell
        east, north = self._grid.size[0] / 2 - room, self._grid.size[1] / 2 - room
        return np.asarray((np.abs(self._grid.x) > east) | (np.abs(self._grid.y) > north))


@dataclass(frozen=True, slots=True)
class _Shape:
    """An obstacle seen from above.

    Args:
        points: the corners of a polygon, the ends of a thick line, or the middle of a disc.
        thickness: the thickness of the line or the diameter of the disc in mm.
    """

    points: Sequence[Point]
    thickness: float = 0.0

    def draw(self, free: NDArray[np.uint8], grid: _Grid) -> None:
        """Mark its cells as not free."""
        pixels = grid.pixels(self.points)
        if len(pixels) == 1:
            middle = int(pixels[0][0]), int(pixels[0][1])
            radius = round(self.thickness / 2 / grid.cell * (1 << SHIFT))
            cv2.circle(free, middle, radius, (0,), -1, shift=SHIFT)
        elif len(pixels) == 2:
            width = max(1, round(self.thickness / grid.cell))
            cv2.polylines(free, [pixels], False, (0,), width, shift=SHIFT)  # noqa: FBT003 - OpenCV's signature
        else:
            cv2.fillPoly(free, [pixels], (0,), shift=SHIFT)


def _obstacles(world: WorldFile) -> dict[What, list[_Shape]]:
    """The fixed obstacles of each sort that the world has."""
    boards: list[Tag | Face] = [*world.tag, *world.face]
    obstacles: dict[What, list[_Shape]] = {
        "wall": [
            _Shape(ends, wall.thickness) for wall in world.wall for ends in pairwise(wall.points)
        ],
        "box": [_thing(box) for box in world.box if box.mass is None],
        "cylinder": [_thing(cylinder) for cylinder in world.cylinder if cylinder.mass is None],
        "board": [_board(board) for board in boards],
        "prop": [_thing(body) for body in solid_props(world.prop)],
    }
    return {what: shapes for what, shapes in obstacles.items() if shapes}


def _thing(thing: Box | Cylinder) -> _Shape:
    if isinstance(thing, Cylinder):
        return _Shape([(thing.x, thing.y)], 2 * thing.radius)
    (ahead_x, ahead_y), (side_x, side_y) = forward(thing.heading), forward(thing.heading + 90)
    length, width = thing.length / 2, thing.width / 2
    corners = ((length, width), (length, -width), (-length, -width), (-length, width))
    return _Shape(
        [
            (thing.x + a * ahead_x + b * side_x, thing.y + a * ahead_y + b * side_y)
            for a, b in corners
        ]
    )


def _board(board: Tag | Face) -> _Shape:
    x, y = forward(board.heading + 90)
    half = board.size / 2
    ends = [
        (board.x - half * x, board.y - half * y),
        (board.x + half * x, board.y + half * y),
    ]
    return _Shape(ends, BOARD_THICKNESS)


def _along(points: Sequence[Point]) -> Iterator[Point]:
    """Places along a chain of points."""
    for start, end in pairwise(points):
        count = max(1, math.ceil(math.dist(start, end) / LINE_STEP))
        for i in range(count):
            part = i / count
            yield start[0] + part * (end[0] - start[0]), start[1] + part * (end[1] - start[1])
    yield points[-1]


def _point(place: NDArray[np.float64]) -> Point:
    return float(place[0]), float(place[1])
