"""Small drawings: a robot from above, faces, stars, a flag, a sun, a north arrow."""

import math
from collections.abc import Iterator
from dataclasses import dataclass
from types import MappingProxyType

from learnblock.simulator.colours import RGB, rgb
from learnblock.simulator.picture.palette import BLACK, INK, RED, STAR, STAR_EDGE, WHITE, is_dark
from learnblock.simulator.picture.svg import (
    Circle,
    Paint,
    Point,
    Polygon,
    Polyline,
    Shape,
    SvgText,
    rectangle,
)
from learnblock.simulator.picture.view import PictureView
from learnblock.simulator.robot_description import Body

SHADOW = (3.0, 4.0)
"""The offset of shadows to the south-east, in pixels."""


@dataclass(frozen=True, slots=True)
class _Expression:
    """The shape of a small face with an emotion, in fractions of its radius.

    Args:
        colour: the colour of the face.
        smile: how far the mouth's middle is below its corners.
        mouth: half the mouth's width.
        open: radius of a round open mouth; 0 for a line.
        brow: the distance of the brows' inner ends below the outer ones; None for no brows.
    """

    colour: RGB
    smile: float = 0.0
    mouth: float = 0.42
    open: float = 0.0
    brow: float | None = None


_EXPRESSIONS = MappingProxyType(
    {
        "joy": _Expression((255, 205, 60), smile=0.38, mouth=0.5),
        "sadness": _Expression((120, 170, 235), smile=-0.3, brow=-0.16),
        "anger": _Expression((240, 105, 90), smile=-0.22, brow=0.22),
        "surprise": _Expression((255, 170, 90), open=0.26),
        "fear": _Expression((190, 150, 225), smile=-0.1, open=0.17, brow=-0.2),
        "disgust": _Expression((150, 200, 100), smile=-0.24, mouth=0.34, brow=0.1),
        "neutral": _Expression((205, 208, 214), mouth=0.36),
    }
)
_NO_EMOTION = _Expression((235, 236, 240), mouth=0.0)


def emotion_colour(emotion: str) -> RGB:
    """The colour of an emotion's face; pale for an unknown one."""
    return _EXPRESSIONS.get(emotion, _NO_EMOTION).colour


def face(center: Point, radius: float, emotion: str) -> Iterator[Shape]:
    """A small face that shows an emotion."""
    look = _EXPRESSIONS.get(emotion, _NO_EMOTION)
    (x, y), r = center, radius
    yield Circle(center, r, Paint(look.colour, INK, 1.6))
    for side in (-1, 1):
        yield Circle((x + side * 0.34 * r, y - 0.18 * r), 0.115 * r, Paint(INK))
        if look.brow is not None:
            inner = (x + side * 0.16 * r, y + (look.brow / 2 - 0.47) * r)
            outer = (x + side * 0.54 * r, y + (-look.brow / 2 - 0.47) * r)
            yield Polyline([inner, outer], INK, 0.12 * r)
    if look.open:
        yield Circle((x, y + 0.42 * r), look.open * r, Paint(INK))
    elif look.mouth:
        yield Polyline(_mouth(center, r, look), INK, 0.13 * r)


def _mouth(center: Point, radius: float, look: _Expression) -> list[Point]:
    x, y = center
    parts = [k / 6 - 1 for k in range(13)]
    level = 0.38 - look.smile * 0.4
    return [
        (x + part * look.mouth * radius, y + (level + look.smile * (1 - part**2)) * radius)
        for part in parts
    ]


def star(center: Point, radius: float, *, is_won: bool = True) -> Iterator[Shape]:
    """A goal: a golden star once it is reached, an empty one until then."""
    angles = [math.radians(36 * k - 90) for k in range(10)]
    points = [
        (reach * math.cos(angle), reach * math.sin(angle))
        for reach, angle in zip([1.0, 0.48] * 5, angles, strict=True)
    ]
    corners = _scaled(points, center, radius)
    yield Polygon(corners, Paint(WHITE, WHITE, 5.0))
    yield Polygon(corners, Paint(STAR if is_won else WHITE, STAR_EDGE, 1.8))


