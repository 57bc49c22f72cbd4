"""How a person holds and shakes the robot, by its accelerometer."""

import math

from learnblock.client.senses.sensed_robot import SensedRobot
from learnblock.devices import Accelerometer

#: m/s2 at rest.
GRAVITY = 9.81
#: m/s2 by which the whole acceleration of a robot that is shaken exceeds gravity from time to time.
SHAKING = 5.0
#: Seconds after such a moment in which it still counts as shaken.
LASTING = 0.5
#: m/s2 by which the whole acceleration may differ from gravity: else the robot does not stand still
#: enough to tell where down is.
STILL = 3.0


class Motion:
    """Shaking and tilting.

    Args:
        robot: a robot with an accelerometer.
    """

    def __init__(self, robot: SensedRobot) -> None:
        self._robot = robot
        self._until = -math.inf

    def is_shaken(self) -> bool:
        now = self._robot.clock.time()
        if math.hypot(*self._acceleration()) > GRAVITY + SHAKING:
            self._until = now + LASTING
        return now < self._until

    def tilt(self) -> tuple[float, float]:
        """Degrees by which the front and the left side are raised; 0 while it can't tell."""
        forward, left, up = self._acceleration()
        if abs(math.hypot(forward, left, up) - GRAVITY) > STILL:
            return 0.0, 0.0
        pitch, roll = math.atan2(forward, math.hypot(left, up)), math.atan2(left, up)
        return math.degrees(pitch), math.degrees(roll)

    def _acceleration(self) -> tuple[float, float, float]:
        return self._robot.read(Accelerometer) or (0.0, 0.0, 0.0)
