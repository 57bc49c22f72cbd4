"""A careful look at a real robot: what works, one thing after the other, as a person watches it."""

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

#: What a person answers to a question: yes or no.
Ask = Callable[[str], bool]

#: mm/s, degrees/s and s of the drive: slow and short.
ADVANCE, ROTATION, DRIVE = 50.0, 45.0, 1.0


@dataclass(frozen=True, slots=True)
class Tried:
    """What came of one thing that was tried.

    Args:
        what: the device, ``Type:KEY``.
        works: None where it was left out.
        detail: what it read, what was seen, or what went wrong.
    """

    what: str
    works: bool | None
    detail: str


def try_out(robot: Client, ask: Ask) -> Iterator[Tried]:
    """Try every device of a robot: the sensors first, then, if it may, what moves and shows.

    It asks before it drives, and after each thing that only a person can see.

    Args:
        robot: connected.
        ask: puts a question to whoever watches.
    """
    devices = [(f"{type(device).__name__}:{key}", device) for key, device in robot.devices()]
    for name, device in devices:
        if isinstance(device, Sensor):
            yield _tried(name, partial(_read, robot, device))
    for kind, attempt in _ATTEMPTS.items():
        for name, device in devices:
            if isinstance(device, kind):
                yield _tried(name, partial(attempt, robot, device, ask))


class _LeftOut(Exception):  # noqa: N818 - no error
    """The person did not want it."""


class _Fails(Exception):  # noqa: N818 - a verdict
    """It does not do what it should."""


def _tried(name: str, attempt: Callable[[], str]) -> Tried:
    try:
        return Tried(name, works=True, detail=attempt())
    except _LeftOut as reason:
        return Tried(name, works=None, detail=str(reason))
    except (_Fails, LearnBlockError) as problem:
        return Tried(name, works=False, detail=str(problem))


def _read(robot: Client, sensor: Sensor[Any]) -> str:
    reading = sensor.read()
    for _ in range(20):
        if reading is not None:
            break
        robot.clock.sleep(0.1)
        reading = sensor.read()
    if reading is None and isinstance(sensor, Camera):
        raise _Fails("no picture came within 2 s")
    return described(sensor, reading)


def described(sensor: Sensor[Any], reading: Any) -> str:
    """A reading as a person is told it."""
    if isinstance(sensor, Camera):
        height, width, _ = reading.shape
        return f"a picture of {width} by {height}"
    if isinstance(sensor, Accelerometer):
        return "x {:.1f}, y {:.1f}, z {:.1f} m/s2".format(*reading)
    return str(reading)


def _drive(robot: Client, base: Base, ask: Ask) -> str:
    if not ask("It will drive: forward for a second, back, and turn. Is there room round it?"):
        raise _LeftOut("not driven")
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
    if not ask("Did it drive 5 cm forward and back, then turn to the right and back?"):
        raise _Fails("it moved otherwise: are the motors' ports and signs right in its settings?")
    return _odometry(poses)


def _pose(base: Base) -> tuple[float, float, float] | None:
    read = base.functions.get("read")
    return read() if read else None


def _odometry(poses: list[tuple[float, float, float] | None]) -> str:
    known = [pose for pose in poses if pose is not None]
    if len(known) < len(poses):
        return "drives; it has no odometry"
    ahead = math.dist(known[0][:2], known[1][:2])
    return f"drives; its odometry says {ahead:.0f} mm and {known[3][2] - known[2][2]:.0f} degrees"


def _bend(robot: Client, joint: JointMotor, ask: Ask) -> str:
    joint.move(10)
    robot.clock.sleep(1)
    read = joint.functions.get("read")
    angle = f"it says {read():.0f} degrees" if read else "its angle cannot be read"
    seen = ask("Is the joint a little above the middle (10 degrees)?")
    joint.move(0)
    return _seen(seen, angle)


def _show(robot: Client, display: Display, ask: Ask) -> str:
    display.show_emotion(Emotion.JOY)
    robot.clock.sleep(1)
    seen = ask("Does it show joy?")
    display.show_emotion(Emotion.NEUTRAL)
    return _seen(seen, "shows joy")


def _light(robot: Client, led: Led | RGBLed, ask: Ask) -> str:
    del robot
    _switch(led, on=True)
    seen = ask("Is this lamp lit (red, where it has colours)?")
    _switch(led, on=False)
    return _seen(seen, "lights")


def _switch(led: Led | RGBLed, *, on: bool) -> None:
    if isinstance(led, RGBLed):
        led.set_color(255 if on else 0, 0, 0)
    else:
        led.set(on)


def _sound(robot: Client, speaker: Speaker, ask: Ask) -> str:
    del robot
    if not speaker.tone(440, 500):
        return "cannot play tones"
    return _seen(ask("Did it beep?"), "beeps")


def _seen(seen: bool, detail: str) -> str:  # noqa: FBT001 - it was seen or it was not
    if not seen:
        raise _Fails("not seen")
    return detail


#: In this order: what drives comes last.
_ATTEMPTS: dict[type[Device], Callable[[Client, Any, Ask], str]] = {
    JointMotor: _bend,
    Display: _show,
    Led: _light,
    RGBLed: _light,
    Speaker: _sound,
    Base: _drive,
}
