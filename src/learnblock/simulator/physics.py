"""Bodies, contacts and rays in the plane: the solid objects of a world.

Lengths are mm, masses kg and times s, so forces are kg mm/s². In pymunk angles are radians and grow
anticlockwise; headings are degrees and grow clockwise.
"""

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise

import pymunk

from learnblock.simulator.chipmunk import free_part
from learnblock.simulator.geometry import Point, Pose, forward
from learnblock.simulator.props import solid_props
from learnblock.simulator.world_description import (
    Box,
    Cylinder,
    Face,
    Tag,
    WorldDescription,
    thing_name,
)

DT = 0.01
"""Seconds per step."""
GRAVITY = 9810.0
"""mm/s²."""
FLOOR_FRICTION = 0.4
"""The friction of a pushed box on the floor, as of wood on linoleum."""
CONTACT_FRICTION = 0.3
BOARD_THICKNESS = 4.0
"""The thickness in mm of the boards that tags and faces are on."""
BORDER_THICKNESS = 40.0
"""The thickness in mm of the walls outside the floor."""
ROBOT = 1
"""pymunk's collision type of robots; all other objects have 0."""


@dataclass(frozen=True, slots=True)
class Pushed:
    """A box or a cylinder that can be pushed."""

    body: pymunk.Body
    thing: Box | Cylinder

    @property
    def pose(self) -> Pose:
        """Its current pose."""
        x, y = self.body.position
        return Pose(x, y, -math.degrees(self.body.angle))


class Physics:
    """The plane with all solid objects.

    Args:
        world: the description of the objects.
    """

    def __init__(self, world: WorldDescription) -> None:
        self.space = pymunk.Space()
        self.pushed: list[Pushed] = []
        self.names: dict[pymunk.Shape, str] = {}
        self._add_border(world)
        self._add_walls(world)
        self._add_boards(world)
        for thing in things(world):
            self._add_thing(thing)

    def ray(self, start: Point, end: Point, looker: pymunk.ShapeFilter) -> float | None:
        """The fraction of the way from `start` to `end`, 0 to 1, that is free.

        Args:
            start: the start point in mm.
            end: the end point in mm.
            looker: the group of the measuring robot, which the ray passes through.
        """
        return free_part(self.space, start, end, looker)

    def seen(
        self, start: Point, end: Point, looker: pymunk.ShapeFilter
    ) -> tuple[float, str] | None:
        """The fraction of the way that is free, and the name of what is there; None for nothing."""
        seen = self.space.segment_query_first(start, end, 0.0, looker)
        if seen is None or seen.shape is None:
            return None
        return seen.alpha, self.names.get(seen.shape, "")

    def touches(self, place: Point, radius: float, ignored_group: int) -> bool:
        """Whether any object outside `ignored_group` is within `radius` mm of `place`."""
        ignored = pymunk.ShapeFilter(group=ignored_group)
        return self.space.point_query_nearest(place, radius, ignored) is not None

    def is_free(self, x: float, y: float, radius: float) -> bool:
        """Whether there is room for a disc at (x, y)."""
        return not self.touches((x, y), radius, ignored_group=0)

    def add(self, shape: pymunk.Shape, name: str) -> None:
        """Report collisions with `shape` under `name`."""
        shape.friction = CONTACT_FRICTION
        self.names[shape] = name
        self.space.add(shape)

    def brake(self, body: pymunk.Body, control: pymunk.Body, force: float, torque: float) -> None:
        """Pull `body` to the velocity of `control` with at most this force and torque.

        This is how a tyre or a sliding foot grips a floor seen from above: a joint without
        position correction, limited in force (the "tank" among Chipmunk's demonstrations).
        """
        grip = pymunk.PivotJoint(control, body, (0, 0), (0, 0))
        grip.max_bias, grip.max_force = 0.0, force
        twist = pymunk.GearJoint(control, body, 0.0, 1.0)
        twist.max_bias, twist.max_force = 0.0, torque
        self.space.add(grip, twist)

    def _add_border(self, world: WorldDescription) -> None:
        if not world.floor.border:
            return
        half = BORDER_THICKNESS / 2
        east, north = world.floor.size[0] / 2 + half, world.floor.size[1] / 2 + half
        corners = [(east, north), (-east, north), (-east, -north), (east, -north)]
        self._add_segments([*corners, corners[0]], BORDER_THICKNESS, "border")

    def _add_walls(self, world: WorldDescription) -> None:
        for wall in world.wall:
            self._add_segments(wall.points, wall.thickness, "wall")

    def _add_boards(self, world: WorldDescription) -> None:
        for name, board in _boards(world):
            self._add_segments(_ends(board), BOARD_THICKNESS, name)

    def _add_segments(self, points: Sequence[Point], thickness: float, name: str) -> None:
        for start, end in pairwise(points):
            self.add(pymunk.Segment(self.space.static_body, start, end, thickness / 2), name)

    def _add_thing(self, thing: Box | Cylinder) -> None:
        if thing.mass is None:
            body = pymunk.Body(body_type=pymunk.Body.STATIC)
        else:
            body = pymunk.Body(thing.mass, _moment(thing, thing.mass))
            self.pushed.append(Pushed(body, thing))
        _place(body, thing)
        self.space.add(body)
        self.add(_shape(body, thing), thing.name)
        if thing.mass is not None:
            force = FLOOR_FRICTION * thing.mass * GRAVITY
            # 2/3 of the radius is the lever arm of the friction under an evenly loaded disc.
            self.brake(body, self.space.static_body, force, force * _mean_radius(thing) * 2 / 3)


