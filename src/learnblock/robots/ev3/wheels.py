"""Converts between the robot's speeds and those of its two driven wheels."""

import math
import threading

from learnblock.devices import Pose
from learnblock.robots.ev3.brick import Drive, State
from learnblock.wheels import Odometry, wheel_speeds


def turns(adv: float, rot: float, radius: float, track: float) -> Drive:
    """The wheels' speeds in degrees/s at adv mm/s forward and rot degrees/s clockwise.

    Args:
        adv: mm/s.
        rot: degrees/s.
        radius: the radius of a wheel in mm.
        track: the distance between the wheels in mm.
    """
    left, right = wheel_speeds(adv, rot, track)
    return Drive(math.degrees(left / radius), math.degrees(right / radius))


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
        self._last: State | None = None

    @property
    def pose(self) -> Pose:
        """(x mm, y mm, heading in degrees from -180 to 180, clockwise)."""
        with self._lock:
            return self._odometry.pose

    def follow(self, state: State) -> None:
        """Process the rotations of a new state."""
        with self._lock:
            last, self._last = self._last or state, state
            self._odometry.roll(
                math.radians(state.left - last.left) * self._radius,
                math.radians(state.right - last.right) * self._radius,
            )
