"""The messages of LEGO Education's devices, by the maker's own package.

`legoeducation` says what each byte means, and its versions follow those of the devices' software.
It is an add-on, imported only when such a robot is used; all that we use of it is in this file and
in the emulator.
"""

import struct
from dataclasses import dataclass
from enum import IntEnum
from typing import Any

from learnblock.robots.real import require

#: Bluetooth's characteristics for commands and for what a device sends.
SERVICE = "0000fd02-0000-1000-8000-00805f9b34fb"
COMMANDS = "0000fd02-0001-1000-8000-00805f9b34fb"
EVENTS = "0000fd02-0002-1000-8000-00805f9b34fb"
#: LEGO's number in what a device advertises.
COMPANY = 0x0397
#: The bit of the only motor, or of the left one, and of the right one.
LEFT, RIGHT = 1, 2
#: The highest tone of a device, in hertz.
HIGHEST = 2700


class Product(IntEnum):
    """The devices, by LEGO's numbers."""

    SINGLE_MOTOR = 512
    DOUBLE_MOTOR = 513
    COLOUR_SENSOR = 514
    CONTROLLER = 515


@dataclass(frozen=True, slots=True)
class Info:
    """What a device says of itself.

    Args:
        product: its number.
        version: the version of its messages, such as (2, 3, 0).
    """

    product: int
    version: tuple[int, int, int]


@dataclass(frozen=True, slots=True)
class KitReport:
    """What a device measures; None for what it has no sensor for.

    Args:
        battery: %.
        left: degrees that the only motor, or the left one, has turned, forward positive.
        right: the same for the right one.
        yaw: degrees from -180 to 180, clockwise positive.
        reflection: reflected light, 0 to 100.
        left_lever: % of a controller's lever, forward positive.
        right_lever: the same for the right one.
    """

    battery: int | None = None
    left: int | None = None
    right: int | None = None
    yaw: float | None = None
    reflection: int | None = None
    left_lever: int | None = None
    right_lever: int | None = None


def version() -> tuple[int, int, int]:
    """The version of the messages that the maker's package speaks."""
    numbers: tuple[int, int, int] = _package().RPC_VERSION
    return numbers


def fits(info: Info) -> bool:
    """Whether the package understands a device: the maker compares the first two numbers."""
    return info.version[:2] == version()[:2]


def parsed(message: bytes) -> Info | KitReport | None:
    """What a device sends; None for the result of a command.

    Raises:
        ValueError: it is incomplete.
    """
    package = _package()
    kind, payload = message[:1], message[1:]
    try:
        if kind == bytes([package.INFO_RESPONSE]):
            return _info(package.InfoResponse.Deserialize(payload))
        if kind == bytes([package.DEVICE_NOTIFICATION]):
            return _report(package, payload)
    except struct.error as error:
        raise ValueError("the message is incomplete") from error
    return None


def ask() -> bytes:
    """Ask a device what it is."""
    return _written("InfoRequest")


def report_every(milliseconds: int) -> bytes:
    """Let a device report by itself."""
    return _written("DeviceNotificationRequest", milliseconds)


def drive(left: int, right: int, degrees: int) -> bytes:
    """Turn both wheels, until the faster one has turned by some degrees.

    Args:
        left: % of the full speed, forward positive.
        right: the same for the right wheel.
        degrees: more than 0.
    """
    return _written("MovementMoveTankForDegreesCommand", degrees, left, right)


def stop() -> bytes:
    """Stop both wheels."""
    return _written("MovementStopCommand")


def brake_and_hurry() -> bytes:
    """Let both wheels brake at the end of a movement, and change their speed at once."""
    brake = _package().MOTOR_END_STATE_BRAKE
    return _written("MovementSetEndStateCommand", brake) + _written(
        "MovementSetAccelerationCommand", 100, 100
    )


def begin_arm(speed: int) -> bytes:
    """Let the only motor count from here, and turn at a speed in %."""
    return _written("MotorResetRelativePositionCommand", LEFT, 0) + _written(
        "MotorSetSpeedCommand", LEFT, speed
    )


def turn_to(degrees: int) -> bytes:
    """Turn the only motor to a number of degrees from where it was at the beginning."""
    return _written("MotorRunToRelativePositionCommand", LEFT, degrees)


def light(colour: int, intensity: int) -> bytes:
    """Show one of LEGO's colours on the button, -1 for none, at an intensity in %."""
    return _written("LightColorCommand", colour, _package().LIGHT_PATTERN_SOLID, intensity)


def beep(hertz: int) -> bytes:
    """Play a short tone."""
    return _written("PlayBeepCommand", _package().SOUND_PATTERN_BEEP_SINGLE, hertz, 0)


def silence() -> bytes:
    """End a tone."""
    return _written("StopSoundCommand")


def _info(answer: Any) -> Info:
    return Info(answer.productGroupDevice, (answer.rpcMajor, answer.rpcMinor, answer.rpcBuild))


def _report(package: Any, payload: bytes) -> KitReport:
    """The report in a notification, which consists of a number of items of fixed sizes."""
    (length,) = struct.unpack_from("<H", payload)
    items = payload[2 : 2 + length]
    if len(items) < length:
        raise ValueError("the report is incomplete")
    values: dict[str, Any] = {}
    kinds = {
        package.INFO_DEVICE_NOTIFICATION: package.InfoDeviceNotification,
        package.IMU_DEVICE_NOTIFICATION: package.ImuDeviceNotification,
        package.CARD_NOTIFICATION: package.CardNotification,
        package.BUTTON_STATE_NOTIFICATION: package.ButtonStateNotification,
        package.MOTOR_NOTIFICATION: package.MotorNotification,
        package.COLOR_SENSOR_NOTIFICATION: package.ColorSensorNotification,
        package.CONTROLLER_NOTIFICATION: package.ControllerNotification,
        package.IMU_GESTURE_NOTIFICATION: package.ImuGestureNotification,
    }
    # Not the package's own loop, which prints what it does not know.
    while items and items[0] in kinds:
        kind = kinds[items[0]]
        values |= _measured(kind.Deserialize(items[1:]))
        items = items[1 + struct.calcsize(kind.FormatString) :]
    return KitReport(**values)


def _measured(item: Any) -> dict[str, float]:
    """What an item of a report says, as `KitReport` calls it."""
    values: dict[str, float] = {}
    match type(item).__name__:
        case "InfoDeviceNotification":
            values = {"battery": item.batteryLevel}
        case "ImuDeviceNotification":
            # In tenths of a degree.
            values = {"yaw": item.yaw / 10}
        case "MotorNotification":
            values = {"right" if item.motorBitMask == RIGHT else "left": item.position}
        case "ColorSensorNotification":
            values = {"reflection": item.reflection}
        case "ControllerNotification":
            values = {"left_lever": item.leftPercent, "right_lever": item.rightPercent}
    return values


def _written(name: str, *values: int) -> bytes:
    return bytes(getattr(_package(), name)(*values).Serialize())


def _package() -> Any:
    return require("legoeducation.rpc_message", "legoed")
