"""Test every device of a real robot while a person watches."""

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import partial
from typing import Any

from learnblock.client import Client
from learnblock.devices import (
    Accelerometer,
    Base,
    Camera,
    Device,
    Display,
    Emotion,
    JointMotor,
    Led,
    RGBLed,
    Sensor,
    Speaker,
)
from learnblock.errors import LearnBlockError
from learnblock.i18n import Phrase

#: A person's answer to a question: yes or no.
Ask = Callable[[Phrase], bool]

#: mm/s, degrees/s and s of the drive: slow and short.
ADVANCE, ROTATION, DRIVE = 50.0, 45.0, 1.0


@dataclass(frozen=True, slots=True)
class Tried:
    """The result of testing one device.

    Args:
        what: the device, ``Type:KEY``.
        works: None if it was left out.
        detail: its reading, what was seen, or what went wrong.
    """

    what: str
    works: bool | None
    detail: Phrase


def try_out(robot: Client, ask: Ask) -> Iterator[Tried]:
    """Test every device of a robot: first the sensors, then displays and motors.

    It asks before it drives, and after everything that only a person can check.

    Args:
        robot: a connected robot.
        ask: asks the person.
    """
    devices = [(f"{type(device).__name__}:{key}", device) for key, device in robot.devices()]
    for name, device in devices:
        if isinstance(device, Sensor):
            yield _tried(name, partial(_read, robot, device))
    for kind, attempt in _ATTEMPTS.items():
        for name, device in devices:
            if isinstance(device, kind):
                yield _tried(name, partial(attempt, robot, device, ask))


class _LeftOut(Exception):  # noqa: N818 - a result
    """The person declined the test."""


def _tried(name: str, attempt: Callable[[], Phrase]) -> Tried:
    try:
        return Tried(name, works=True, detail=attempt())
    except _LeftOut:
        return Tried(name, works=None, detail=Phrase("testing-not-driven"))
    except LearnBlockError as problem:
        return Tried(name, works=False, detail=problem.phrase)


def _read(robot: Client, sensor: Sensor[Any]) -> Phrase:
    reading = sensor.read()
    for _ in range(20):
        if reading is not None:
            break
        robot.clock.sleep(0.1)
        reading = sensor.read()
    if reading is None and isinstance(sensor, Camera):
        raise LearnBlockError("testing-no-picture")
    return _describe(sensor, reading)


def _describe(sensor: Sensor[Any], reading: Any) -> Phrase:
    """A reading as text."""
    if isinstance(sensor, Camera):
        height, width, _ = reading.shape
        return Phrase("testing-picture", width=width, height=height)
    if isinstance(sensor, Accelerometer):
        x, y, z = (round(float(axis), 1) for axis in reading)
        return Phrase("testing-acceleration", x=x, y=y, z=z)
    return Phrase("testing-reading", reading=str(reading))


def _drive(robot: Client, base: Base, ask: Ask) -> Phrase:
    if not ask(Phrase("testing-ask-room")):
        raise _LeftOut
    legs = ((ADVANCE, 0.0), (-ADVANCE, 0.0), (0.0, ROTATION), (0.0, -ROTATION))
    poses = [_pose(base)]
    try:
        for adv, rot in legs:
            base.move(adv, rot)
            robot.clock.sleep(DRIVE)
            base.stop()
            robot.clock.sleep(DRIVE / 2)
            poses.append(_pose(base))
    finally:
        base.stop()
    if not ask(Phrase("testing-ask-driven")):
        raise LearnBlockError("testing-moved-otherwise")
    return _odometry(poses)


def _pose(base: Base) -> tuple[float, float, float] | None:
    return base.pose() if base.has_odometry else None


def _odometry(poses: list[tuple[float, float, float] | None]) -> Phrase:
    readings = [pose for pose in poses if pose is not None]
    if len(readings) < len(poses):
        return Phrase("testing-drives")
    ahead = math.dist(readings[0][:2], readings[1][:2])
    turned = readings[3][2] - readings[2][2]
    return Phrase("testing-drives-by-odometry", distance=round(ahead), angle=round(turned))


def _bend(robot: Client, joint: JointMotor, ask: Ask) -> Phrase:
    joint.move(10)
    robot.clock.sleep(1)
    read = joint.functions.get("read")
    angle = Phrase("testing-angle", angle=round(read())) if read else Phrase("testing-no-angle")
    is_visible = ask(Phrase("testing-ask-joint"))
    joint.move(0)
    return _require(is_visible, angle)


def _show(robot: Client, display: Display, ask: Ask) -> Phrase:
    display.show_emotion(Emotion.JOY)
    robot.clock.sleep(1)
    is_visible = ask(Phrase("testing-ask-joy"))
    display.show_emotion(Emotion.NEUTRAL)
    return _require(is_visible, Phrase("testing-shows-joy"))


def _light(robot: Client, led: Led | RGBLed, ask: Ask) -> Phrase:
    del robot
    _switch(led, on=True)
    is_visible = ask(Phrase("testing-ask-light"))
    _switch(led, on=False)
    return _require(is_visible, Phrase("testing-lights"))


def _switch(led: Led | RGBLed, *, on: bool) -> None:
    if isinstance(led, RGBLed):
        led.set_color(255 if on else 0, 0, 0)
    else:
        led.set(on)


def _sound(robot: Client, speaker: Speaker, ask: Ask) -> Phrase:
    del robot
    if not speaker.tone(440, 500):
        return Phrase("testing-no-tones")
    return _require(ask(Phrase("testing-ask-beep")), Phrase("testing-beeps"))


def _require(is_visible: bool, detail: Phrase) -> Phrase:  # noqa: FBT001 - a yes or a no
    if not is_visible:
        raise LearnBlockError("testing-not-seen")
    return detail


#: In this order, so that the robot drives last.
_ATTEMPTS: dict[type[Device], Callable[[Client, Any, Ask], Phrase]] = {
    JointMotor: _bend,
    Display: _show,
    Led: _light,
    RGBLed: _light,
    Speaker: _sound,
    Base: _drive,
}
