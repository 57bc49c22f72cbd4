"""The hand that tilts and shakes a simulated robot."""

import math
from collections.abc import Mapping
from typing import Protocol

STANDARD_GRAVITY = 9.80665
"""m/s²; the upward reading of an accelerometer at rest (ISO 80000-3)."""

TILTS: Mapping[str, tuple[float, float]] = {
    "level": (0, 0),
    "front": (-30, 0),
    "back": (30, 0),
    "left": (0, -30),
    "right": (0, 30),
}
"""Degrees by which a hand raises the front and the left side to tilt a robot to a side."""
SHAKE_SECONDS = 1.0
SHAKE_RATE = 7.0
"""Hz."""
SHAKE_STRENGTH = 20.0
"""m/s²; the amplitude to the left and right."""


class TimedWorld(Protocol):
    """What a hand needs of the world."""

    @property
    def time(self) -> float: ...


class Hand:
    """The hand that holds a robot; only the robot's accelerometer notices.

    Args:
        world: the world that contains the robot.
    """

    def __init__(self, world: TimedWorld) -> None:
        self._world = world
        self._tilt = TILTS["level"]
        self._shaken_from = -math.inf

    def move(self, how: str) -> None:
        """Tilt the robot until further notice, or ``shake`` it for a second.

        Args:
            how: ``shake``, or one of `TILTS`.
        """
        if how == "shake":
            self._shaken_from = self._world.time
        else:
            self._tilt = TILTS[how]

    def acceleration(self) -> tuple[float, float, float]:
        """Forward, left and up in m/s²: gravity on the tilted robot, and the shaking."""
        pitch, roll = map(math.radians, self._tilt)
        forward = STANDARD_GRAVITY * math.sin(pitch)
        left = STANDARD_GRAVITY * math.cos(pitch) * math.sin(roll)
        up = STANDARD_GRAVITY * math.cos(pitch) * math.cos(roll)
        shaken = self._world.time - self._shaken_from
        if shaken < SHAKE_SECONDS:
            left += SHAKE_STRENGTH * math.cos(2 * math.pi * SHAKE_RATE * shaken)
        return forward, left, up
