"""Dark lines on the floor, and the edge of the floor.

Sensors read 0 (dark) to 100; a reading below 50 is dark.
"""

from typing import TYPE_CHECKING

from learnblock.devices import GroundSensors

if TYPE_CHECKING:
    from learnblock.client import Client

_DARK = 50


def is_center_ground_line(robot: "Client") -> bool:
    """Is there a dark line under the middle of the robot?

    On a robot without a central sensor: under both its left and its right sensor?
    """
    dark = _dark(robot)
    if "central" in dark:
        return dark["central"]
    return dark.get("left", False) and dark.get("right", False)


def is_left_ground_line(robot: "Client") -> bool:
    """Is there a dark line under the left sensor, and none under the right one?"""
    dark = _dark(robot)
    return dark.get("left", False) and not dark.get("right", False)


def is_right_ground_line(robot: "Client") -> bool:
    """Is there a dark line under the right sensor, and none under the left one?"""
    dark = _dark(robot)
    return dark.get("right", False) and not dark.get("left", False)


def is_there_ground(robot: "Client") -> bool:
    """Is there ground under the whole robot?

    Beyond the edge of a table nothing is reflected, which looks dark, so there is ground if no
    sensor sees anything dark. A black line therefore counts as no ground.
    """
    dark = _dark(robot)
    return bool(dark) and not any(dark.values())


def _dark(robot: "Client") -> dict[str, bool]:
    """For each sensor of the robot, whether it sees something dark."""
    readings = robot.read(GroundSensors) or {}
    return {side: value < _DARK for side, value in readings.items() if value is not None}
