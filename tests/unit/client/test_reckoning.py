"""The pose by commands."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from learnblock.client.reckoning import Reckoning
from learnblock.testing import VirtualClock
from learnblock.testing.wheels import Wheels


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
