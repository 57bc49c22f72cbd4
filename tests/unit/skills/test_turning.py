import math

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from learnblock.errors import DeviceValueError, StillTurningError
from learnblock.skills.turning import shortest
from learnblock.testing import FakeRobot

angles = st.floats(-400, 400)


@settings(max_examples=40)
@given(heading=angles, speed=st.tuples(st.floats(-100, 100), st.floats(-60, 60)), angle=angles)
def test_from_any_state_a_turn_ends_within_a_degree(heading, speed, angle):
    with FakeRobot(skills=["turn", "set_move"]) as robot:
        robot.wheels.pose = (0, 0, heading)
        robot.set_move(*speed)
        robot.turn(angle)

        assert robot.wheels.pose[2] == pytest.approx(heading + angle, abs=1)


@settings(max_examples=10)
@given(angle=angles.filter(lambda angle: abs(angle) > 1))
def test_a_stuck_robot_gives_up_in_time(angle):
    with FakeRobot(skills=["turn"]) as robot:
        robot.wheels.stuck = True

        with pytest.raises(StillTurningError):
            robot.turn(angle)
        assert robot.clock.time() < 6 + abs(angle) / 10


@settings(max_examples=40)
@given(heading=angles, angle=angles)
def test_any_orientation_is_reached_within_two_degrees_by_at_most_half_a_turn(heading, angle):
    with FakeRobot(skills=["set_orientation"]) as robot:
        robot.wheels.pose = (0, 0, heading)
        robot.set_orientation(angle)

        turned = robot.wheels.pose[2] - heading
        assert abs(turned) <= 181
        assert shortest(robot.wheels.pose[2] - angle) == pytest.approx(0, abs=2)


@given(angles)
def test_the_shortest_way_is_the_same_direction_by_at_most_half_a_turn(angle):
    way = shortest(angle)

    assert -180 < way <= 180
    assert math.isclose(math.remainder(way - angle, 360), 0, abs_tol=1e-9)


def test_half_a_turn_is_to_the_right():
    assert [180, 180, 180] == [shortest(angle) for angle in (180, -180, 540)]


def test_a_robot_that_is_held_halfway_gives_up_three_seconds_later():
    with FakeRobot(skills=["turn"]) as robot:
        sleep = robot.clock.sleep

        def hold(seconds):
            sleep(seconds)
            if not robot.wheels.stuck and robot.wheels.pose[2] > 40:
                robot.wheels.stuck = True
                held.append(robot.clock.time())

        held: list[float] = []
        robot.clock.sleep = hold
        with pytest.raises(StillTurningError, match="turned only 4"):
            robot.turn(90)
        assert 3 <= robot.clock.time() - held[0] < 4


@pytest.mark.parametrize("speed", [5, 20, 90])
def test_a_turn_is_no_faster_than_it_is_told_and_ends_within_a_degree(speed):
    with FakeRobot(skills=["turn"]) as robot:
        robot.turn(-120, speed)

        assert robot.wheels.pose[2] == pytest.approx(-120, abs=1)
        assert max(abs(command[2]) for command in robot.commands) == speed


@pytest.mark.parametrize("speed", [0, -30])
def test_a_turning_speed_that_is_not_positive_is_refused(speed):
    with FakeRobot(skills=["turn"]) as robot, pytest.raises(DeviceValueError, match="more than 0"):
        robot.turn(90, speed)
