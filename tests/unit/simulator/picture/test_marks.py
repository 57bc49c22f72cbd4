import numpy as np
import pytest

from learnblock.simulator.picture.labels import LabelSpace, Rectangle
from learnblock.simulator.picture.marks import (
    MOST_LABELS,
    ObjectName,
    PictureEvent,
    events_drawn,
    name_drawn,
)
from learnblock.simulator.picture.palette import GREEN, INK, RED
from learnblock.simulator.picture.svg import Circle, Shape, SvgText


def page() -> LabelSpace:
    return LabelSpace(Rectangle(0, 0, 1200, 1200), np.empty((0, 2)))


def labels(shapes: list[Shape]) -> list[str]:
    return [shape.text for shape in shapes if isinstance(shape, SvgText)]


@pytest.mark.parametrize(
    ("kind", "text", "colour"),
    [
        ("goal", "a lap: reached", GREEN),
        ("goal", "a lap: failed", RED),
        ("end", "completed", INK),
        ("note", "saw a box", INK),
    ],
)
def test_the_kind_of_an_event_chooses_its_colour(kind, text, colour):
    assert colour == PictureEvent(1.0, kind, text, (5, 5)).colour


def test_an_event_of_an_unknown_kind_has_a_label_and_no_icon():
    event = PictureEvent(1.26, "note", "saw a box", (600, 600))
    assert event.icon is None
    assert ["saw a box · 1.3 s"] == labels(list(events_drawn([event], page(), 20)))


def test_every_event_leaves_a_dot_even_without_room_for_a_label():
    room = page()
    room.take(Rectangle(0, 0, 1200, 1200))
    events = [PictureEvent(k, "emotion", "joy", (100 + 9 * k, 300)) for k in range(50)]
    drawn = list(events_drawn(events, room, 20))
    assert [event.place for event in events] == [
        dot.center for dot in drawn if isinstance(dot, Circle)
    ]
    assert [] == labels(drawn)


def test_goals_and_the_end_are_labelled_however_many_emotions_there_are():
    events = [PictureEvent(k, "emotion", "joy", (20 + 11.0 * k, 600)) for k in range(100)]
    events += [
        PictureEvent(100, "goal", "a lap: reached", (600, 300)),
        PictureEvent(101, "end", "completed", (600, 900)),
    ]
    shown = labels(list(events_drawn(events, page(), 20)))
    assert MOST_LABELS == len(shown)
    assert {"a lap: reached · 100.0 s", "completed · 101.0 s"} < set(shown)


def test_a_goals_name_has_a_star_and_other_names_have_none():
    goal = list(name_drawn(ObjectName("a lap", (600, 600), is_goal=True), page()))
    box = list(name_drawn(ObjectName("light box", (600, 600)), page()))
    assert ["a lap"] == labels(goal)
    assert len(goal) > 1
    assert ["light box"] == labels(box)
    assert 1 == len(box)


def test_a_name_without_room_is_left_out():
    room = page()
    room.take(Rectangle(0, 0, 1200, 1200))
    assert [] == list(name_drawn(ObjectName("a lap", (600, 600), is_goal=True), room))
