"""The heading: by the gyroscope, or by the wheels."""

from learnblock.client.senses.sensed_robot import SensedRobot
from learnblock.devices import Base, Gyroscope

#: The key of the gyroscope whose axis points up.
UPRIGHT = "Z_AXIS"


class Heading:
    """Degrees turned to the right since the last reset, including full turns.

    Without a gyroscope it follows the heading of the base, whose error grows with each turn. The
    turn between two readings must be less than half a turn, or full turns are lost.

    Args:
        robot: the robot.
    """

    def __init__(self, robot: SensedRobot) -> None:
        self._robot = robot
        self._direction = 0.0
        self._turned = 0.0

    def read(self) -> float:
        if self._robot.has(Gyroscope, UPRIGHT):
            return self._robot.read(Gyroscope, UPRIGHT) or 0.0
        base = self._robot.device(Base)
        self._robot.await_reading(Base)
        direction = 0.0 if base is None else base.pose()[2]
        self._turned += (direction - self._direction + 180) % 360 - 180
        self._direction = direction
        return self._turned

    def reset(self) -> None:
        if not self._robot.has(Gyroscope, UPRIGHT):
            self.read()
            self._turned = 0.0
            return
        gyroscope = self._robot.device(Gyroscope, UPRIGHT)
        if gyroscope is not None:
            gyroscope.reset()
            self._robot.forget_readings()
