"""The drawing of a run: the page from its title to its scale bar, in layers."""

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise
from operator import itemgetter

import numpy as np
from numpy.typing import NDArray

from learnblock.simulator.drawing import PenStroke
from learnblock.simulator.picture import goals, icons, marks, plan, svg, time_bar
from learnblock.simulator.picture.labels import LabelSpace, Rectangle
from learnblock.simulator.picture.palette import INK, NIGHT, PALE, PAPER
from learnblock.simulator.picture.svg import (
    OnPage,
    Paint,
    Point,
    Polygon,
    Polyline,
    Shape,
    SvgText,
    rectangle,
    shortened,
    text_width,
)
from learnblock.simulator.picture.track import Track
from learnblock.simulator.picture.view import (
    BAR_COLUMN,
    FOOTER,
    HEADER,
    MARGIN,
    WIDTH,
    PictureView,
    fitted,
)
from learnblock.simulator.robot_description import Body
from learnblock.simulator.world_description import Box as WorldBox
from learnblock.simulator.world_description import Cylinder, Start, WorldDescription

LONGEST_TITLE = 110
"""The limit of a title in characters."""
TALLEST_BAR = 520.0
"""Pixels."""
SPREAD = 6.0
"""Pixels between the points that labels should not cover."""
THINNEST_STROKE = 3.0
"""The least width of a stroke of a pen in pixels."""
START_SLACK = 30.0
"""The distance in mm from a start within which a path begins there."""


@dataclass(frozen=True, slots=True, kw_only=True)
class DrivenRun:
    """What a robot did in a run.

    Args:
        body: the robot's hull, for its outline and colour.
        path: (time in s, x in mm, y in mm, heading in degrees), in chronological order; may be
            empty.
        marks: (time in s, kind, text, x in mm, y in mm). The kinds "emotion", "goal" (whose text
            ends in "failed" if it was missed) and "end" have their own icons, others a dot.
        strokes: what its pen has drawn on the floor. Its path is thin then, so that the drawing is
            what one sees.
    """

    body: Body
    path: tuple[tuple[float, float, float, float], ...] = ()
    marks: tuple[tuple[float, str, str, float, float], ...] = ()
    strokes: tuple[PenStroke, ...] = ()


@dataclass(frozen=True, slots=True, kw_only=True)
class PictureScene:
    """The contents of a picture of a run.

    Args:
        world: the description; objects that were pushed are at their start.
        drives: what each robot did.
        title: the program and the robot.
    """

    world: WorldDescription
    drives: tuple[DrivenRun, ...] = ()
    title: str = ""

    @property
    def moves(self) -> tuple[DrivenRun, ...]:
        """The drives with a path."""
        return tuple(drive for drive in self.drives if drive.path)

    @property
    def shows_time(self) -> bool:
        """Whether a path is coloured by time."""
        return not all(drive.strokes for drive in self.moves)

    @property
    def times(self) -> tuple[float, float]:
        """When the first path begins and the last one ends, in s."""
        return (
            min(drive.path[0][0] for drive in self.moves),
            max(drive.path[-1][0] for drive in self.moves),
        )


def draw_svg(scene: PictureScene, *, follows_theme: bool = False) -> str:
    """The scene as a self-contained SVG document 1200 pixels wide.

    Args:
        scene: the scene.
        follows_theme: whether the page is dark for readers with a dark theme; the world never is.
    """
    view = _view(scene)
    shapes = _layers(scene, view) if follows_theme else map(svg.in_day, _layers(scene, view))
    style = svg.night_style(NIGHT) if follows_theme else ""
    return svg.document(shapes, WIDTH, view.page_height, scene.title or scene.world.title, style)


def draw_png(scene: PictureScene) -> bytes:
    """The scene as a PNG file 1200 pixels wide."""
    return svg.png(draw_svg(scene))


def _view(scene: PictureScene) -> PictureView:
    places = [(x, y) for drive in scene.drives for _, x, y, _ in drive.path]
    places += [(x, y) for drive in scene.drives for *_, x, y in drive.marks]
    return fitted(scene.world.floor.size, np.array(places).reshape(-1, 2), bar=scene.shows_time)


