import math

import numpy as np

from learnblock.simulator.picture.labels import LabelSpace, Rectangle

PAGE = Rectangle(0, 0, 600, 400)
NOTHING = np.empty((0, 2))


def test_labels_of_one_point_do_not_cover_each_other():
    room = LabelSpace(PAGE, NOTHING)
    spots = [room.place((300, 200), 14, 100, 12) for _ in range(8)]
    boxes = [spot.box for spot in spots if spot]
    assert len(boxes) == 8
    assert not any(a.overlaps(b) for a in boxes for b in boxes if a is not b)


def test_a_label_stays_on_the_page():
    room = LabelSpace(PAGE, NOTHING)
    spot = room.place((598, 2), 14, 100, 12)
    assert spot
    assert PAGE.holds(spot.box)
    assert spot.side == -1


def test_a_label_does_not_cover_its_object():
    spot = LabelSpace(PAGE, NOTHING).place((300, 200), 14, 100, 50)
    assert spot
    assert math.dist((300, 200), spot.head) >= 64


def test_a_label_avoids_the_path():
    path = np.column_stack([np.linspace(0, 600, 100), np.full(100, 200.0)])
    spot = LabelSpace(PAGE, path).place((300, 200), 14, 100, 12)
    assert spot
    assert not spot.box.top < 200 < spot.box.bottom


def test_without_room_there_is_no_label():
    room = LabelSpace(PAGE, NOTHING)
    room.take(PAGE)
    assert room.place((300, 200), 14, 100, 12) is None


def test_a_label_avoids_crossing_another_with_its_leader():
    room = LabelSpace(PAGE, NOTHING)
    room.take(Rectangle(320, 100, 600, 300))
    spot = room.place((300, 200), 14, 60, 12)
    assert spot
    assert spot.head[0] < 320