def cross(center: Point, radius: float) -> Iterator[Shape]:
    """A goal that was missed."""
    yield Circle(center, radius, Paint(RED, WHITE, 1.6))
    for side in (-1, 1):
        marks = [(-0.36 * side, -0.36), (0.36 * side, 0.36)]
        yield Polyline(_scaled(marks, center, radius), WHITE, 0.22 * radius)


def finish(center: Point, radius: float) -> Iterator[Shape]:
    """A chequered flag for the end of a run."""
    yield Circle(center, radius, Paint(WHITE, INK, 1.6))
    yield Polyline(_scaled([(-0.42, -0.6), (-0.42, 0.64)], center, radius), INK, 0.13 * radius)
    for row in range(3):
        for column in range(3):
            if (row + column) % 2 == 0:
                left, top = -0.42 + 0.3 * column, -0.58 + 0.26 * row
                corners = rectangle(left, top, 0.3, 0.26)
                yield Polygon(_scaled(corners, center, radius), Paint(INK))


def dot(center: Point, colour: RGB, radius: float = 5.0) -> Shape:
    """The exact position of an event on a path."""
    return Circle(center, radius, Paint(colour, WHITE, 2.0))


def sun(center: Point, radius: float) -> Iterator[Shape]:
    """A lamp above the floor."""
    for k in range(4):
        yield Circle(center, radius * (2.6 - 0.5 * k), Paint((255, 205, 70), opacity=0.13))
    for k in range(8):
        x, y = math.cos(k * math.pi / 4), math.sin(k * math.pi / 4)
        ray = _scaled([(0.78 * x, 0.78 * y), (1.05 * x, 1.05 * y)], center, radius)
        yield Polyline(ray, (226, 150, 20), 0.16 * radius)
    yield Circle(center, 0.55 * radius, Paint((255, 205, 70), (226, 150, 20), 1.6))


def compass(center: Point, radius: float) -> Iterator[Shape]:
    """A north arrow."""
    left = [(0.0, -1.0), (-0.5, 0.75), (0.0, 0.4)]
    right = [(0.0, -1.0), (0.5, 0.75), (0.0, 0.4)]
    yield Polygon(_scaled(left, center, radius), Paint(INK, INK, 1.2))
    yield Polygon(_scaled(right, center, radius), Paint(WHITE, INK, 1.2))
    yield SvgText((center[0], center[1] - radius - 6), "N", 15, INK, bold=True, anchor="middle")


def robot(
    body: Body, view: PictureView, pose: tuple[float, float, float], *, faint: bool = False
) -> Iterator[Shape]:
    """A robot from above at a pose (x, y, heading), with an arrow pointing ahead."""
    opacity = 0.38 if faint else 0.92
    if not faint:
        yield _hull(body, view, pose, Paint(BLACK, opacity=0.16), SHADOW)
    dash = (5.0, 4.0) if faint else ()
    yield _hull(body, view, pose, Paint(rgb(body.colour), INK, 2.2, opacity, dash))
    front = max(forward for forward, _ in body.outline)
    reach = min(front, max(left for _, left in body.outline)) * 0.55
    middle = body.offset if body.shape == "box" else 0.0
    arrow = [(reach, 0.0), (-reach * 0.6, reach * 0.75), (-reach * 0.25, 0.0)]
    arrow.append((-reach * 0.6, -reach * 0.75))
    ahead = view.placed([(middle + f, left) for f, left in arrow], *pose)
    yield Polygon(ahead, Paint(WHITE if is_dark(rgb(body.colour)) else INK, opacity=opacity))


def _hull(
    body: Body,
    view: PictureView,
    pose: tuple[float, float, float],
    paint: Paint,
    moved: Point = (0, 0),
) -> Shape:
    if body.radius is not None and body.shape == "disc":
        x, y = view.at(*pose[:2])
        return Circle((x + moved[0], y + moved[1]), body.radius * view.scale, paint)
    outline = view.placed(body.outline, *pose)
    return Polygon([(x + moved[0], y + moved[1]) for x, y in outline], paint)


def _scaled(points: list[Point], center: Point, radius: float) -> list[Point]:
    return [(center[0] + radius * x, center[1] + radius * y) for x, y in points]
