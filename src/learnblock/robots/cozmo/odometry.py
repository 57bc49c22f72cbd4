"""Where Cozmo is and how far it has turned, from the reports it makes of itself."""

import math

from learnblock.devices import Pose

FULL_TURN = 2 * math.pi


class Odometry:
    """Follows the pose that the robot reports.

    The robot counts mm ahead and to the left, and radians to the left from -pi to pi, from an
    origin that moves to where it is set down after it was lifted.
    """

    def __init__(self) -> None:
        self._origin: object = None
        self._angle = 0.0
        self._turned = 0.0
        self._zero = 0.0
        self.pose: Pose = (0.0, 0.0, 0.0)

    def follow(self, origin: object, x: float, y: float, angle: float) -> None:
        """Take a report.

        Args:
            origin: what the robot calls the place that it counts from.
            x: mm ahead of the origin.
            y: mm to its left.
            angle: radians to the left.
        """
        if origin == self._origin:
            self._turned -= math.remainder(angle - self._angle, FULL_TURN)
        # A new origin is no turn of the robot.
        self._origin, self._angle = origin, angle
        self.pose = (x, y, -math.degrees(math.remainder(angle, FULL_TURN)))

    def reset(self) -> None:
        """Let the present heading be 0 for `turned`."""
        self._zero = self._turned

    def turned(self) -> float:
        """Degrees to the right since `reset`, with all full turns in it."""
        return math.degrees(self._turned - self._zero)
