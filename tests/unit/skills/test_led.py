import pytest

from learnblock import robots
from learnblock.devices import RGBLed
from learnblock.testing import FakeRobot


@pytest.mark.parametrize(
    ("intensity", "on"),
    [(0, False), (1, True), (255, True), (-1, False), (False, False), (True, True)],
)
def test_a_lamp_is_on_if_true_or_above_zero(robot, intensity, on):
    robot.led(intensity)

    assert [("Led:Up.set", on)] == robot.commands


def test_a_lamp_takes_a_colour_within_0_and_255(robot):
    robot.RGBled(300, 12.4, -5, slot="Up")

    assert [("RGBLed:Up.set_color", 255, 12, 0)] == robot.commands


@pytest.mark.parametrize(("twin", "slot"), [("sim-cozmo", "Center"), ("sim-thymio", "Up")])
def test_without_a_position_the_first_lamp_takes_the_colour(twin, slot):
    with robots.find(twin).load()(world="empty") as client:
        client.RGBled(255, 0, 0)
        assert {name for name, colour in client.body.leds.items() if colour == (255, 0, 0)} == {
            slot
        }


def test_lighting_a_missing_lamp_has_no_effect(robot):
    robot.led(1, slot="Down")
    robot.RGBled(1, 2, 3, "Down")

    assert [] == robot.commands


@pytest.mark.parametrize(("intensity", "level"), [(1, 255), (0, 0)])
def test_a_coloured_lamp_is_white_on_a_robot_without_plain_ones(intensity, level):
    with FakeRobot(only=[RGBLed]) as robot:
        robot.led(intensity, "Up")
        assert robot.commands == [("RGBLed:Up.set_color", level, level, level)]
