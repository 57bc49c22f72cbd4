"""Driving a distance: a control loop on the odometry that keeps the heading."""

import math
from typing import TYPE_CHECKING

from learnblock.devices import Base, Pose, number
from learnblock.errors import DeviceValueError, StillDrivingError
from learnblock.skills.progress import PATIENCE, Progress

if TYPE_CHECKING:
    from learnblock.client import Client

#: Millimetres from the target at which the wheels are stopped.
_WITHIN = 1.0
#: mm/s for each mm that remains, and the slowest speed, at which every robot still moves.
_GAIN, _SLOWEST = 5.0, 10.0
#: mm/s by which two commands differ at most while the robot speeds up; see `turning`.
_SPEEDING_UP = 8.0
#: Degrees/s for each degree off the heading.
_STEERING = 2.0
#: Seconds between two commands.
_PERIOD = 0.02


def drive_distance(robot: "Client", distance: float, advSpeed: float = 80) -> None:
    """Drive straight for a distance, then continue with the program.

    The distance is that of the wheels, which may slip. The robot keeps its heading, by its
    gyroscope or, without one, by its wheels.

    Args:
        distance: mm; negative drives backwards.
        advSpeed: mm/s, more than 0.

    Raises:
        DeviceValueError: the speed is not more than 0.
        StillDrivingError: the drive takes far too long; the robot may be stuck.
    """
    distance, speed = number("distance", distance), number("advSpeed", advSpeed)
    if speed <= 0:
        raise DeviceValueError("skill-speed-not-positive", speed=speed)
    base, heading = robot.device(Base), robot.senses.heading()
    if base is not None and heading is not None:
        _drive(robot, base, heading, distance, speed)


def _drive(robot: "Client", base: Base, heading: float, distance: float, speed: float) -> None:
    start, magnitude = base.pose(), 0.0
    began = robot.clock.time()
    slowest = min(speed, _SLOWEST)
    deadline = began + 5 + abs(distance) / slowest
    progress = Progress(slowest * PATIENCE / 10)
    while abs(remaining := distance - _ahead(start, base.pose())) > _WITHIN:
        now = robot.clock.time()
        progress.note(now, remaining)
        if progress.is_stuck or now >= deadline:
            base.stop()
            raise StillDrivingError(
                "skill-still-driving",
                driven=round(distance - remaining),
                distance=round(distance),
                seconds=round(robot.clock.time() - began),
            )
        off = heading - (robot.senses.heading() or 0.0)
        wanted = min(max(_GAIN * abs(remaining), _SLOWEST), speed)
        magnitude = min(wanted, magnitude + _SPEEDING_UP)
        base.move(math.copysign(magnitude, remaining), _STEERING * off)
        robot.clock.sleep(_PERIOD)
    base.stop()


def _ahead(start: Pose, now: Pose) -> float:
    """Millimetres that the robot has gone in the direction of its start pose."""
    direction = math.radians(start[2])
    return (now[0] - start[0]) * math.cos(direction) - (now[1] - start[1]) * math.sin(direction)
