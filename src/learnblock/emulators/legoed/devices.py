"""The other emulated devices of LEGO Education."""

from collections.abc import Callable, Mapping
from typing import Any

from learnblock.emulators.legoed.firmware import (
    COMPLETED,
    INTERRUPTED,
    Action,
    DeviceFirmware,
    accepted,
)
from learnblock.emulators.twin import Twin
from learnblock.emulators.vehicle import Vehicle
from learnblock.robots.legoed.messages import Product

#: The joint that the Single Motor turns.
ARM = "ARM"
#: Degrees from its goal at which the Single Motor has arrived.
CLOSE = 1.0
#: Degrees of a lever at 100 %.
WIDEST = 45


class ColourSensor(DeviceFirmware):
    """The Color Sensor under a twin."""

    def __init__(self, vehicle: Vehicle) -> None:
        self._vehicle = vehicle
        super().__init__(Product.COLOUR_SENSOR)

    def actions(self) -> Mapping[str, Action]:
        return accepted("SetColorSensorModeRequest")

    def items(self) -> list[Any]:
        package = self.package
        light = round(self._vehicle.reflection())
        raw = 10 * light
        mode = package.COLOR_SENSOR_MODE_COLOR_DETECTION
        return [
            package.ColorSensorNotification(
                package.LEGO_COLOR_NONE, light, raw, raw, raw, 0, 0, light, mode
            )
        ]


class HandController(DeviceFirmware):
    """The Controller, at rest on a table.

    Attributes:
        levers: % of the left and the right lever, forward positive; a test moves them.
    """

    def __init__(self) -> None:
        self.levers = (0, 0)
        super().__init__(Product.CONTROLLER)

    def items(self) -> list[Any]:
        left, right = self.levers
        angles = (WIDEST * lever // 100 for lever in self.levers)
        return [self.package.ControllerNotification(left, right, *angles)]


class SingleMotor(DeviceFirmware):
    """The Single Motor, which turns a twin's arm."""

    def __init__(self, twin: Twin) -> None:
        self._twin = twin
        self._zero = 0.0
        self._goal = 0.0
        self._end: Callable[[int], None] | None = None
        super().__init__(Product.SINGLE_MOTOR)

    def actions(self) -> Mapping[str, Action]:
        return {
            "MotorResetRelativePositionCommand": self._reset,
            "MotorRunToRelativePositionCommand": self._turn,
            "MotorStopCommand": self._stop,
            **accepted(
                "MotorSetSpeedCommand", "MotorSetEndStateCommand", "MotorSetAccelerationCommand"
            ),
        }

    def items(self) -> list[Any]:
        package = self.package
        degrees = round(self._angle() - self._zero)
        state = package.MOTOR_STATE_RUNNING if self._end else package.MOTOR_STATE_READY
        return [package.MotorNotification(1, state, degrees % 360, 0, 0, degrees, -1)]

    def move(self) -> None:
        if self._end and abs(self._angle() - self._goal) < CLOSE:
            end, self._end = self._end, None
            end(COMPLETED)

    def _angle(self) -> float:
        with self._twin.body() as body:
            return body.joint(ARM)

    def _reset(self, message: Any, end: Callable[[int], None]) -> bool:
        del end
        self._zero = self._angle() - message.position
        return True

    def _turn(self, message: Any, end: Callable[[int], None]) -> bool:
        self._go(self._zero + message.position, end)
        return False

    def _stop(self, message: Any, end: Callable[[int], None]) -> bool:
        del message, end
        self._go(self._angle(), None)
        return True

    def _go(self, goal: float, end: Callable[[int], None] | None) -> None:
        before, self._end, self._goal = self._end, end, goal
        with self._twin.body() as body:
            body.set_joint(ARM, goal)
        if before:
            before(INTERRUPTED)
