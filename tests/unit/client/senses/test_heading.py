"""The heading, by a gyroscope or by the wheels."""

import pytest

from learnblock.devices import Base, Gyroscope
from learnblock.testing import FakeRobot


@pytest.fixture(params=[[Base], [Base, Gyroscope]], ids=["wheels", "gyroscope"])
def robot(request):
    with FakeRobot(only=request.param) as robot:
        yield robot


def turned(robot, degrees):
    robot.set_move(0, degrees)
    robot.sleep(1)
    robot.stop_bot()
    return robot.senses.heading()


def test_it_counts_degrees_to_the_right_since_the_reset(robot):
    turned(robot, 30)
    robot.senses.reset_heading()

    assert turned(robot, 40) == pytest.approx(40)
    assert turned(robot, -60) == pytest.approx(-20)


def test_it_counts_full_turns(robot):
    robot.senses.reset_heading()
    readings = [turned(robot, 100) for _ in range(8)]

    assert readings[-1] == pytest.approx(800)


def test_a_robot_that_cannot_turn_has_none():
    with FakeRobot(only=[]) as robot:
        assert robot.senses.heading() is None
