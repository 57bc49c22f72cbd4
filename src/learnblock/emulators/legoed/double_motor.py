"""The emulated Double Motor: its movements, and its motion sensor."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
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
from learnblock.robots.legoed.colours import COLOURS
from learnblock.robots.legoed.messages import Product

#: The names of the wheels.
LEFT, RIGHT = "left", "right"
#: Degrees/s at 100 %.
FASTEST = 660
#: The lamp of its button.
STATUS_LIGHT = "Status"


@dataclass(frozen=True, slots=True)
class Ride:
    """A command that moves the wheels.

    Args:
        is_over: whether it has reached its end.
        end: reports how it has ended.
    """

    is_over: Callable[[], bool]
    end: Callable[[int], None]


class DoubleMotor(DeviceFirmware):
    """The Double Motor under a twin.

    Args:
        vehicle: the twin's wheels and sensors.
        twin: the twin.
    """

    def __init__(self, vehicle: Vehicle, twin: Twin) -> None:
        self._vehicle = vehicle
        self._twin = twin
        self._speed = 50
        self._percent = (0, 0)
        self._movement: Ride | None = None
        self._zero = 0.0
        super().__init__(Product.DOUBLE_MOTOR)

    def actions(self) -> Mapping[str, Action]:
        return {
            "MovementMoveTankCommand": self._go_on,
            "MovementMoveTankForDegreesCommand": self._go_for_degrees,
            "MovementMoveForTimeCommand": self._go_for_time,
            "MovementTurnForDegreesCommand": self._turn,
            "MovementStopCommand": self._stop,
            "MovementSetSpeedCommand": self._set_speed,
            "ImuResetYawAxisCommand": self._reset_yaw,
            **accepted(
                "MovementSetEndStateCommand",
                "MovementSetAccelerationCommand",
                "MovementSetTurnSteeringCommand",
                "ImuSetYawFaceCommand",
            ),
        }

    def items(self) -> list[Any]:
        package = self.package
        turned = self._vehicle.turned()
        state = package.MOTOR_STATE_RUNNING if any(self._percent) else package.MOTOR_STATE_READY
        yaw = round(10 * ((self._vehicle.angle() - self._zero + 180) % 360 - 180))
        sensor = package.ImuDeviceNotification(
            package.DEVICE_FACE_TOP, package.DEVICE_FACE_TOP, yaw, 0, 0, 0, 0, 0, 0, 0, 0
        )
        motors = []
        for bit, wheel, percent in zip((1, 2), (LEFT, RIGHT), self._percent, strict=True):
            degrees = round(turned[wheel])
            motors.append(
                package.MotorNotification(bit, state, degrees % 360, 0, percent, degrees, -1)
            )
        return [sensor, *motors]

    def move(self) -> None:
        movement = self._movement
        if movement and movement.is_over():
            self._movement = None
            self._run((0, 0))
            movement.end(COMPLETED)

    def shine(self) -> None:
        number, intensity = self.lamp
        red, green, blue = (part * intensity // 100 for part in COLOURS.get(number, (0, 0, 0)))
        self._vehicle.light(STATUS_LIGHT, (red, green, blue))

    def sound(self) -> None:
        self._vehicle.note("tone", self.sounds[-1])

    def _run(self, percent: tuple[int, int]) -> None:
        self._percent = percent
        speeds = zip((LEFT, RIGHT), percent, strict=True)
        self._vehicle.turn({wheel: FASTEST * speed / 100 for wheel, speed in speeds})

    def _begin(self, percent: tuple[int, int], movement: Ride | None) -> None:
        """Move in another way; what moved it before has been interrupted."""
        before, self._movement = self._movement, movement
        self._run(percent)
        if before:
            before.end(INTERRUPTED)

    def _go_on(self, message: Any, end: Callable[[int], None]) -> bool:
        del end
        self._begin((message.speedLeft, message.speedRight), None)
        return True

    def _go_for_degrees(self, message: Any, end: Callable[[int], None]) -> bool:
        begun = self._vehicle.turned()

        def is_over() -> bool:
            now = self._vehicle.turned()
            turned = max(abs(now[wheel] - begun[wheel]) for wheel in now)
            return bool(turned >= message.degrees)

        self._begin((message.speedLeft, message.speedRight), Ride(is_over, end))
        return False

    def _go_for_time(self, message: Any, end: Callable[[int], None]) -> bool:
        until = self._twin.time + message.time / 1000
        left, right = self._ways()[message.direction]
        self._begin(
            (left * self._speed, right * self._speed),
            Ride(lambda: self._twin.time >= until, end),
        )
        return False

    def _turn(self, message: Any, end: Callable[[int], None]) -> bool:
        begun = self._vehicle.angle()

        def is_over() -> bool:
            return bool(abs(self._vehicle.angle() - begun) >= message.degrees)

        left, right = self._ways()[message.direction]
        self._begin((left * self._speed, right * self._speed), Ride(is_over, end))
        return False

    def _ways(self) -> dict[int, tuple[int, int]]:
        """The directions of the wheels in each direction of the robot."""
        package = self.package
        return {
            package.MOVEMENT_DIRECTION_FORWARD: (1, 1),
            package.MOVEMENT_DIRECTION_BACKWARD: (-1, -1),
            package.MOVEMENT_DIRECTION_LEFT: (-1, 1),
            package.MOVEMENT_DIRECTION_RIGHT: (1, -1),
        }

    def _stop(self, message: Any, end: Callable[[int], None]) -> bool:
        del message, end
        self._begin((0, 0), None)
        return True

    def _set_speed(self, message: Any, end: Callable[[int], None]) -> bool:
        del end
        self._speed = message.speed
        return True

    def _reset_yaw(self, message: Any, end: Callable[[int], None]) -> bool:
        del end
        self._zero = self._vehicle.angle() - message.value / 10
        return True
