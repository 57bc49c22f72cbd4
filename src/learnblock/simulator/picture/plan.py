"""The world as seen from above: floor, lines, walls, objects, boards, lamps, starts and goals."""

import math
from collections.abc import Iterable, Iterator
from itertools import pairwise
from types import MappingProxyType

import cv2
import numpy as np
from numpy.typing import NDArray

from learnblock.simulator import textures
from learnblock.simulator.colours import RGB
from learnblock.simulator.floor import Floor
from learnblock.simulator.geometry import forward
from learnblock.simulator.picture import goals, icons
from learnblock.simulator.picture.labels import Rectangle as LabelBox
from learnblock.simulator.picture.palette import BLACK, INK, PALE, WHITE, is_dark
from learnblock.simulator.picture.svg import (
    Circle,
    Paint,
    Point,
    Polygon,
    Polyline,
    Shape,
    SvgImage,
    SvgText,
    rectangle,
)
from learnblock.simulator.picture.themes import look_of, shown
from learnblock.simulator.picture.view import PictureView, round_step
from learnblock.simulator.props import body_of
from learnblock.simulator.world_description import (
    Box,
    Cylinder,
    Face,
    Start,
    Tag,
    Wall,
    WorldDescription,
)

EDGE: RGB = (90, 88, 84)
NONE: goals.Outcomes = MappingProxyType({})
BOARD = (34.0, 84.0)
"""The smallest and largest side of a tag's or a face's picture, pixels."""


def drawn(
    world: WorldDescription, view: PictureView, outcomes: goals.Outcomes = NONE
) -> Iterator[Shape]:
    """Everything in the world except the robots.

    Args:
        world: its description.
        view: where its places are in the picture.
        outcomes: what became of its goals.
    """
    yield from _ground(world, view)
    yield from goals.regions(world, view, outcomes)
    for line in world.line:
        points = _points(line.polyline().points)
        yield Polyline(view.all(points), shown(line.colour), line.width * view.scale)
    yield from goals.outlines(world, view, outcomes)
    yield from _things(world, view)
    for lamp in world.light:
        yield from icons.sun(view.at(lamp.x, lamp.y), 15.0)


def board_picture(board: Tag | Face, view: PictureView) -> tuple[Point, float]:
    """The middle and the side, in pixels, of a board's picture, which is drawn behind the board."""
    side = min(max(board.size * view.scale * 0.8, BOARD[0]), BOARD[1])
    x, y = forward(board.heading)
    # Far enough for the square to clear the board at any angle.
    back = 0.5 * side * (abs(x) + abs(y)) + 7
    board_x, board_y = view.at(board.x, board.y)
    return (board_x - back * x, board_y + back * y), side


def boards(world: WorldDescription) -> tuple[Tag | Face, ...]:
    """Tags and faces."""
    return (*world.tag, *world.face)


def things(world: WorldDescription) -> tuple[Box | Cylinder, ...]:
    """Boxes and cylinders."""
    return (*world.box, *world.cylinder)


def outline(thing: Box | Cylinder, view: PictureView) -> list[Point]:
    """The corners of a box, or of sixteen on a cylinder, in pixels."""
    if isinstance(thing, Cylinder):
        angles = [k * math.pi / 8 for k in range(16)]
        radius = thing.radius
        circle = [(thing.x + radius * math.cos(a), thing.y + radius * math.sin(a)) for a in angles]
        return view.all(circle)
    length, width = thing.length / 2, thing.width / 2
    corners = [(length, -width), (length, width), (-length, width), (-length, -width)]
    return view.placed(corners, thing.x, thing.y, thing.heading)


def tag_number_box(tag: Tag, view: PictureView) -> LabelBox:
    """The position of a tag's number: beyond its picture, away from the board."""
    (x, y), side = board_picture(tag, view)
    away = -1 if forward(tag.heading)[1] < 0 else 1
    middle = y + away * (side / 2 + 13)
    return LabelBox(x - 26, middle - 11, x + 26, middle + 11)


