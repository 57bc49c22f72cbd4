"""Wheels that react at once."""

import math

from learnblock.client.clock import Clock
from learnblock.devices import Pose


class Wheels:
    """A base without mass: its pose follows the commanded speeds exactly, in the clock's time.

    Args:
        clock: the robot's clock.

    Attributes:
        stuck: while True, the wheels turn but the robot does not move.
    """

    def __init__(self, clock: Clock) -> None:
        self._clock = clock
        self._since = clock.time()
        self._speed = (0.0, 0.0)
        self._pose: Pose = (0.0, 0.0, 0.0)
        self._stuck = False

    def move(self, adv: float, rot: float) -> None:
        """Drive at `adv` mm/s and turn at `rot` degrees/s, clockwise positive."""
        self._advance()
        self._speed = (adv, rot)

    @property
    def pose(self) -> Pose:
        """(x mm, y mm, heading in degrees, clockwise from the x axis, not wrapped)."""
        self._advance()
        return self._pose

    @pose.setter
    def pose(self, pose: Pose) -> None:
        self._advance()
        self._pose = pose

    @property
    def stuck(self) -> bool:
        return self._stuck

    @stuck.setter
    def stuck(self, stuck: bool) -> None:
        self._advance()
        self._stuck = stuck

    def _advance(self) -> None:
        now = self._clock.time()
        seconds, self._since = now - self._since, now
        if self._stuck or seconds == 0:
            return
        adv, rot = self._speed
        x, y, heading = self._pose
        half_turn = math.radians(rot * seconds / 2)
        # The chord of an arc points along the heading in the arc's middle.
        chord = adv * seconds * (math.sin(half_turn) / half_turn if half_turn else 1.0)
        middle = math.radians(heading) + half_turn
        self._pose = (
            x + chord * math.cos(middle),
            y - chord * math.sin(middle),
            heading + rot * seconds,
        )
