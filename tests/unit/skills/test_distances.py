import pytest

from learnblock.devices import Bumper, DistanceSensors


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
