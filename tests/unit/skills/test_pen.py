import pytest

from learnblock.devices import Base
from learnblock.errors import DeviceValueError
from learnblock.testing import FakeRobot


def test_a_pen_is_put_down_and_lifted(robot):
    robot.pen_down()
    robot.pen_up()
    robot.set_pen_width(12)
    robot.clear_drawing()

    assert [
        ("Pen.set", True),
        ("Pen.set", False),
        ("Pen.set_width", 12),
        ("Pen.clear",),
    ] == robot.commands


@pytest.mark.parametrize(
    ("color", "levels"),
    [("black", (20, 20, 20)), ("#ff8800", (255, 136, 0)), ("00FF0a", (0, 255, 10))],
)
def test_a_colour_is_a_name_or_its_red_green_and_blue(robot, color, levels):
    robot.set_pen_color(color)

    assert [("Pen.set_color", *levels)] == robot.commands


@pytest.mark.parametrize("color", ["mauve", "", "#ff88", "#ff8800ff", "x" * 1000, 7, None])
def test_anything_else_is_no_colour(robot, color):
    with pytest.raises(DeviceValueError, match="is not a colour"):
        robot.set_pen_color(color)


def test_a_width_is_a_number(robot):
    with pytest.raises(DeviceValueError, match="must be a number"):
        robot.set_pen_width("thick")


@pytest.mark.parametrize(
    ("skill", "arguments"),
    [
        ("pen_down", ()),
        ("pen_up", ()),
        ("set_pen_color", ("red",)),
        ("set_pen_width", (3,)),
        ("clear_drawing", ()),
    ],
)
def test_a_robot_without_a_pen_does_nothing(skill, arguments):
    with FakeRobot(only=[Base]) as robot:
        getattr(robot, skill)(*arguments)
        assert robot.commands == []