def _layers(scene: PictureScene, view: PictureView) -> Iterator[Shape]:
    tracks = [Track.of(drive.path, view, scene.times) for drive in scene.moves]
    yield OnPage(Polygon(rectangle(0, 0, WIDTH, view.page_height), Paint(PAPER)))
    yield from map(OnPage, _heading(scene))
    yield from plan.drawn(scene.world, view, _outcomes(scene))
    for start in scene.world.start:
        if _starter(start, scene) is None:
            yield from plan.start(start, view)
    for drive in scene.moves:
        yield from icons.robot(drive.body, view, drive.path[0][1:], faint=True)
    for drive, track in zip(scene.moves, tracks, strict=True):
        yield from track.thinly_drawn() if drive.strokes else track.drawn()
    for drive in scene.drives:
        yield from (_stroke(stroke, view) for stroke in drive.strokes)
    for drive in scene.moves:
        yield from icons.robot(drive.body, view, drive.path[-1][1:])
    if scene.shows_time:
        yield from map(OnPage, _time_bar(scene, view))
    yield from _labels(scene, view, tracks)
    yield from map(OnPage, _footer(scene, view))


def _stroke(stroke: PenStroke, view: PictureView) -> Shape:
    # A dot is a line that ends where it begins: its round ends remain.
    points = stroke.points if len(stroke.points) > 1 else stroke.points * 2
    width = max(stroke.width * view.scale, THINNEST_STROKE)
    return Polyline(view.all(points), stroke.colour, width)


def _heading(scene: PictureScene) -> Iterator[Shape]:
    title = shortened(scene.title or scene.world.title or scene.world.name, LONGEST_TITLE)
    yield SvgText((MARGIN, 60), title, _fitting(title, 30), INK, bold=True)
    facts = shortened(" · ".join(_facts(scene)), LONGEST_TITLE)
    yield SvgText((MARGIN, 93), facts, _fitting(facts, 18), PALE)


def _fitting(text: str, size: float) -> float:
    """The size of the font, smaller if the text would leave the page."""
    return min(size, size * (WIDTH - 2 * MARGIN) / max(text_width(text, size), 1.0))


def _facts(scene: PictureScene) -> Iterator[str]:
    if scene.title and scene.world.title:
        yield scene.world.title
    if scene.moves:
        begin, end = scene.times
        metres = sum(map(_length, scene.moves)) / 1000
        yield f"{metres:.2f} m in {end - begin:.1f} s"


def _length(drive: DrivenRun) -> float:
    """The mm driven."""
    places = np.array(drive.path)[:, 1:3]
    return float(np.hypot(*np.diff(places, axis=0).T).sum())


def _time_bar(scene: PictureScene, view: PictureView) -> Iterator[Shape]:
    corner = (WIDTH - MARGIN - BAR_COLUMN + 34, HEADER + 50)
    height = min(view.plot[1] - 60, TALLEST_BAR)
    yield from time_bar.drawn(*scene.times, corner, height)


def _labels(scene: PictureScene, view: PictureView, tracks: Sequence[Track]) -> Iterator[Shape]:
    room = LabelSpace(_bounds(view), _busy(scene, view, tracks))
    for board in plan.boards(scene.world):
        center, side = plan.board_picture(board, view)
        room.take(Rectangle.around(center, side / 2 + 4))
    for tag in scene.world.tag:
        room.take(plan.tag_number_box(tag, view))
    for drive in scene.moves:
        room.take(Rectangle.around(view.at(*drive.path[-1][1:3]), _reach(drive, view) * 0.8))
    # Labels of events matter more than names of objects, so they are placed first, and on top.
    happened = list(marks.events_drawn(_events(scene, view), room, _widest(scene, view)))
    for name in _names(scene, view):
        yield from marks.name_drawn(name, room)
    yield from happened


def _events(scene: PictureScene, view: PictureView) -> list[marks.PictureEvent]:
    marked = sorted((mark for drive in scene.drives for mark in drive.marks), key=itemgetter(0))
    return [marks.PictureEvent(t, kind, text, view.at(x, y)) for t, kind, text, x, y in marked]


