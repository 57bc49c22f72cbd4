"""A robot in the hand of a person: shaken and tilted."""

import pytest

from learnblock.devices import Accelerometer
from learnblock.errors import UnknownNameError
from learnblock.robots.sim_cozmo import Robot as Cozmo
from learnblock.robots.sim_thymio import Robot as Thymio
from learnblock.testing import FakeRobot

SIDES = ("front", "back", "left", "right")


@pytest.mark.parametrize(
    ("reading", "side"),
    [
        ((0, 0, 9.81), None),
        # The side that is lower is the one from which the support pushes less.
        ((-4.9, 0, 8.5), "front"),
        ((4.9, 0, 8.5), "back"),
        ((0, -4.9, 8.5), "left"),
        ((0, 4.9, 8.5), "right"),
        # It starts to drive, is on a slope of ten degrees, or falls.
        ((0.8, 0, 9.8), None),
        ((1.7, 0, 9.66), None),
        ((3, 0, 0), None),
    ],
)
def test_the_lower_side_is_the_one_to_which_the_robot_is_tilted(robot, reading, side):
    robot.set_reading(Accelerometer, reading)
    assert [one for one in SIDES if robot.is_tilted(one)] == ([side] if side else [])
    assert robot.is_tilted() is (side is not None)


def test_shaking_is_noticed_for_half_a_second(robot):
    robot.set_reading(Accelerometer, (0, 20, 9.81))
    assert robot.is_shaken()
    robot.set_reading(Accelerometer, (0, 0, 9.81))
    robot.sleep(0.4)
    assert robot.is_shaken()
    robot.sleep(0.2)
    assert not robot.is_shaken()


def test_an_unknown_side_is_refused(robot):
    with pytest.raises(UnknownNameError, match="Did you mean 'front'"):
        robot.is_tilted("fron")


def test_a_robot_without_an_accelerometer_feels_nothing():
    with FakeRobot(only=[]) as robot:
        assert not robot.is_shaken()
        assert not robot.is_tilted()


@pytest.mark.parametrize("twin", [Cozmo, Thymio])
def test_a_twin_feels_the_hand_that_tilts_it(twin):
    with twin(world="empty") as robot:
        for side in SIDES:
            robot.simulation.handle("robot", side)
            robot.sleep(0.02)
            assert [one for one in SIDES if robot.is_tilted(one)] == [side]
        robot.simulation.handle("robot", "level")
        robot.sleep(0.02)
        assert not robot.is_tilted()
        assert not robot.is_shaken()


@pytest.mark.parametrize("twin", [Cozmo, Thymio])
def test_a_twin_feels_the_hand_that_shakes_it_but_not_that_it_drives(twin):
    with twin(world="empty") as robot:
        robot.move_straight(100)
        felt = []
        for _ in range(50):
            robot.sleep(0.03)
            felt.append(robot.is_shaken() or robot.is_tilted())
        assert not any(felt)
        robot.simulation.handle("robot", "shake")
        felt = []
        for _ in range(60):
            robot.sleep(0.03)
            felt.append(robot.is_shaken())
        assert all(felt[5:30])
        assert not any(felt[55:])
