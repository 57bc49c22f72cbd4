"""The devices of simulated robots: one function for each type, built from a body in the world."""

from collections.abc import Callable
from functools import partial

from learnblock.devices import (
    MP3,
    Accelerometer,
    Animator,
    Base,
    Bumper,
    Camera,
    Device,
    Display,
    DistanceSensors,
    GroundSensors,
    Gyroscope,
    Infrared,
    JointMotor,
    Led,
    LightSensor,
    Matrix,
    RGBLed,
    Speaker,
)
from learnblock.simulator import RobotBody


def make_device(body: RobotBody, kind: str, key: str) -> Device:
    """The device with this type and key, such as ``Camera`` and ``ROBOT``."""
    return _MAKERS[kind](body, key)


def _base(body: RobotBody, _key: str) -> Base:
    return Base(move=body.drive, read=lambda: body.pose)


def _logged(body: RobotBody, device: str, action: str) -> Callable[..., None]:
    return partial(body.note, device, action)


def _speaker(body: RobotBody, _key: str) -> Speaker:
    note = partial(_logged, body, "Speaker")
    return Speaker(say=note("say"), play=note("play"), tone=note("tone"))


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


def _joint(body: RobotBody, key: str) -> JointMotor:
    return JointMotor(move=partial(body.set_joint, key), read=partial(body.joint, key))


_MAKERS: dict[str, Callable[[RobotBody, str], Device]] = {
    "Accelerometer": lambda body, _: Accelerometer(body.acceleration),
    "Animator": lambda body, _: Animator(_logged(body, "Animator", "play")),
    "Base": _base,
    "Bumper": lambda body, _: Bumper(body.bumper),
    "Camera": lambda body, key: Camera(partial(body.frame, key), drawn=True, focal=body.focal(key)),
    "Display": lambda body, _: Display(show_emotion=body.show_emotion),
    "DistanceSensors": lambda body, _: DistanceSensors(body.distances),
    "GroundSensors": lambda body, _: GroundSensors(body.ground),
    "Gyroscope": lambda body, _: Gyroscope(body.gyroscope, body.reset_gyroscope),
    "Infrared": lambda body, _: Infrared(lambda: None, _logged(body, "Infrared", "send")),
    "JointMotor": _joint,
    "Led": _led,
    "LightSensor": lambda body, _: LightSensor(body.light),
    "MP3": _mp3,
    "Matrix": _matrix,
    "RGBLed": _rgb_led,
    "Speaker": _speaker,
}