def grid_step(world: WorldDescription) -> float:
    """The distance in mm between grid lines, and the length of the scale bar."""
    return round_step(max(world.floor.size) / 10)


def _ground(world: WorldDescription, view: PictureView) -> Iterator[Shape]:
    east, north = world.floor.size[0] / 2, world.floor.size[1] / 2
    corners = view.all([(-east, -north), (east, -north), (east, north), (-east, north)])
    look = look_of(world.theme)
    even, odd = look.floor(world.floor.colour)
    if world.floor.border:
        yield Polygon(_shadow(corners), Paint(BLACK, BLACK, 12, 0.10))
        yield Polygon(corners, Paint(look.rim, _darker(look.rim), 13))
        yield Polygon(corners, Paint(look.rim, look.rim, 10))
    yield Polygon(corners, Paint(even, _darker(look.rim), 1.2))
    if world.floor.picture:
        yield _floor_picture(world, view)
    else:
        yield from _squares(world, view, odd)
        yield from _grid(world, view)


def _squares(world: WorldDescription, view: PictureView, colour: RGB) -> Iterator[Shape]:
    """Every second square of the floor; each row of them is a dashed line."""
    step = grid_step(world) / 2
    east, north = (size / 2 for size in world.floor.size)
    edges = [-east, *_multiples(step, east), east]
    lengths = [(right - left) * view.scale for left, right in pairwise(edges)]
    # The rows and columns from the middle of the floor, where a line of the grid is.
    first = math.floor(edges[0] / step)
    for south, upper in pairwise([-north, *_multiples(step, north), north]):
        row = math.floor((south + upper) / 2 / step)
        # A dash of no length is not drawn: the row begins with a gap.
        dash = (0.0, *lengths) if (first + row) % 2 else tuple(lengths)
        middle = (south + upper) / 2
        ends = view.all([(-east, middle), (east, middle)])
        yield Polyline(ends, colour, (upper - south) * view.scale, dash=dash, cap="butt")


def _floor_picture(world: WorldDescription, view: PictureView) -> SvgImage:
    pixels = Floor(world).image
    width, height = (side * view.scale for side in world.floor.size)
    x, y = view.at(0, 0)
    return SvgImage((x - width / 2, y - height / 2), (width, height), _at_most(pixels, width))


def _at_most(pixels: textures.Image, width: float) -> textures.Image:
    """The picture at no more than twice the resolution of the page, to keep files small."""
    factor = 2 * width / pixels.shape[1]
    if factor >= 1:
        return pixels
    smaller = cv2.resize(pixels, None, fx=factor, fy=factor, interpolation=cv2.INTER_AREA)
    return np.asarray(smaller, np.uint8)


def _grid(world: WorldDescription, view: PictureView) -> Iterator[Shape]:
    step = grid_step(world)
    east, north = world.floor.size[0] / 2, world.floor.size[1] / 2
    even, _ = look_of(world.theme).floor(world.floor.colour)
    ink = WHITE if is_dark(even) else BLACK
    for x in _multiples(step, east):
        yield Polyline(view.all([(x, -north), (x, north)]), ink, 1.0, 0.07, cap="butt")
    for y in _multiples(step, north):
        yield Polyline(view.all([(-east, y), (east, y)]), ink, 1.0, 0.07, cap="butt")


def _multiples(step: float, limit: float) -> list[float]:
    count = math.ceil(limit / step) - 1
    return [k * step for k in range(-count, count + 1)]


def start(start: Start, view: PictureView) -> Iterator[Shape]:
    """A start that no robot took: a ring with an arrow along the heading."""
    x, y = view.at(start.x, start.y)
    yield Circle((x, y), 13.0, Paint(WHITE, PALE, 1.6, 0.85))
    ahead, left = forward(start.heading), forward(start.heading - 90)
    corners = [(10.0, 0.0), (-6.0, 6.5), (-2.5, 0.0), (-6.0, -6.5)]
    arrow = [(x + f * ahead[0] + s * left[0], y - f * ahead[1] - s * left[1]) for f, s in corners]
    yield Polygon(arrow, Paint(PALE))


