"""Converts between the robot's speeds and those of its two driven wheels."""

import math
import threading

from learnblock.devices import Pose
from learnblock.robots.ev3.brick import Drive, State
from learnblock.wheels import body_speeds, wheel_speeds


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


class Odometry:
    """The robot's pose, computed from its wheels' rotations; heading 0 faces along x.

    Args:
        radius: the radius of a wheel in mm.
        track: the distance between the wheels in mm.
    """

    def __init__(self, radius: float, track: float) -> None:
        self._radius, self._track = radius, track
        self._lock = threading.Lock()
        self._last: State | None = None
        self._x = self._y = self._heading = 0.0

    @property
    def pose(self) -> Pose:
        """(x mm, y mm, heading in degrees from -180 to 180, clockwise)."""
        with self._lock:
            return self._x, self._y, (self._heading + 180) % 360 - 180

    def follow(self, state: State) -> None:
        """Process the rotations of a new state."""
        with self._lock:
            last, self._last = self._last or state, state
            left = math.radians(state.left - last.left) * self._radius
            right = math.radians(state.right - last.right) * self._radius
            ahead, turned = body_speeds((left, right), self._track)
            # The direction halfway is exact enough for the short arcs between two states.
            middle = math.radians(self._heading + turned / 2)
            self._x += ahead * math.cos(middle)
            self._y -= ahead * math.sin(middle)
            self._heading += turned
