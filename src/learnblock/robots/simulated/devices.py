"""The devices of simulated robots: one function for each type, built from a body in the world."""

from collections.abc import Callable
from functools import partial, wraps
from typing import Any

from learnblock.devices import (
    DEVICE_TYPES,
    MP3,
    Animator,
    Base,
    Camera,
    Device,
    Display,
    Gyroscope,
    Infrared,
    JointMotor,
    Led,
    Matrix,
    Pen,
    RGBLed,
    Screen,
    Speaker,
)
from learnblock.senses import ABILITIES
from learnblock.simulator import RobotBody
from learnblock.simulator.robot_body import READINGS

#: What every robot has in a world, even if the real one does not.
WORLD_DEVICES = ("Pen:ROBOT", "Screen:ROBOT")
# Why: docs/decisions.md, "The last digits of a computer stay inside the simulator"
#: Decimals of every reading: the last digits of sines differ between computers.
DECIMALS = 3


def make_device(body: RobotBody, kind: str, key: str) -> Device:
    """The device with this type and key, such as ``Camera`` and ``ROBOT``."""
    maker = _MAKERS.get(kind)
    return maker(body, key) if maker else _sensor(body, kind)


def _sensor(body: RobotBody, kind: str) -> Device:
    """A sensor that can only be read."""
    return DEVICE_TYPES[kind](read=_reading(partial(READINGS[kind], body)))


def _reading(read: Callable[[], Any]) -> Callable[[], Any]:
    @wraps(read)
    def rounded() -> Any:
        return _rounded(read())

    return rounded


def _rounded(value: Any) -> Any:
    if isinstance(value, float):
        # The zero makes -0.0 a plain zero.
        return round(value, DECIMALS) + 0.0
    if isinstance(value, dict):
        return {key: _rounded(item) for key, item in value.items()}
    if isinstance(value, list):
        # Most readings are lists of numbers.
        return [
            round(item, DECIMALS) + 0.0 if type(item) is float else _rounded(item) for item in value
        ]
    return tuple(map(_rounded, value)) if isinstance(value, tuple) else value


def _base(body: RobotBody, _key: str) -> Base:
    wheels = body.description.wheels
    read = _reading(lambda: body.odometry) if wheels.encoders else None
    return Base(body.drive, read, wheels.drivetrain)


def _logged(body: RobotBody, device: str, action: str) -> Callable[..., None]:
    return partial(body.note, device, action)


def _speaker(body: RobotBody, _key: str) -> Speaker:
    able = body.description.abilities()
    actions = [action for action in ABILITIES["Speaker"] if f"Speaker:{action}" in able]
    return Speaker(**{action: _logged(body, "Speaker", action) for action in actions})


def _matrix(body: RobotBody, _key: str) -> Matrix:
    note = partial(_logged, body, "Matrix")
    return Matrix(icon=note("icon"), number=note("number"), text=note("text"))


def _mp3(body: RobotBody, _key: str) -> MP3:
    note = partial(_logged, body, "MP3")
    return MP3(
        select=note("select"),
        action=note("action"),
        volume=note("volume"),
        equalizer=note("equalizer"),
        loop=note("loop"),
    )


def _led(body: RobotBody, key: str) -> Led:
    return Led(set=lambda on: body.set_led(key, (255, 255, 255) if on else (0, 0, 0)))


def _rgb_led(body: RobotBody, key: str) -> RGBLed:
    return RGBLed(set_color=lambda red, green, blue: body.set_led(key, (red, green, blue)))


def _pen(body: RobotBody, _key: str) -> Pen:
    pen = body.pen
    return Pen(set=pen.set, set_color=pen.set_color, set_width=pen.set_width, clear=pen.clear)


def _joint(body: RobotBody, key: str) -> JointMotor:
    return JointMotor(move=partial(body.set_joint, key), read=_reading(partial(body.joint, key)))


_MAKERS: dict[str, Callable[[RobotBody, str], Device]] = {
    "Animator": lambda body, _: Animator(_logged(body, "Animator", "play")),
    "Base": _base,
    "Camera": lambda body, key: Camera(partial(body.frame, key), drawn=True, focal=body.focal(key)),
    "Display": lambda body, _: Display(show_emotion=body.show_emotion),
    "Gyroscope": lambda body, _: Gyroscope(_reading(body.gyroscope), body.reset_gyroscope),
    "Infrared": lambda body, _: Infrared(lambda: None, _logged(body, "Infrared", "send")),
    "JointMotor": _joint,
    "Led": _led,
    "MP3": _mp3,
    "Matrix": _matrix,
    "Pen": _pen,
    "RGBLed": _rgb_led,
    "Screen": lambda body, _: Screen(body.show_text),
    "Speaker": _speaker,
}
