"""The pose by commands."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from learnblock.client.reckoning import Reckoning
from learnblock.testing import VirtualClock
from learnblock.testing.wheels import Wheels
from learnblock.wheels import Drivetrain


def test_a_robot_is_where_its_commands_have_driven_it():
    clock, done = VirtualClock(), []
    reckoning = Reckoning(lambda adv, rot: done.append((adv, rot)), clock)
    reckoning.move(100, 0)
    clock.sleep(3)
    reckoning.move(0, 0)
    clock.sleep(5)

    assert done == [(100, 0), (0, 0)]
    assert reckoning.pose() == pytest.approx((300, 0, 0))


@given(st.lists(st.tuples(st.floats(-200, 200), st.floats(-90, 90), st.floats(0, 3)), max_size=6))
def test_it_agrees_with_wheels_that_do_what_they_are_told(commands):
    clock = VirtualClock()
    wheels = Wheels(clock)
    reckoning = Reckoning(wheels.move, clock)
    for adv, rot, seconds in commands:
        reckoning.move(adv, rot)
        clock.sleep(seconds)

    x, y, heading = reckoning.pose()
    assert (x, y) == pytest.approx(wheels.pose[:2], abs=1e-6)
    assert (heading - wheels.pose[2] + 180) % 360 - 180 == pytest.approx(0, abs=1e-6)


def test_how_often_it_is_read_does_not_matter():
    clock = VirtualClock()
    reckoning = Reckoning(lambda adv, rot: None, clock)
    reckoning.move(100, 45)
    for _ in range(40):
        clock.sleep(0.1)
        reckoning.pose()

    assert reckoning.pose()[2] == pytest.approx(-180, abs=1e-6)


def reckoning_of(clock):
    wheels = Drivetrain(track=100, maximum_speed=200, acceleration=500)
    return Reckoning(lambda adv, rot: None, clock, wheels)


def test_a_speed_that_the_wheels_cannot_reach_is_reckoned_with_their_own():
    clock = VirtualClock()
    reckoning = reckoning_of(clock)
    reckoning.move(1000, 0)
    clock.sleep(2)
    x, *_ = reckoning.pose()

    # It needs 0.4 s to reach 200 mm/s, and drives 40 mm less meanwhile.
    assert x == pytest.approx(360, abs=1.5)


def test_a_robot_that_stops_still_rolls():
    clock = VirtualClock()
    reckoning = reckoning_of(clock)
    reckoning.move(200, 0)
    clock.sleep(2)
    reckoning.move(0, 0)
    stopped, *_ = reckoning.pose()
    clock.sleep(1)
    x, *_ = reckoning.pose()

    assert x - stopped == pytest.approx(40, abs=1.5)


def test_a_curve_that_is_too_fast_stays_the_same_curve():
    clock = VirtualClock()
    reckoning = reckoning_of(clock)
    reckoning.move(500, 500 / 300 * 57.29577951)
    clock.sleep(3)
    x, y, _ = reckoning.pose()

    # A circle of 300 mm to the right of where it began.
    assert (x**2 + (y + 300) ** 2) ** 0.5 == pytest.approx(300, abs=0.1)
