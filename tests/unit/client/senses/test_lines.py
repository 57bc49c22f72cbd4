"""Dark lines, by whatever looks at the floor."""

from itertools import product

import pytest

from learnblock.client.senses.lines import DARK
from learnblock.devices import Base, Camera, GroundSensors, JointMotor
from learnblock.perception import Lines, LineView
from learnblock.testing import FakeRobot

NOTHING = LineView("", 0, 0, 0)


@pytest.fixture
def robot():
    with FakeRobot(only=[Base, GroundSensors]) as robot:
        yield robot


def sees(robot, **readings):
    robot.set_reading(GroundSensors, {"left": None, "central": None, "right": None, **readings})


def side(line):
    sides = [name for name in ("left", "center", "right") if getattr(line, f"is_{name}")]
    return sides if line.is_there else None


@pytest.mark.parametrize(
    ("left", "right", "found"),
    [(90, 90, None), (10, 90, ["left"]), (10, 10, ["center"]), (90, 10, ["right"])],
)
def test_two_sensors_see_a_black_line_where_it_is(robot, left, right, found):
    sees(robot, left=left, right=right)

    assert side(robot.senses.line("black")) == found
    assert side(robot.senses.ground_line()) == found


def test_a_single_sensor_knows_no_line_before_it_has_seen_one(robot):
    sees(robot, central=90)

    assert side(robot.senses.line("black")) is None
    assert side(robot.senses.ground_line()) is None


def test_a_single_sensor_follows_the_right_edge_of_a_black_line(robot):
    found = []
    for brightness in (5, 50, 95):
        sees(robot, central=brightness)
        found.append(side(robot.senses.line("black")))

    assert found == [["right"], ["center"], ["left"]]


def test_a_line_is_lost_when_the_robot_has_gone_too_far_from_it(robot):
    sees(robot, central=50)
    robot.senses.line("black")
    sees(robot, central=95)
    robot.wheels.pose = (90, 0, 0)
    near = side(robot.senses.line("black"))
    robot.wheels.pose = (110, 0, 0)

    assert near == ["left"]
    assert side(robot.senses.line("black")) is None


def turn_to(robot, heading):
    robot.wheels.pose = (0, 0, heading)
    return side(robot.senses.ground_line())


def test_a_single_sensor_looks_for_a_ground_line_on_both_sides(robot):
    sees(robot, central=5)
    assert turn_to(robot, 0) == ["center"]
    sees(robot, central=95)

    assert turn_to(robot, 0) == ["left"]
    assert turn_to(robot, -44) == ["left"]
    assert turn_to(robot, -46) == ["right"]
    assert turn_to(robot, 60) == ["right"]
    assert turn_to(robot, 71) is None


def test_it_looks_first_where_it_found_the_line_last(robot):
    sees(robot, central=5)
    turn_to(robot, 0)
    sees(robot, central=95)
    turn_to(robot, 0)
    turn_to(robot, -50)
    sees(robot, central=5)
    turn_to(robot, 20)
    sees(robot, central=95)

    assert turn_to(robot, 20) == ["right"]


def with_black(robot, left=0, center=500, right=0):
    black = LineView("black", left, center, right)
    robot.set_detections("lines", Lines(black, NOTHING, NOTHING))


def test_a_camera_sees_black_lines_before_ground_sensors_do():
    with FakeRobot(only=[Base, GroundSensors, Camera]) as robot:
        sees(robot, left=10, right=90)
        with_black(robot)

        assert side(robot.senses.line("black")) == ["center"]


def test_a_camera_looks_at_the_floor_for_a_ground_line():
    with FakeRobot(only=[Base, Camera, JointMotor]) as robot:
        with_black(robot)

        assert side(robot.senses.ground_line()) == ["center"]
        assert robot.commands == [("JointMotor:CAMERA.move", -30)]
        robot.senses.ground_line()
        assert len(robot.commands) == 1


@pytest.mark.parametrize(
    ("pixels", "found"),
    [
        ((500, 0, 0), ["left"]),
        # From the bottom left to the top right of the picture, or the reverse.
        ((520, 300, 500), ["center"]),
        ((500, 300, 520), ["center"]),
        ((0, 100, 500), ["right"]),
    ],
)
def test_a_ground_line_in_the_picture_is_on_a_side_or_in_the_centre_by_its_position(pixels, found):
    with FakeRobot(only=[Base, Camera, JointMotor]) as robot:
        with_black(robot, *pixels)

        assert side(robot.senses.ground_line()) == found


@pytest.mark.parametrize(
    ("skill", "commands"),
    [
        ("is_center_black_line", [("JointMotor:CAMERA.move", -30)]),
        ("get_line_position", [("JointMotor:CAMERA.move", -30)]),
        # Only a camera sees it, so the program decides where that looks.
        ("is_center_red_line", []),
    ],
)
def test_a_camera_looks_at_the_floor_for_what_ground_sensors_see_too(skill, commands):
    with FakeRobot(only=[Base, Camera, JointMotor]) as robot:
        with_black(robot)
        getattr(robot, skill)()

        assert robot.commands == commands


def test_a_camera_stays_where_the_program_has_tilted_it():
    with FakeRobot(only=[Base, Camera, JointMotor]) as robot:
        with_black(robot)
        robot.setAngleCamera(-20)
        robot.senses.ground_line()

        assert robot.commands == [("JointMotor:CAMERA.move", -20)]


def test_ground_sensors_see_no_colours(robot):
    sees(robot, left=10, right=10)

    assert side(robot.senses.line("red")) is None


@pytest.mark.parametrize(
    ("readings", "position"),
    [
        ({"left": 10, "right": 90}, -80),
        ({"left": 10, "right": 10}, 0),
        ({"left": 60, "right": 20}, 40),
        ({"central": 0}, 100),
        ({"central": 50}, 0),
        ({"central": 100}, -100),
    ],
)
def test_the_position_of_a_line_is_a_number_from_left_to_right(robot, readings, position):
    sees(robot, **readings)

    assert robot.get_line_position() == position


def test_a_lost_line_is_on_the_side_where_it_was_last(robot):
    found = []
    for left, right in ((20, 80), (90, 90), (80, 20), (95, 95)):
        sees(robot, left=left, right=right)
        found.append(robot.get_line_position())

    assert found == [-60, -100, 60, 100]


def test_a_camera_tells_the_position_by_the_shares_of_its_picture():
    with FakeRobot(only=[Camera]) as robot:
        robot.set_detections("lines", Lines(LineView("black", 0, 500, 1500), NOTHING, NOTHING))
        seen = robot.get_line_position()
        robot.set_detections("lines", Lines(NOTHING, NOTHING, NOTHING))

        assert seen == 75
        assert robot.get_line_position() == 100


LEVELS = (None, 10.0, 49.9, 50.0, 90.0)


@pytest.mark.parametrize("values", [one for one in product(LEVELS, repeat=3) if any(one[::2])])
def test_several_sensors_see_a_line_wherever_they_are_dark(robot, values):
    readings = dict(zip(("left", "central", "right"), values, strict=True))
    sees(robot, **readings)
    dark = {side: value < DARK for side, value in readings.items() if value is not None}
    left, right = dark.get("left", False), dark.get("right", False)
    line = robot.senses.ground_line()

    assert line.is_there == any(dark.values())
    assert line.is_left == (left and not right)
    assert line.is_center == dark.get("central", left and right)
    assert line.is_right == (right and not left)
