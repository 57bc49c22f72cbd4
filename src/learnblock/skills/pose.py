"""The robot's pose, and the direction to places.

Places are in mm, x to the east and y to the north; the heading is in degrees clockwise from the
x axis. A robot that counts its wheels' turns, or only knows its commands, starts at (0, 0) and
heading 0.
"""

import math
from typing import TYPE_CHECKING

from learnblock.devices import Base, Pose, number
from learnblock.skills.course import STEERING, WITHIN, Course, drive, speed_of
from learnblock.skills.turning import BRISK, shortest, turn_by

if TYPE_CHECKING:
    from learnblock.client import Client

#: Millimetres from a place at which its direction no longer says anything.
_ARRIVING = 40.0


def get_pose(robot: "Client") -> Pose | None:
    """Where is the robot? Its x and y in mm and its heading in degrees.

    x is ahead of the robot's start, y to the left of it; the heading is positive to the right.
    """
    base = robot.device(Base)
    robot.await_reading(Base)
    return None if base is None else base.pose()


def go_to(robot: "Client", x: float, y: float, advSpeed: float = 80) -> None:
    """Turn to a place and drive there, then continue with the program.

    Places are those of `get_pose`: a robot that counts its wheels' turns starts at (0, 0).

    Args:
        x: mm ahead of the start.
        y: mm to the left of the start.
        advSpeed: mm/s, more than 0.

    Raises:
        DeviceValueError: the speed is not more than 0.
        StillTurningError: the turn takes far too long; the robot may be stuck.
        StillDrivingError: the drive takes far too long; the robot may be stuck.
    """
    speed = speed_of(advSpeed)
    base, heading, place = robot.device(Base), robot.senses.heading(), _from_robot(robot, x, y)
    if base is None or heading is None or place is None:
        return
    if math.hypot(*place) <= WITHIN:
        return
    turn_by(robot, base, shortest(_direction(place)), BRISK)

    def now() -> tuple[float, float]:
        return _from_robot(robot, x, y) or (0.0, 0.0)

    def turning(_: float) -> float:
        return STEERING * _direction(now()) if now()[0] > _ARRIVING else 0.0

    drive(robot, base, Course(math.hypot(*place), lambda: now()[0], turning), speed)


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


def _direction(place: tuple[float, float]) -> float:
    """Degrees to the right to a place, given as (mm ahead, mm to the right)."""
    return math.degrees(math.atan2(place[1], place[0]))
