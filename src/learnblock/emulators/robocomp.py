"""RoboComp's components, the robot's side: each moves a twin.

Like the real ones, they have no watchdog: the robot keeps driving when its client is gone.
"""

import math
from collections.abc import Callable, Sequence

from learnblock.emulators.twin import Twin
from learnblock.errors import IceRefusedError
from learnblock.ice.robocomp import (
    BaseState,
    LaserConfData,
    LaserReading,
    MotorGoalPosition,
    MotorState,
)


class Wheels:
    """DifferentialRobot.

    Args:
        twin: the robot.
        knows_place: whether it has odometry; EBO returns zeros.
    """

    def __init__(self, twin: Twin, *, knows_place: bool) -> None:
        self._twin = twin
        self._knows_place = knows_place

    def setSpeedBase(self, adv: float, rot: float) -> None:  # noqa: N802 - RoboComp's name
        with self._twin.body() as body:
            body.drive(adv, math.degrees(rot))

    def getBaseState(self) -> BaseState:  # noqa: N802
        if not self._knows_place:
            return BaseState()
        with self._twin.body() as body:
            x, y, heading = body.pose
        right, ahead, alpha = 0.0 - y, x, math.radians(heading)
        return BaseState(
            x=right, z=ahead, alpha=alpha, correctedX=right, correctedZ=ahead, correctedAlpha=alpha
        )

    def getBasePose(self) -> tuple[int, int, float]:  # noqa: N802
        state = self.getBaseState()
        return round(state.x), round(state.z), state.alpha


class Ranger:
    """Laser.

    Args:
        read: returns its distances in mm.
    """

    def __init__(self, read: Callable[[], Sequence[float]]) -> None:
        self._read = read

    def getLaserData(self) -> tuple[LaserReading, ...]:  # noqa: N802
        return tuple(LaserReading(float(number), mm) for number, mm in enumerate(self._read()))

    def getLaserConfData(self) -> LaserConfData:  # noqa: N802
        return LaserConfData()


class Servo:
    """JointMotor: the servo that tilts the camera.

    Args:
        twin: the robot.
        up: 1 if a positive angle tilts up, -1 if it tilts down.
        reports_angle: whether it reports its angle; EBO returns zeros.
    """

    def __init__(self, twin: Twin, up: int, *, reports_angle: bool) -> None:
        self._twin = twin
        self._up = up
        self._reports_angle = reports_angle

    def setPosition(self, goal: MotorGoalPosition) -> None:  # noqa: N802
        _require_servo(goal.name)
        with self._twin.body() as body:
            body.set_joint("CAMERA", self._up * math.degrees(goal.position))

    def setSyncPosition(self, goals: Sequence[MotorGoalPosition]) -> None:  # noqa: N802
        for goal in goals:
            self.setPosition(goal)

    def getMotorState(self, name: str) -> MotorState:  # noqa: N802
        _require_servo(name)
        if not self._reports_angle:
            return MotorState()
        with self._twin.body() as body:
            return MotorState(pos=self._up * math.radians(body.joint("CAMERA")))


def row_of(twin: Twin) -> list[float]:
    """An EBO's distances in mm, from left to right."""
    with twin.body() as body:
        sides = body.distances()
    return [*sides["left"], sides["front"][1], *sides["right"]]


def _require_servo(name: str) -> None:
    if name != "servo":
        raise IceRefusedError(name, "::RoboCompJointMotor::UnknownMotorException")
