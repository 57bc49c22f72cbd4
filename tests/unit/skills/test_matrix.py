import pytest

from learnblock.devices import Screen
from learnblock.testing import FakeRobot


@pytest.mark.parametrize(
    ("skill", "args", "command"),
    [
        ("matrix_number", (7,), ("Matrix.number", 7, 4)),
        ("matrix_text", ("Hola Mundo",), ("Matrix.text", "Hola Mundo", 4, 0)),
        ("matrix_text", ("Hi", 9, 99), ("Matrix.text", "Hi", 7, 15)),
        ("matrix_icon", ("heart", 2), ("Matrix.icon", "heart", 2)),
    ],
)
def test_the_matrix_shows_numbers_texts_and_icons(robot, skill, args, command):
    getattr(robot, skill)(*args)

    assert [command] == robot.commands


@pytest.mark.parametrize(
    ("skill", "args", "shown"), [("matrix_number", (7.5,), "7.5"), ("matrix_text", ("Hi", 9), "Hi")]
)
def test_a_robot_without_a_matrix_shows_texts_and_numbers_on_its_screen(skill, args, shown):
    with FakeRobot(only=[Screen]) as robot:
        getattr(robot, skill)(*args)
        assert robot.commands == [("Screen.show_text", shown)]


def test_a_robot_without_a_matrix_shows_no_icon():
    with FakeRobot(only=[Screen]) as robot:
        robot.matrix_icon("heart")
        assert robot.commands == []