def _things(world: WorldDescription, view: PictureView) -> Iterator[Shape]:
    look = look_of(world.theme)
    for index, wall in enumerate(world.wall):
        yield from _wall(wall, look.wall(wall.colour, index), view)
    for box in world.box:
        yield from _box(box, view)
    for cylinder in world.cylinder:
        yield from _cylinder(cylinder, view)
    for prop in world.prop:
        body = body_of(prop)
        yield from _box(body, view) if isinstance(body, Box) else _cylinder(body, view)
    for tag in world.tag:
        yield from _board(tag, view, textures.tag(tag.id, 10 * textures.TAG_CELLS))
        yield from _number(tag, view)
    for face in world.face:
        yield from _board(face, view, textures.face(face.emotion, 160))


def _wall(wall: Wall, colour: RGB, view: PictureView) -> Iterator[Shape]:
    points = view.all(wall.points)
    width = max(wall.thickness * view.scale, 4.0)
    yield Polyline(_shadow(points), BLACK, width, 0.16, cap="square")
    yield Polyline(points, _darker(colour), width + 2.4, cap="square")
    # The edge is a wider stroke below; a square end adds half its width to the length.
    yield Polyline(points, colour, width, cap="square")


def _box(box: Box, view: PictureView) -> Iterator[Shape]:
    corners = outline(box, view)
    yield Polygon(_shadow(corners), Paint(BLACK, opacity=0.16))
    yield Polygon(corners, _sides(box))


def _cylinder(cylinder: Cylinder, view: PictureView) -> Iterator[Shape]:
    center = view.at(cylinder.x, cylinder.y)
    radius = cylinder.radius * view.scale
    yield Circle(_shadow([center])[0], radius, Paint(BLACK, opacity=0.16))
    yield Circle(center, radius, _sides(cylinder))


def _sides(thing: Box | Cylinder) -> Paint:
    """Draw objects that can be pushed with a dashed edge."""
    dash = () if thing.mass is None else (6.0, 4.0)
    colour = shown(thing.colour)
    return Paint(colour, _darker(colour), 2.4, dash=dash)


def _board(board: Tag | Face, view: PictureView, picture: textures.Image) -> Iterator[Shape]:
    (x, y), side = board_picture(board, view)
    corner = (x - side / 2, y - side / 2)
    frame = rectangle(*corner, side, side)
    yield Polygon(_shadow(frame), Paint(BLACK, opacity=0.13))
    yield SvgImage(corner, (side, side), picture)
    yield Polygon(frame, Paint(stroke=EDGE, width=1.4))
    yield from _edge(board, view)


def _edge(board: Tag | Face, view: PictureView) -> Iterator[Shape]:
    """The board itself, a line when seen from above, and the direction that it faces."""
    half = board.size / 2
    ends = view.placed([(0, half), (0, -half)], board.x, board.y, board.heading)
    yield Polyline(ends, INK, 5.0, cap="butt")
    x, y = view.at(board.x, board.y)
    ahead, left = forward(board.heading), forward(board.heading - 90)
    corners = [(12.0, 0.0), (3.0, 6.0), (3.0, -6.0)]
    nose = [(x + f * ahead[0] + s * left[0], y - f * ahead[1] - s * left[1]) for f, s in corners]
    yield Polygon(nose, Paint(INK))


def _number(tag: Tag, view: PictureView) -> Iterator[Shape]:
    box = tag_number_box(tag, view)
    place = ((box.left + box.right) / 2, box.bottom - 6)
    yield SvgText(place, f"tag {tag.id}", 15, INK, bold=True, anchor="middle", halo=WHITE)


def _shadow(points: Iterable[Point]) -> list[Point]:
    return [(x + icons.SHADOW[0], y + icons.SHADOW[1]) for x, y in points]


def _darker(colour: RGB) -> RGB:
    red, green, blue = (round(level * 0.62) for level in colour)
    return red, green, blue


def _points(array: NDArray[np.float64]) -> list[Point]:
    return [(float(x), float(y)) for x, y in array]
