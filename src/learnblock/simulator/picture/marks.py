"""Events along the path, and the names of objects, as icons and labels that do not overlap."""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import partial
from typing import Literal

from learnblock.simulator.colours import RGB
from learnblock.simulator.picture import icons
from learnblock.simulator.picture.labels import LabelSpace, Spot
from learnblock.simulator.picture.palette import GREEN, INK, PALE, RED, STAR_EDGE, WHITE
from learnblock.simulator.picture.svg import (
    Circle,
    Paint,
    Point,
    Polyline,
    Shape,
    SvgText,
    shortened,
    text_width,
)

SIZE = 16.0
"""The size of a label's text in pixels."""
ICON = 14.0
"""The radius of an icon in pixels."""
STAR = 12.0
"""The radius of an open goal's star in pixels."""
LONGEST_LABEL = 44
"""The limit of a label in characters."""
MOST_LABELS = 18
"""Marks that get a label; for the others, only dots are drawn on the path."""
_RANK = {"end": 0, "goal": 1}

Icon = Callable[[Point, float], Iterator[Shape]]


@dataclass(frozen=True, slots=True)
class PictureEvent:
    """An event at a position.

    Args:
        time: the time in s.
        kind: "emotion", "goal", "end" or any other.
        text: the emotion's name, the goal's name and state, how the run ended.
        place: the position in pixels.
    """

    time: float
    kind: str
    text: str
    place: Point

    @property
    def label(self) -> str:
        return f"{shortened(self.text, LONGEST_LABEL)} · {self.time:.1f} s"

    @property
    def failed(self) -> bool:
        return self.kind == "goal" and self.text.endswith("failed")

    @property
    def colour(self) -> RGB:
        if self.kind == "emotion":
            return icons.emotion_colour(self.text)
        if self.kind == "goal":
            return RED if self.failed else GREEN
        return INK

    @property
    def icon(self) -> Icon | None:
        if self.kind == "emotion":
            return partial(icons.face, emotion=self.text)
        if self.kind == "goal":
            return icons.cross if self.failed else icons.star
        return icons.finish if self.kind == "end" else None


def events_drawn(events: Sequence[PictureEvent], room: LabelSpace, clear: float) -> Iterator[Shape]:
    """The dots of all events, and labels for those with enough room.

    Args:
        events: the events in chronological order.
        room: where labels may go; those placed are taken from it.
        clear: how far the last label must stay from its point, where the robot is.
    """
    for event in events:
        yield icons.dot(event.place, event.colour)
    labelled = []
    for event in _chosen(events):
        icon = ICON if event.icon else 0.0
        away = clear if event.kind == "end" else 12.0
        spot = room.place(event.place, icon, _width(event.label), away)
        if spot is not None:
            labelled.append((event, spot))
    for event, spot in labelled:
        yield from _leader(event.place, spot, event.colour)
    for event, spot in labelled:
        yield from _labelled(spot, event)


@dataclass(frozen=True, slots=True)
class ObjectName:
    """The name of an object of the world.

    Args:
        text: the name as in the world's file.
        place: the position in pixels.
        clear: how far the label must stay from the position, in pixels.
        is_goal: whether it is a goal, which has a star.
    """

    text: str
    place: Point
    clear: float = 0.0
    is_goal: bool = False


def name_drawn(name: ObjectName, room: LabelSpace) -> Iterator[Shape]:
    """The name next to its object, if there is room."""
    label = shortened(name.text, LONGEST_LABEL)
    radius = STAR if name.is_goal else 0.0
    spot = room.place(name.place, radius, _width(label), name.clear, leader=False)
    if spot is not None and name.is_goal:
        yield from icons.star(spot.head, STAR, is_won=False)
        yield _caption(spot, STAR, label, STAR_EDGE)
    elif spot is not None:
        yield _caption(spot, 0.0, label, PALE)


def _chosen(events: Sequence[PictureEvent]) -> list[PictureEvent]:
    """The events to label, the most important first, spread evenly over time if there are many."""
    ranked = sorted(events, key=lambda event: _RANK.get(event.kind, 2))
    first = [event for event in ranked if event.kind in _RANK][:MOST_LABELS]
    others = [event for event in ranked if event.kind not in _RANK]
    left = MOST_LABELS - len(first)
    if len(others) > left:
        others = [others[k * len(others) // left] for k in range(left)]
    return first + others


def _leader(place: Point, spot: Spot, colour: RGB) -> Iterator[Shape]:
    yield Polyline([place, spot.head], WHITE, 4.5, 0.85)
    yield Polyline([place, spot.head], INK, 1.6)
    yield icons.dot(place, colour)


def _labelled(spot: Spot, event: PictureEvent) -> Iterator[Shape]:
    if event.icon is None:
        yield _caption(spot, 0.0, event.label, INK)
        return
    yield Circle(spot.head, ICON + 2, Paint(WHITE, opacity=0.85))
    yield from event.icon(spot.head, ICON)
    yield _caption(spot, ICON, event.label, INK)


def _caption(spot: Spot, icon: float, text: str, colour: RGB) -> SvgText:
    x, y = spot.head
    place = (x + spot.side * (icon + 6), y + SIZE * 0.36)
    anchor: Literal["start", "end"] = "start" if spot.side > 0 else "end"
    return SvgText(place, text, SIZE, colour, bold=True, anchor=anchor, halo=WHITE)


def _width(text: str) -> float:
    return text_width(text, SIZE) + 10
