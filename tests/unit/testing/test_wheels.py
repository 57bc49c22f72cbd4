import pytest
from hypothesis import given
from hypothesis import strategies as st

from learnblock.testing import VirtualClock, Wheels


def test_wheels_do_not_move_at_first():
    clock = VirtualClock()
    wheels = Wheels(clock)
    clock.sleep(10)

    assert (0, 0, 0) == wheels.pose


def test_a_quarter_of_a_circle_to_the_right_ends_beside_its_centre():
    clock = VirtualClock()
    wheels = Wheels(clock)
    # A radius of 100 mm: a quarter is 157 mm long.
    wheels.move(100 * 3.14159265 / 2, 90)
    clock.sleep(1)

    assert (100, -100, 90) == pytest.approx(wheels.pose, abs=1e-5)


@given(
    adv=st.floats(-500, 500),
    rot=st.floats(-180, 180),
    parts=st.lists(st.floats(0.01, 1), min_size=1, max_size=5),
)
def test_reading_the_pose_does_not_change_the_path(adv, rot, parts):
    poses = []
    for waits in (parts, [sum(parts)]):
        clock = VirtualClock()
        wheels = Wheels(clock)
        wheels.move(adv, rot)
        for seconds in waits:
            clock.sleep(seconds)
            last = wheels.pose
        poses.append(last)

    assert poses[0] == pytest.approx(poses[1], abs=1e-6)


def test_stuck_wheels_do_not_catch_up_once_they_are_free():
    clock = VirtualClock()
    wheels = Wheels(clock)
    wheels.stuck = True
    wheels.move(100, 0)
    clock.sleep(1)
    assert (0, 0, 0) == wheels.pose

    wheels.stuck = False
    clock.sleep(1)
    assert (100, 0, 0) == wheels.pose