def motion(body: pymunk.Body) -> tuple[object, ...]:
    """Where a body is, and how fast it moves."""
    return tuple(body.position), body.angle, tuple(body.velocity), body.angular_velocity


def things(world: WorldDescription) -> Iterator[Box | Cylinder]:
    """The boxes, the cylinders and the bodies of solid props, in order."""
    yield from world.box
    yield from world.cylinder
    yield from solid_props(world.prop)


def footprint(thing: Box | Cylinder | Tag | Face) -> pymunk.Shape:
    """The shape of an object on the floor, which is in no space yet."""
    body = pymunk.Body(body_type=pymunk.Body.STATIC)
    if isinstance(thing, Tag | Face):
        start, end = _ends(thing)
        return pymunk.Segment(body, start, end, BOARD_THICKNESS / 2)
    _place(body, thing)
    return _shape(body, thing)


def _place(body: pymunk.Body, thing: Box | Cylinder) -> None:
    body.position = (thing.x, thing.y)
    body.angle = -math.radians(thing.heading) if isinstance(thing, Box) else 0.0


def _ends(board: Tag | Face) -> tuple[Point, Point]:
    """The ends of a board, seen from above."""
    x, y = forward(board.heading + 90)
    half = board.size / 2
    return (board.x - half * x, board.y - half * y), (board.x + half * x, board.y + half * y)


def _boards(world: WorldDescription) -> Iterator[tuple[str, Tag | Face]]:
    boards: tuple[Tag | Face, ...] = (*world.tag, *world.face)
    for board in boards:
        yield thing_name(board), board


def _moment(thing: Box | Cylinder, mass: float) -> float:
    if isinstance(thing, Box):
        return pymunk.moment_for_box(mass, (thing.length, thing.width))
    return pymunk.moment_for_circle(mass, 0, thing.radius)


def _shape(body: pymunk.Body, thing: Box | Cylinder) -> pymunk.Shape:
    if isinstance(thing, Box):
        return pymunk.Poly.create_box(body, (thing.length, thing.width))
    return pymunk.Circle(body, thing.radius)


def _mean_radius(thing: Box | Cylinder) -> float:
    return (thing.length + thing.width) / 4 if isinstance(thing, Box) else thing.radius
