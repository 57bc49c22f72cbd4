import pytest

from learnblock.client.unseen import MOST_TEXTS
from learnblock.devices import LONGEST_TEXT, Base, Screen
from learnblock.errors import DeviceValueError
from learnblock.testing import FakeRobot


@pytest.fixture
def blind():
    with FakeRobot(only=[Base]) as robot:
        yield robot


@pytest.mark.parametrize(
    ("skill", "value", "shown"),
    [
        ("show_text", "hola", "hola"),
        ("show_text", 12, "12"),
        ("show_text", [1, "a"], "[1, 'a']"),
        ("show_number", 3, "3"),
        ("show_number", 100, "100"),
        ("show_number", 2.0, "2"),
        ("show_number", 2 / 3, "0.67"),
        ("show_number", -0.001, "0"),
        ("show_number", 1234567, "1234567"),
    ],
)
def test_a_text_or_a_number_is_shown(robot, skill, value, shown):
    getattr(robot, skill)(value)

    assert [("Screen.show_text", shown)] == robot.commands
    assert robot.device(Screen).text == shown


def test_a_screen_is_cleared(robot):
    robot.show_text("hello")
    robot.clear_screen()

    assert robot.commands[-1] == ("Screen.show_text", "")


def test_a_long_text_is_cut(robot):
    robot.show_text("x" * 1000)

    assert robot.commands == [("Screen.show_text", "x" * (LONGEST_TEXT - 1) + "…")]


@pytest.mark.parametrize("value", ["three", None, float("inf")])
def test_only_a_number_is_shown_as_a_number(robot, value):
    with pytest.raises(DeviceValueError):
        robot.show_number(value)


def test_a_robot_without_a_screen_prints_each_new_text(blind, capsys):
    for text in ("one", "one", "two"):
        blind.show_text(text)
    blind.clear_screen()
    blind.show_number(2.5)

    assert capsys.readouterr().out == "one\ntwo\n2.5\n"


def test_a_screen_that_cannot_show_text_has_it_printed(blind, capsys):
    blind.add(Screen())
    blind.show_text("hello")

    assert capsys.readouterr().out == "hello\n"


def test_a_loop_without_a_screen_does_not_fill_the_output(blind, capsys):
    for number in range(3 * MOST_TEXTS):
        blind.show_number(number)

    lines = capsys.readouterr().out.splitlines()
    assert len(lines) == MOST_TEXTS + 1
    assert lines[-1] == "..."
