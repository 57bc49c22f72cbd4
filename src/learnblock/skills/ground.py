"""Dark lines on the floor, and the edge of the floor.

Sensors read 0 (dark) to 100; a reading below 50 is dark.
"""

from typing import TYPE_CHECKING

from learnblock.client.senses.lines import DARK
from learnblock.devices import GroundSensors

if TYPE_CHECKING:
    from learnblock.client import Client


def is_center_ground_line(robot: "Client") -> bool:
    """Is there a dark line under the middle of the robot?

    On a robot without a central sensor: under both its left and its right sensor? A camera looks
    at the floor ahead.
    """
    return robot.senses.ground_line().is_center


def is_left_ground_line(robot: "Client") -> bool:
    """Is there a dark line under the left sensor, and none under the right one?

    A robot with a single sensor looks for a line that it has lost on both sides, one after the
    other. A camera looks at the floor ahead.
    """
    return robot.senses.ground_line().is_left


def is_right_ground_line(robot: "Client") -> bool:
    """Is there a dark line under the right sensor, and none under the left one?

    A robot with a single sensor looks for a line that it has lost on both sides, one after the
    other. A camera looks at the floor ahead.
    """
    return robot.senses.ground_line().is_right


def is_there_ground(robot: "Client") -> bool:
    """Is there ground under the whole robot?

    Beyond the edge of a table nothing is reflected, which looks dark, so there is ground if no
    sensor sees anything dark. A black line therefore counts as no ground.
    """
    readings = robot.read(GroundSensors) or {}
    dark = [value < DARK for value in readings.values() if value is not None]
    return bool(dark) and not any(dark)


def get_line_position(robot: "Client") -> float | None:
    """How far to the side is the black line? From -100 (left) to 100 (right), 0 in the middle.

    By a camera, which tilts to the floor unless the program has tilted it, or by the sensors under
    the robot; for a single one the middle is the line's right
    edge. A robot that has lost the line gets -100 or 100, for the side on which it was last.
    """
    return robot.senses.line_position()
