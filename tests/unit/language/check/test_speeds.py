"""Speeds beyond what the chosen robot can do."""

import pytest

from learnblock.blocks import builtin
from learnblock.i18n import Phrase
from learnblock.language import check, from_python, parse
from learnblock.wheels import Drivetrain

EBO = Drivetrain(track=130, maximum_speed=300, acceleration=800)


def warned(call, drivetrain=EBO):
    """The messages for a program of one call."""
    diagnostics = check(parse(f"main:\n    {call}\nend\n"), builtin(), drivetrain=drivetrain)
    return [one.message for one in diagnostics if one.code == "beyond-robot"]


@pytest.mark.parametrize(
    ("call", "message"),
    [
        ("function.move_straight(1000)", Phrase("check-too-fast", speed="1000", most="300")),
        ("function.move_straight(-301)", Phrase("check-too-fast", speed="301", most="300")),
        ("function.move_straight(1e300)", Phrase("check-too-fast", speed="1e+300", most="300")),
        ("function.drive_distance(9, 400)", Phrase("check-too-fast", speed="400", most="300")),
        ("function.go_to(1, 2, advSpeed=400)", Phrase("check-too-fast", speed="400", most="300")),
        ("function.turn(90, 500)", Phrase("check-turns-too-fast", speed="500", most="264")),
        (
            "function.set_move(200, -120)",
            Phrase("check-curve-too-fast", adv="200", rot="-120", most="178", turned="-107"),
        ),
        (
            "function.move_left(290)",
            Phrase("check-curve-too-fast", adv="290", rot="-15", most="283", turned="-15"),
        ),
    ],
)
def test_a_speed_beyond_the_robot_is_a_warning(call, message):
    assert warned(call) == [message]


@pytest.mark.parametrize(
    "call",
    [
        "function.move_straight(300)",
        "function.move_straight(-300)",
        "function.move_straight(speed)",
        "function.turn(5000)",
        "function.drive_distance(5000)",
        "function.slow_down(5000)",
    ],
)
def test_other_numbers_are_not(call):
    assert warned(call) == []


def test_nothing_is_said_of_a_robot_whose_limits_are_unknown():
    assert warned("function.move_straight(1000)", None) == []


def test_calls_in_python_are_checked():
    python = "robot = Robot()\n[robot.move_straight(1000) for _ in range(3)]\n"
    found = check(from_python(python), builtin(), python=python, drivetrain=EBO)

    assert "beyond-robot" in {one.code for one in found}
