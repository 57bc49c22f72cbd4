"""The robot's pose, and the direction to places.

Places are in mm, x to the east and y to the north; the heading is in degrees clockwise from the
x axis. A robot that counts its wheels' turns, or only knows its commands, starts at (0, 0) and
heading 0.
"""

import math
from typing import TYPE_CHECKING

from learnblock.devices import Base, Pose, number

if TYPE_CHECKING:
    from learnblock.client import Client


def get_pose(robot: "Client") -> Pose | None:
    """Where is the robot? Its x and y in mm and its heading in degrees."""
    base = robot.device(Base)
    return None if base is None else base.pose()


def near_to_target(robot: "Client", x: float, y: float, nearDist: float = 50) -> bool:
    """Is the robot near a place?

    Args:
        x: x of the place in mm.
        y: y of the place in mm.
        nearDist: mm that still count as near.
    """
    place = _from_robot(robot, x, y)
    return place is not None and math.hypot(*place) <= number("nearDist", nearDist)


def target_at_front(robot: "Client", x: float, y: float, diffX: float = 20) -> bool:
    """Is a place straight ahead of the robot?

    Args:
        x: x of the place in mm.
        y: y of the place in mm.
        diffX: mm to either side that still count as straight ahead.
    """
    place = _from_robot(robot, x, y)
    return place is not None and place[0] >= 0 and abs(place[1]) <= number("diffX", diffX)


def target_at_left(robot: "Client", x: float, y: float) -> bool:
    """Is a place to the left of the robot?

    Args:
        x: x of the place in mm.
        y: y of the place in mm.
    """
    place = _from_robot(robot, x, y)
    return place is not None and place[1] < 0


def target_at_right(robot: "Client", x: float, y: float) -> bool:
    """Is a place to the right of the robot?

    Args:
        x: x of the place in mm.
        y: y of the place in mm.
    """
    place = _from_robot(robot, x, y)
    return place is not None and place[1] > 0


def _from_robot(robot: "Client", x: float, y: float) -> tuple[float, float] | None:
    """The place as (mm ahead, mm to the right) of the robot."""
    pose = get_pose(robot)
    if pose is None:
        return None
    east, north = number("x", x) - pose[0], number("y", y) - pose[1]
    cos, sin = math.cos(math.radians(pose[2])), math.sin(math.radians(pose[2]))
    return east * cos - north * sin, -east * sin - north * cos
