"""Cozmo's pose and the angle that it has turned, from its status reports."""

import math

from learnblock.devices import Pose

FULL_TURN = 2 * math.pi


class CozmoOdometry:
    """Tracks the pose that the robot reports.

    The robot counts mm ahead and to the left, and radians to the left from -pi to pi, from an
    origin. After a person lifts it, the origin moves to where it is put down.
    """

    def __init__(self) -> None:
        self._origin: object = None
        self._angle = 0.0
        self._turned = 0.0
        self._zero = 0.0
        self.pose: Pose = (0.0, 0.0, 0.0)

    def follow(self, origin: object, x: float, y: float, angle: float) -> None:
        """Process a report.

        Args:
            origin: the robot's identifier for the origin of its coordinates.
            x: mm ahead of the origin.
            y: mm to the left of the origin.
            angle: radians to the left.
        """
        if origin == self._origin:
            self._turned -= math.remainder(angle - self._angle, FULL_TURN)
        # With a new origin the angle changes without a turn.
        self._origin, self._angle = origin, angle
        self.pose = (x, y, -math.degrees(math.remainder(angle, FULL_TURN)))

    def reset(self) -> None:
        """Set the current heading to 0 for `turned`."""
        self._zero = self._turned

    def turned(self) -> float:
        """Degrees turned to the right since `reset`, including full turns."""
        return math.degrees(self._turned - self._zero)
