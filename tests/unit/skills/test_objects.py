import pytest

from learnblock.errors import UnknownNameError
from learnblock.perception import ColouredObject

SIDES = ("left", "center", "right")


def thing(colour, column, area=100):
    return ColouredObject(colour, (column, 120), area, 0, 0, 10, 10)


@pytest.mark.parametrize(("column", "where"), [(60, "left"), (160, "center"), (260, "right")])
def test_an_object_is_on_one_side_of_the_picture(robot, column, where):
    robot.set_detections("objects", (thing("green", column),))

    assert robot.is_there_object("green")
    assert [where] == [one for one in SIDES if getattr(robot, f"is_{one}_object")("green")]


def test_an_object_of_another_colour_does_not_count(robot):
    robot.set_detections("objects", (thing("green", 60),))

    assert not robot.is_there_object()
    assert not robot.is_left_object("blue")
    assert robot.get_object_size("blue") == 0


def test_the_largest_of_several_is_used(robot):
    robot.set_detections("objects", (thing("red", 60, 7680), thing("red", 260, 100)))

    assert robot.is_left_object("red")
    assert not robot.is_right_object("red")
    assert robot.get_object_size("red") == pytest.approx(10)


def test_without_a_camera_an_object_has_no_size(robot):
    robot.set_detections("objects", None)

    assert robot.get_object_size() is None


def test_a_misspelt_colour_gets_a_suggestion(robot):
    with pytest.raises(UnknownNameError, match="Did you mean 'green'"):
        robot.is_there_object("gren")
