import pytest

from learnblock.devices import GroundSensors

QUESTIONS = {
    "center": "is_center_ground_line",
    "left": "is_left_ground_line",
    "right": "is_right_ground_line",
    "ground": "is_there_ground",
}


@pytest.mark.parametrize(
    ("left", "central", "right", "answers"),
    [
        # Two sensors, as on Thymio.
        (10, None, 10, {"center"}),
        (10, None, 90, {"left"}),
        (90, None, 10, {"right"}),
        (90, None, 90, {"ground"}),
        (50, None, 50, {"ground"}),
        # One in the middle, as on Cozmo and EV3.
        (None, 49, None, {"center"}),
        (None, 50, None, {"ground"}),
        # Three.
        (90, 10, 90, {"center"}),
        (10, 10, 90, {"center", "left"}),
        (10, 90, 10, set()),
        # One on the left only.
        (10, None, None, {"left"}),
        # None that works.
        (None, None, None, set()),
    ],
)
def test_lines_and_ground_are_detected_with_any_number_of_sensors(
    robot, left, central, right, answers
):
    robot.set_reading(GroundSensors, {"left": left, "central": central, "right": right})

    assert answers == {name for name, skill in QUESTIONS.items() if getattr(robot, skill)()}


def test_a_robot_may_leave_out_the_sensors_it_does_not_have(robot):
    robot.set_reading(GroundSensors, {"central": 0})

    assert robot.is_center_ground_line()
