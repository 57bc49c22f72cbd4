"""How things of games move."""

import math
from itertools import pairwise

import pytest

from learnblock.simulator.game.description import Moving
from learnblock.simulator.game.movement import Movement

PATH = Moving(x=0.0, y=0.0, path=((100.0, 0.0), (100.0, 100.0)), speed=100.0)


def places(moving, *times, key="0"):
    movement = Movement(moving, key)
    return [movement.at(time) for time in times]


def test_a_thing_goes_along_its_path_and_back():
    ways = places(PATH, 0.0, 0.5, 1.5, 2.5, 3.5, 4.0, 4.5)

    assert ways == [(0, 0), (50, 0), (100, 50), (100, 50), (50, 0), (0, 0), (50, 0)]


def test_a_closed_path_goes_straight_back_to_its_place():
    closed = Moving(x=0.0, y=0.0, path=((100.0, 0.0), (100.0, 100.0)), closed=True, speed=100.0)
    back = math.sqrt(2)
    x, y = places(closed, 2 + back / 2)[0]

    assert (x, y) == pytest.approx((50, 50))


def test_a_thing_without_a_path_stays():
    assert places(Moving(x=5.0, y=6.0), 0.0, 100.0) == [(5, 6), (5, 6)]


def test_a_path_to_its_own_place_ends_nowhere():
    still = Moving(x=5.0, y=6.0, path=((5.0, 6.0),))

    assert places(still, 0.0, 3.0) == [(5, 6), (5, 6)]


def test_a_wandering_thing_stays_near_its_place_and_goes_where_its_key_says():
    wandering = Moving(x=100.0, y=0.0, wander=50.0, speed=200.0)
    times = [tick / 20 for tick in range(2000)]
    ways = places(wandering, *times, key="1")

    assert ways == places(wandering, *times, key="1")
    assert ways != places(wandering, *times, key="2")
    assert all(50 <= x <= 150 and -50 <= y <= 50 for x, y in ways)
    # In all four quarters of its field.
    assert {(x > 100, y > 0) for x, y in ways} == {
        (a, b) for a in (True, False) for b in (True, False)
    }


def test_a_wandering_thing_goes_no_faster_than_its_speed():
    wandering = Moving(x=0.0, y=0.0, wander=300.0, speed=100.0)
    ways = places(wandering, *(tick / 20 for tick in range(1000)))

    assert max(math.dist(here, there) for here, there in pairwise(ways)) <= 5.001
