"""From the robot's speeds to its wheels' and back: two driven wheels on one axle."""

import math
import threading

from learnblock.devices import Pose
from learnblock.robots.ev3.brick import Drive, State
from learnblock.wheels import body_speeds, wheel_speeds


def turns(adv: float, rot: float, radius: float, track: float) -> Drive:
    """How fast the wheels turn, degrees/s, at adv mm/s forward and rot degrees/s clockwise.

    Args:
        adv: mm/s.
        rot: degrees/s.
        radius: of a wheel, mm.
        track: between the wheels, mm.
    """
    left, right = wheel_speeds(adv, rot, track)
    return Drive(math.degrees(left / radius), math.degrees(right / radius))


class Odometry:
    """Where the robot is, by what its wheels have turned since the start; heading 0 looks along x.

    Args:
        radius: of a wheel, mm.
        track: between the wheels, mm.
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
        """Take in how far the wheels have come."""
        with self._lock:
            last, self._last = self._last or state, state
            left = math.radians(state.left - last.left) * self._radius
            right = math.radians(state.right - last.right) * self._radius
            ahead, turned = body_speeds((left, right), self._track)
            # The direction half way: exact enough for the short arcs between two states.
            middle = math.radians(self._heading + turned / 2)
            self._x += ahead * math.cos(middle)
            self._y -= ahead * math.sin(middle)
            self._heading += turned
