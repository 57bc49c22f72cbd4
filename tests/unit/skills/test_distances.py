import pytest

from learnblock.devices import Bumper, DistanceSensors
from learnblock.testing import FakeRobot


@pytest.mark.parametrize("side", ["front", "left", "right", "back"])
def test_any_sensor_of_a_side_detects_an_obstacle_within_200_mm(robot, side):
    robot.set_reading(DistanceSensors, {side: [2000, 199]})
    sides = ("front", "left", "right", "back")

    assert [side] == [one for one in sides if getattr(robot, f"is_{one}_obstacle")()]


def test_an_obstacle_must_be_nearer_than_the_threshold(robot):
    robot.set_reading(DistanceSensors, {"front": [100]})

    assert not robot.is_front_obstacle(100)
    assert robot.is_front_obstacle(threshold=100.5)


@pytest.mark.parametrize(
    ("readings", "free"),
    [
        ({"front": [200], "left": [300], "right": [2000]}, True),
        ({"front": [2000], "left": [199], "right": [2000]}, False),
        ({"front": [2000], "back": [10]}, False),
        ({}, False),
    ],
)
def test_the_way_is_free_when_nothing_is_near_ahead_left_or_right(robot, readings, free):
    robot.set_reading(DistanceSensors, readings)

    assert free is robot.is_obstacle_free()


@pytest.mark.parametrize(
    ("sides", "nearest"),
    [
        ({}, 300),
        ({"left": True, "front": False}, 150),
        ({"left": True}, 150),
        ({"left": 0, "front": 0, "right": 1}, 400),
        ({"left": False, "front": False, "right": False}, 150),
    ],
)
def test_the_smallest_distance_is_that_of_the_chosen_sides(robot, sides, nearest):
    robot.set_reading(DistanceSensors, {"left": [150, 900], "front": [300], "right": [400]})

    assert nearest == robot.get_min_distance(**sides)


def test_a_side_without_a_sensor_has_no_distance(robot):
    robot.set_reading(DistanceSensors, {"front": [300]})

    assert robot.get_min_distance(front=False, left=True) is None


def test_a_bumper_that_is_pressed_bumps(robot):
    before = robot.is_bumped()
    robot.set_reading(Bumper, True)

    assert (before, robot.is_bumped()) == (False, True)


@pytest.mark.parametrize(
    ("readings", "direction"),
    [
        ({"front": [300], "left": [200], "right": [400]}, -90),
        ({"front": [2000, 150], "left": [2000], "right": [150]}, 45),
        ({"front": [2000, 150], "left": [150], "right": [2000]}, -45),
        ({"front": [100], "back": [300]}, 0),
        ({"front": [2000], "back": [300]}, 180),
        ({"left": [100], "right": [100], "front": [500]}, 0),
        ({"front": [2000], "left": [2000]}, None),
        ({"front": [0], "left": []}, 0),
        ({}, None),
    ],
)
def test_the_nearest_obstacle_has_a_direction(robot, readings, direction):
    robot.set_reading(DistanceSensors, readings)

    assert robot.get_obstacle_direction() == direction


@pytest.mark.parametrize(("pressed", "direction"), [(True, 0), (False, None)])
def test_a_bumper_tells_that_an_obstacle_is_ahead(pressed, direction):
    with FakeRobot(only=[Bumper]) as robot:
        robot.set_reading(Bumper, pressed)

        assert robot.get_obstacle_direction() == direction
