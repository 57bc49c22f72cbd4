"""Converts between the robot's speeds and the degrees that two motors with encoders turn."""

import math
import threading
from typing import Protocol

from learnblock.devices import Pose
from learnblock.wheels import Drivetrain, Odometry, wheel_speeds


class WheelSettings(Protocol):
    """The settings of a robot with such wheels, in mm and, for `full_speed`, degrees/s."""

    @property
    def wheel_radius(self) -> float: ...

    @property
    def track(self) -> float: ...

    @property
    def full_speed(self) -> float: ...


def drivetrain_of(settings: WheelSettings) -> Drivetrain:
    """What the two motors can do."""
    fastest = math.radians(settings.full_speed) * settings.wheel_radius
    return Drivetrain(settings.track, fastest)


def reachable_speeds(settings: WheelSettings, adv: float, rot: float) -> tuple[float, float]:
    """The wheels' speeds in degrees/s, both reduced alike if one would be too fast.

    Robots limit each motor by itself, which would bend a curve.
    """
    speeds = drivetrain_of(settings).reachable(adv, rot)
    return motor_speeds(*speeds, settings.wheel_radius, settings.track)


def motor_speeds(adv: float, rot: float, radius: float, track: float) -> tuple[float, float]:
    """The wheels' speeds in degrees/s at adv mm/s forward and rot degrees/s clockwise.

    Args:
        adv: mm/s.
        rot: degrees/s.
        radius: the radius of a wheel in mm.
        track: the distance between the wheels in mm.
    """
    left, right = wheel_speeds(adv, rot, track)
    return math.degrees(left / radius), math.degrees(right / radius)


class WheelCounts:
    """The robot's pose, from the rotations that its motors report.

    Args:
        radius: the radius of a wheel in mm.
        track: the distance between the wheels in mm.
    """

    def __init__(self, radius: float, track: float) -> None:
        self._radius = radius
        self._odometry = Odometry(track)
        self._lock = threading.Lock()
        self._last: tuple[float, float] | None = None

    @property
    def pose(self) -> Pose:
        """(x mm, y mm, heading in degrees from -180 to 180, clockwise)."""
        with self._lock:
            return self._odometry.pose

    def follow(self, left: float, right: float) -> None:
        """Process the degrees that each wheel has turned since the start."""
        with self._lock:
            last, self._last = self._last or (left, right), (left, right)
            self._odometry.roll(
                math.radians(left - last[0]) * self._radius,
                math.radians(right - last[1]) * self._radius,
            )
