"""A run as it is drawn: the page from its title to its scale bar, layer on layer."""

import math
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from learnblock.simulator.colours import RGB
from learnblock.simulator.geometry import forward
from learnblock.simulator.picture import icons, marks, plan, svg, track
from learnblock.simulator.picture.labels import Box, Room
from learnblock.simulator.picture.svg import (
    Paint,
    Point,
    Polygon,
    Polyline,
    Shape,
    Text,
    shortened,
)
from learnblock.simulator.picture.track import Track
from learnblock.simulator.picture.view import (
    BAR_COLUMN,
    FOOTER,
    HEADER,
    MARGIN,
    WIDTH,
    View,
    fitted,
)
from learnblock.simulator.robot_description import Body
from learnblock.simulator.world_description import WorldDescription

PAPER: RGB = (253, 252, 249)
WELL: RGB = (241, 240, 236)
LONGEST_TITLE = 68
"""Characters; the subtitle may have half as many again."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Scene:
    """What a picture of a run shows.

    Args:
        world: as described; what was pushed stands where it began.
        body: the robot's hull, for its outline and colour.
        path: (time in s, x in mm, y in mm, heading in degrees), in the order of time; may be
            empty.
        marks: (time in s, kind, text, x in mm, y in mm). The kinds "emotion", "goal" (whose text
            ends in "failed" if it was missed) and "end" have their own icons, others a dot.
        title: which program ran on which robot.
    """

    world: WorldDescription
    body: Body
    path: tuple[tuple[float, float, float, float], ...] = ()
    marks: tuple[tuple[float, str, str, float, float], ...] = ()
    title: str = ""


def draw_svg(scene: Scene) -> str:
    """The scene as an SVG document 1200 pixels wide that needs nothing but itself."""
    view = _view(scene)
    shapes = _layers(scene, view)
    return svg.document(shapes, WIDTH, view.page_height, scene.title or scene.world.title)


def draw_png(scene: Scene) -> bytes:
    """The scene as a PNG file 1200 pixels wide."""
    return svg.png(draw_svg(scene))


def _view(scene: Scene) -> View:
    places = [(x, y) for _, x, y, _ in scene.path] + [(x, y) for *_, x, y in scene.marks]
    return fitted(scene.world.floor.size, np.array(places).reshape(-1, 2), bar=bool(scene.path))


def _layers(scene: Scene, view: View) -> Iterator[Shape]:
    yield from _paper(view)
    yield from _heading(scene)
    yield from plan.drawn(scene.world, view)
    path = np.array(scene.path, np.float64).reshape(-1, 4)
    driven = Track.of(path, view) if len(path) else None
    if driven is not None:
        yield from icons.robot(scene.body, view, scene.path[0][1:], faint=True)
        yield from track.drawn(driven)
        yield from icons.robot(scene.body, view, scene.path[-1][1:])
    yield from _labels(scene, view, driven)
    if driven is not None:
        left = WIDTH - MARGIN - BAR_COLUMN + 34
        height = min(view.plot[1] - 60, 460.0)
        yield from track.bar(driven, left, HEADER + (view.plot[1] - height) / 2 + 10, height)
    yield from _footer(scene, view)


def _paper(view: View) -> Iterator[Shape]:
    yield Polygon(_rectangle(0, 0, WIDTH, view.page_height), Paint(PAPER))


def _heading(scene: Scene) -> Iterator[Shape]:
    title = shortened(scene.title or scene.world.title or scene.world.name, LONGEST_TITLE)
    yield Text((MARGIN, 60), title, 30, icons.INK, bold=True)
    subtitle = shortened(" · ".join(_facts(scene)), LONGEST_TITLE * 3 // 2)
    yield Text((MARGIN, 93), subtitle, 18, icons.PALE)


def _facts(scene: Scene) -> Iterator[str]:
    if scene.title and scene.world.title:
        yield scene.world.title
    if scene.path:
        places = np.array(scene.path)[:, 1:3]
        metres = float(np.hypot(*np.diff(places, axis=0).T).sum()) / 1000
        yield f"{metres:.2f} m in {scene.path[-1][0] - scene.path[0][0]:.1f} s"


def _labels(scene: Scene, view: View, driven: Track | None) -> Iterator[Shape]:
    room = Room(_bounds(view), _busy(scene, view, driven))
    reach = scene.body.reach * view.scale
    for board in (*scene.world.tag, *scene.world.face):
        center, side = plan.board_picture(board, view)
        room.take(Box.around(center, side / 2 + 4))
    for tag in scene.world.tag:
        (x, y), side = plan.board_picture(tag, view)
        room.take(Box(x - 26, y + side / 2, x + 26, y + side / 2 + 24))
    if scene.path:
        room.take(Box.around(view.at(*scene.path[-1][1:3]), reach * 0.8))
    events = [marks.Event(t, kind, text, view.at(x, y)) for t, kind, text, x, y in scene.marks]
    # First what happened, which matters more than what things are called; names go beneath.
    happened = list(marks.events_drawn(events, room, reach))
    yield from _names(scene, view, room)
    yield from happened


def _names(scene: Scene, view: View, room: Room) -> Iterator[Shape]:
    for name, place, clear in _goal_places(scene.world, view):
        yield from marks.name_drawn(name, place, room, clear, icons.flag, icons.GREEN)
    for thing in (*scene.world.box, *scene.world.cylinder):
        if thing.name not in ("box", "cylinder"):
            clear = _radius(thing) * view.scale + 4
            place = view.at(thing.x, thing.y)
            yield from marks.name_drawn(thing.name, place, room, clear, None, icons.PALE)
    for start in scene.world.start:
        place = view.at(start.x, start.y)
        yield from marks.name_drawn(start.name, place, room, 18.0, None, icons.PALE)


def _radius(thing: object) -> float:
    return float(
        getattr(thing, "radius", 0.0)
        or math.hypot(getattr(thing, "length", 0.0), getattr(thing, "width", 0.0)) / 2
    )


def _goal_places(world: WorldDescription, view: View) -> Iterator[tuple[str, Point, float]]:
    for reach in world.goal.reach:
        yield reach.name, view.at(reach.x, reach.y), 0.0
    for follow in world.goal.follow:
        for line in world.line:
            if line.name == follow.line:
                points = line.polyline().points
                x, y = points[len(points) // 2].tolist()
                yield follow.name, view.at(x, y), line.width * view.scale / 2 + 10
    for visit in world.goal.visit:
        for tag in world.tag:
            if tag.id == visit.id:
                x, y = forward(tag.heading)
                ahead = 0.55 * visit.distance
                yield visit.name, view.at(tag.x + ahead * x, tag.y + ahead * y), 0.0


def _bounds(view: View) -> Box:
    width, height = view.plot
    return Box(MARGIN - 30, HEADER - 10, MARGIN + width + 16, HEADER + height + 6)


def _busy(scene: Scene, view: View, driven: Track | None) -> NDArray[np.float64]:
    """What labels should not cover: the path, walls, things."""
    points: list[Point] = []
    for thing in (*scene.world.box, *scene.world.cylinder):
        radius = _radius(thing) * 0.7
        points += view.all(
            (thing.x + radius * x / 2, thing.y + radius * y / 2)
            for x in range(-2, 3)
            for y in range(-2, 3)
        )
    for wall in scene.world.wall:
        for begin, end in zip(wall.points, wall.points[1:], strict=False):
            points += view.all(zip(*(np.linspace(begin, end, 60).T.tolist()), strict=True))
    along = track.spread(driven, 6.0) if driven is not None else np.empty((0, 2))
    return np.vstack([np.array(points).reshape(-1, 2), along])


def _footer(scene: Scene, view: View) -> Iterator[Shape]:
    base = HEADER + view.plot[1] + FOOTER - 38
    step = plan.grid_step(scene.world)
    left, right = MARGIN + 4, MARGIN + 4 + step * view.scale
    bar = [(left, base - 7), (left, base), (right, base), (right, base - 7)]
    yield Polyline(bar, icons.INK, 2.0, cap="butt")
    yield Text((right + 12, base + 3), f"{step:g} mm", 16, icons.INK, bold=True)
    yield from icons.compass((WIDTH - MARGIN - 14, base - 8), 14.0)
    yield Text((WIDTH - MARGIN - 44, base + 3), "LearnBlock", 15, icons.PALE, anchor="end")


def _rectangle(left: float, top: float, right: float, bottom: float) -> list[Point]:
    return [(left, top), (right, top), (right, bottom), (left, bottom)]