def _outcomes(scene: PictureScene) -> dict[str, str]:
    """What became of the goals, by name."""
    marked = (mark for drive in scene.drives for mark in drive.marks)
    parts = (text.rpartition(": ") for _, kind, text, _, _ in marked if kind == "goal")
    return {name: outcome for name, _, outcome in parts}


def _reach(drive: DrivenRun, view: PictureView) -> float:
    """The radius of a robot in pixels."""
    return drive.body.reach * view.scale


def _widest(scene: PictureScene, view: PictureView) -> float:
    return max((_reach(drive, view) for drive in scene.drives), default=0.0)


def _names(scene: PictureScene, view: PictureView) -> Iterator[marks.ObjectName]:
    """The names of the world's goals, named objects and starts."""
    marked = [mark for drive in scene.drives for mark in drive.marks]
    goals_shown = [text for _, kind, text, _, _ in marked if kind == "goal"]
    for name in goals.names(scene.world, view):
        if not any(text.startswith(f"{name.text}:") for text in goals_shown):
            yield name
    for thing in plan.things(scene.world):
        if thing.name not in ("box", "cylinder"):
            clear = _radius(thing) * view.scale + 4
            yield marks.ObjectName(thing.name, view.at(thing.x, thing.y), clear)
    for start in scene.world.start:
        starter = _starter(start, scene)
        clear = _reach(starter, view) if starter else 18.0
        yield marks.ObjectName(start.name, view.at(start.x, start.y), clear)


def _starter(start: Start, scene: PictureScene) -> DrivenRun | None:
    """The robot whose path begins at a start."""
    place = (start.x, start.y)
    near = (drive for drive in scene.moves if math.dist(place, drive.path[0][1:3]) < START_SLACK)
    return next(near, None)


def _radius(thing: WorldBox | Cylinder) -> float:
    if isinstance(thing, Cylinder):
        return thing.radius
    return math.hypot(thing.length, thing.width) / 2


def _bounds(view: PictureView) -> Rectangle:
    width, height = view.plot
    return Rectangle(MARGIN - 12, HEADER - 6, MARGIN + width - 14, HEADER + height - 10)


def _busy(scene: PictureScene, view: PictureView, tracks: Sequence[Track]) -> NDArray[np.float64]:
    """The shapes that labels should not cover: lines, walls, objects, path and start."""
    parts = [_within(plan.outline(thing, view)) for thing in plan.things(scene.world)]
    lines = [line.polyline().points.tolist() for line in scene.world.line]
    for points in [*lines, *(wall.points for wall in scene.world.wall)]:
        parts += [_between(*ends) for ends in pairwise(view.all(points))]
    parts += [track.spread(SPREAD) for track in tracks]
    for drive in scene.moves:
        parts.append(_within(view.placed(drive.body.outline, *drive.path[0][1:])))
    return np.vstack([np.empty((0, 2)), *parts])


def _between(begin: Point, end: Point) -> NDArray[np.float64]:
    return np.linspace(begin, end, 2 + int(math.dist(begin, end) / SPREAD))


def _within(outline: list[Point]) -> NDArray[np.float64]:
    """Points spread over a convex outline, by repeatedly shrinking it towards its middle."""
    corners = np.array([*outline, outline[0]])
    edge = np.vstack([np.linspace(begin, end, 8) for begin, end in pairwise(corners)])
    middle = edge.mean(axis=0)
    return np.vstack([middle + part * (edge - middle) for part in (0.25, 0.5, 0.75, 1.0)])


def _footer(scene: PictureScene, view: PictureView) -> Iterator[Shape]:
    base = HEADER + view.plot[1] + FOOTER - 30
    step = plan.grid_step(scene.world)
    left, right = MARGIN + 2, MARGIN + 2 + step * view.scale
    bar = [(left, base - 7), (left, base), (right, base), (right, base - 7)]
    yield Polyline(bar, INK, 2.0, cap="butt")
    yield SvgText((right + 12, base + 3), f"{step:g} mm", 16, INK, bold=True)
    yield from icons.compass((WIDTH - MARGIN - 14, base - 8), 14.0)
    yield SvgText((WIDTH - MARGIN - 44, base + 3), "LearnBlock", 15, PALE, anchor="end")
