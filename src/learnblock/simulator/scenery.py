"""The scenery for cameras: everything in a world as flat surfaces with pictures."""

import math
from collections.abc import Iterator, Sequence
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from learnblock.simulator import robot_description, textures
from learnblock.simulator.camera import Surface
from learnblock.simulator.colours import RGB, rgb
from learnblock.simulator.floor import Floor
from learnblock.simulator.geometry import Point, Pose, forward
from learnblock.simulator.physics import things
from learnblock.simulator.world_description import Box, Cylinder, Face, Tag, Wall, WorldDescription

CYLINDER_SIDES = 12
TAG_PIXELS = 160
FACE_PIXELS = 400
BORDER_COLOUR: RGB = (215, 212, 200)
BOARD_BACK: RGB = (170, 150, 120)

Corners = NDArray[np.float64]


class Solid:
    """An upright object that moves: its surfaces at any pose, made from one picture.

    Args:
        outline: its corners (forward, left) in mm, anticlockwise from above; an even number.
        height: its height in mm.
        colour: the colour of all its surfaces.
        name: the name of the surfaces.
    """

    def __init__(
        self, outline: Sequence[Point], height: float, colour: RGB, name: str = ""
    ) -> None:
        self._outline = np.array(outline, np.float64)
        self._height = height
        texture = _plain(colour)
        self._surfaces = [
            Surface(corners, texture, name, two_sided=False)
            for corners in _prism(self._outline, height)
        ]
        self._pose: Pose | None = None

    def at(self, pose: Pose) -> Sequence[Surface]:
        """The surfaces of its sides and its top at `pose`: the same as before until it moves."""
        if pose != self._pose:
            self._surfaces, self._pose = [*self._moved(pose)], pose
        return self._surfaces

    def _moved(self, pose: Pose) -> Iterator[Surface]:
        x, y = forward(pose.heading)
        turn = np.array([(x, y), (-y, x)])
        outline = self._outline @ turn + (pose.x, pose.y)
        quads = _prism(outline, self._height)
        for surface, corners in zip(self._surfaces, quads, strict=True):
            yield surface.moved(corners)


def solid(thing: Box | Cylinder) -> Solid:
    """A box or a cylinder for cameras."""
    if isinstance(thing, Box):
        x, y = thing.length / 2, thing.width / 2
        outline = [(x, -y), (x, y), (-x, y), (-x, -y)]
    else:
        steps = [2 * math.pi * (i + 0.5) / CYLINDER_SIDES for i in range(CYLINDER_SIDES)]
        outline = [(thing.radius * math.cos(a), thing.radius * math.sin(a)) for a in steps]
    return Solid(outline, thing.height, rgb(thing.colour), thing.name)


def hull(body: robot_description.Body, name: str) -> Solid:
    """A robot as seen by the cameras of other robots."""
    return Solid(body.outline, body.height, rgb(body.colour), name)


def scenery(world: WorldDescription, floor: Floor) -> list[Surface]:
    """The surfaces that never move."""
    surfaces = [_floor(floor), *_border(world)]
    for wall in world.wall:
        surfaces += _wall(wall)
    for thing in things(world):
        if thing.mass is None:
            heading = thing.heading if isinstance(thing, Box) else 0.0
            surfaces += solid(thing).at(Pose(thing.x, thing.y, heading))
    for tag in world.tag:
        surfaces += _board(tag, textures.tag(tag.id, TAG_PIXELS), f"tag {tag.id}")
    for face in world.face:
        surfaces += _board(face, textures.face(face.emotion, FACE_PIXELS), f"face {face.emotion}")
    return surfaces


def _floor(floor: Floor) -> Surface:
    x, y = floor.size[0] / 2, floor.size[1] / 2
    corners = np.array([(-x, y, 0), (x, y, 0), (x, -y, 0), (-x, -y, 0)], np.float64)
    return Surface.showing(floor.mips, corners, "floor", two_sided=False)


def _border(world: WorldDescription) -> Iterator[Surface]:
    height, (length, width) = world.floor.border, world.floor.size
    if not height:
        return
    x, y = length / 2, width / 2
    texture = _plain(BORDER_COLOUR)
    corners = [(x, y), (x, -y), (-x, -y), (-x, y)]
    for start, end in zip(corners, [*corners[1:], corners[0]], strict=True):
        yield Surface(_upright(start, end, 0.0, height), texture, "border")


def _wall(wall: Wall) -> Iterator[Surface]:
    half = wall.thickness / 2
    for start, end in pairwise(wall.points):
        length = math.dist(start, end)
        if length == 0:
            continue
        # Longer by half the thickness at both ends, so that corners are closed.
        x, y = length / 2 + half, half
        outline = [(x, -y), (x, y), (-x, y), (-x, -y)]
        heading = -math.degrees(math.atan2(end[1] - start[1], end[0] - start[0]))
        middle = Pose((start[0] + end[0]) / 2, (start[1] + end[1]) / 2, heading)
        yield from Solid(outline, wall.height, rgb(wall.colour), "wall").at(middle)


def _board(board: Tag | Face, picture: textures.Image, name: str) -> Iterator[Surface]:
    # Seen from the front, its right end is to the left of its facing direction.
    x, y = forward(board.heading - 90)
    half = board.size / 2
    left, right = (board.x - half * x, board.y - half * y), (board.x + half * x, board.y + half * y)
    bottom, top = board.z - half, board.z + half
    yield Surface(_upright(left, right, bottom, top), picture, name, two_sided=False)
    back = _upright(right, left, bottom, top)
    yield Surface(back, _plain(BOARD_BACK), f"back of {name}", two_sided=False)


def _upright(left: Point, right: Point, bottom: float, top: float) -> Corners:
    return np.array([(*left, top), (*right, top), (*right, bottom), (*left, bottom)], np.float64)


def _prism(outline: NDArray[np.float64], height: float) -> Iterator[Corners]:
    """The sides, seen from outside, and the top in quads."""
    points = [(float(x), float(y)) for x, y in outline]
    for start, end in zip(points, [*points[1:], points[0]], strict=True):
        yield _upright(start, end, 0.0, height)
    for i in range(1, len(points) - 2, 2):
        quad = (points[i + 2], points[i + 1], points[i], points[0])
        yield np.array([(x, y, height) for x, y in quad], np.float64)


def _plain(colour: RGB) -> textures.Image:
    return np.full((2, 2, 3), colour, np.uint8)
