"""Driving a distance or an arc, and waiting until the robot has stopped."""

import math
from typing import TYPE_CHECKING

from learnblock.devices import Base, Pose, number, positive
from learnblock.skills.course import STEERING, WITHIN, Course, drive, speed_of
from learnblock.skills.progress import PERIOD
from learnblock.skills.turning import shortest

if TYPE_CHECKING:
    from learnblock.client import Client

#: Degrees/s at which a robot drives a narrow arc at most.
_NARROW = 90.0
#: A robot that moves by less than these mm and degrees within these seconds has stopped.
_STILL_WITHIN, _STILL_FOR = 0.5, 0.2


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
    distance, speed = number("distance", distance), speed_of(advSpeed)
    base, heading = robot.device(Base), robot.senses.heading()
    if base is None or heading is None:
        return
    start = base.pose()
    course = Course(
        distance,
        lambda: distance - _ahead(start, base.pose()),
        lambda _: STEERING * (heading - (robot.senses.heading() or 0.0)),
    )
    drive(robot, base, course, speed)


def drive_arc(robot: "Client", radius: float, angle: float, advSpeed: float = 80) -> None:
    """Drive forward along a part of a circle, then continue with the program.

    The angle is measured by the gyroscope or, without one, by the wheels.

    Args:
        radius: mm from the middle of the circle to the robot, more than 0.
        angle: degrees by which the robot turns meanwhile; positive to the right, negative to the
            left; 360 is a whole circle.
        advSpeed: mm/s, more than 0; in a narrow arc the robot drives slower.

    Raises:
        DeviceValueError: the radius or the speed is not more than 0.
        StillDrivingError: the drive takes far too long; the robot may be stuck.
    """
    radius = positive("radius", radius, "skill-radius-not-positive")
    angle, speed = number("angle", angle), speed_of(advSpeed)
    base, heading = robot.device(Base), robot.senses.heading()
    if base is None or heading is None:
        return
    side, travelled = math.copysign(1, angle), _Travelled(base)

    def turned() -> float:
        return ((robot.senses.heading() or 0.0) - heading) * side

    def turning(speed: float) -> float:
        by_way = math.degrees(travelled.read() / radius)
        return side * (math.degrees(speed / radius) + STEERING * (by_way - turned()))

    course = Course(
        math.radians(abs(angle)) * radius,
        lambda: math.radians(abs(angle) - turned()) * radius,
        turning,
        # Half a degree of a narrow arc is less than a millimetre.
        within=min(WITHIN, radius / 100),
    )
    drive(robot, base, course, min(speed, math.radians(_NARROW) * radius))


def wait_until_still(robot: "Client") -> None:
    """Wait until the robot has stopped, for example after `stop_bot` or at an obstacle.

    The robot measures this with its wheels. If nothing makes it stop, the program waits forever.
    """
    base = robot.device(Base)
    if base is None:
        return
    pose, since = base.pose(), robot.clock.time()
    while robot.clock.time() - since < _STILL_FOR:
        robot.clock.sleep(PERIOD)
        now = base.pose()
        if _has_moved(pose, now):
            pose, since = now, robot.clock.time()


class _Travelled:
    """Millimetres that a robot has gone forward since this began, along its way.

    Args:
        base: the robot's base.
    """

    def __init__(self, base: Base) -> None:
        self._base = base
        self._pose = base.pose()
        self._way = 0.0

    def read(self) -> float:
        now = self._base.pose()
        self._way += math.copysign(math.dist(now[:2], self._pose[:2]), _ahead(self._pose, now))
        self._pose = now
        return self._way


def _ahead(start: Pose, now: Pose) -> float:
    """Millimetres that the robot has gone in the direction of its start pose."""
    direction = math.radians(start[2])
    return (now[0] - start[0]) * math.cos(direction) - (now[1] - start[1]) * math.sin(direction)


def _has_moved(before: Pose, now: Pose) -> bool:
    turned = abs(shortest(now[2] - before[2]))
    return max(math.dist(now[:2], before[:2]), turned) > _STILL_WITHIN
