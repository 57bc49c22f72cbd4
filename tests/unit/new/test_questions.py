"""The questions about a new robot: an invalid answer is refused, and the question repeated."""

import pytest
from click.testing import CliRunner

from learnblock import robots
from learnblock.cli import main


def new_robot(*answers, name=()):
    """Return the output of `learnblock new robot` for these answers; "" takes the default."""
    return CliRunner().invoke(main, ["new", "robot", *name], input="\n".join(answers) + "\n")


#: Title, connection with two fields, three of the wheels, five of the body, and no more.
PLAIN = [""] * 12 + ["0", "none", *["n"] * 4, "", "n", ""]


def test_defaults_make_a_robot_that_runs(own_home):
    result = new_robot("my-rover", *PLAIN)
    assert result.exit_code == 0, result.output
    twin = robots.find("sim-my-rover").load().description()
    assert twin.title == "My Rover"
    assert twin.devices() == ("Base:ROBOT",)
    with robots.connect("sim-my-rover") as robot:
        robot.move_straight(50)
        robot.sleep(1)
        assert robot.where()[0] > 30


def test_every_device_can_be_answered(own_home):
    answers = [
        *["Rover", "serial", "/dev/ttyACM0", "9600"],
        *["20", "90", "250"],
        *["disc", "60", "70", "0.4"],
        *["3", "", "", "", "", "", "0", "front", "50", "0", "400", "", "", "", "", ""],
        *["left, right", "40", "", "40", ""],
        *["y", "y", "y", "leds", "y"],
        *["CAMERA", "-20", "20"],
        *["y", "60", "", "250"],
        *["Front, Rear", "y", "n"],
    ]
    result = new_robot(*answers, name=["whole"])
    assert result.exit_code == 0, result.output
    twin = robots.find("sim-whole").load().description()
    assert [sensor.direction for sensor in twin.distance] == [-45, 0, 45]
    assert [sensor.sides for sensor in twin.distance] == [
        ("front", "left"),
        ("front",),
        ("front", "right"),
    ]
    assert (twin.distance[0].x, twin.distance[0].y) == (42, 42)
    assert [sensor.side for sensor in twin.ground] == ["left", "right"]
    assert twin.camera[0].joint == "CAMERA"
    assert {"Led:Rear", "RGBLed:Front", "Display:ROBOT", "Speaker:ROBOT"} <= set(twin.devices())
    assert robots.find("whole").load().settings_type().baud == 9600


@pytest.mark.parametrize(
    ("position", "wrong", "message"),
    [
        (0, "My Rover", "A robot cannot be named 'My Rover'. Use at most 40"),
        (0, "ebo", "There is already a robot 'ebo'."),
        (1, "a'b", "title cannot be"),
        (19, "a'b", "'a'b' is not a word."),
        (3, "a b", "network.address cannot be 'a b'. Expected text of 1 to 60"),
        (4, "http", "network.port cannot be 'http'. Expected a whole number from 1 to 65535"),
        (5, "0", "wheels.radius cannot be '0'. Expected a number from 1 to 1000"),
        (8, "round", "body.shape cannot be 'round'. Expected one of box, disc"),
        (13, "-1", "-1 is not in the range 0<=x<=50"),
        (14, "left, behind", "'behind' is not one of left, central, right."),
    ],
)
def test_an_invalid_answer_is_refused_and_the_question_repeated(own_home, position, wrong, message):
    answers = ["my-rover", *PLAIN]
    result = new_robot(*answers[:position], wrong, *answers[position:])
    assert result.exit_code == 0, result.output
    assert f"Error: {message}" in result.output
    assert "sim-my-rover" in robots.entries()


def test_an_invalid_range_is_asked_again(own_home):
    answers = [*PLAIN[:18], "ARM", "20", "10", "10", "20", "n", ""]
    result = new_robot("my-rover", *answers)
    assert "Error: joint.minimum must be below joint.maximum." in result.output
    (joint,) = robots.find("sim-my-rover").load().description().joint
    assert (joint.minimum, joint.maximum) == (10, 20)


def test_unanswered_questions_write_nothing(own_home):
    assert new_robot("my-rover", "Rover").exit_code != 0
    assert not (own_home / "robots").exists()
