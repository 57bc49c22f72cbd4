"""What a person has a robot do without a program: short tests, and drives to measure."""

import math
import threading
from collections.abc import Callable, Mapping
from typing import Any, TypeVar

from learnblock.client import Client
from learnblock.devices import Base, Device, Display, Emotion, Led, RGBLed, Speaker
from learnblock.errors import RobotConnectionError
from learnblock.robots.calibration import ANGLE, DISTANCE
from learnblock.robots.real import RealRobot

D = TypeVar("D", bound=Device)

#: mm/s and s of the test of the wheels: 50 mm forward and back.
TEST_SPEED, TEST_TIME = 50.0, 1.0
#: mm/s and degrees/s of a drive that is measured.
MEASURED_SPEED, MEASURED_ROTATION = 100.0, 60.0
#: Seconds for which a face or lamps are shown.
SHOWN = 1.5
#: Seconds after which the wheels must have brought the robot where it believes to be going,
#: as a multiple of the time that it should take.
PATIENCE = 3.0
#: Seconds between two looks at pose and link.
LOOK = 0.02
#: Hz and milliseconds of a beep.
BEEP = (880.0, 300.0)
LIT = (255, 160, 0)


class InterruptedActionError(Exception):
    """The action was halted."""


class Hands:
    """A robot in the hands of a person, who can halt it at any moment.

    Args:
        client: the connected robot.
        halting: set to interrupt what the robot is doing.
    """

    def __init__(self, client: Client, halting: threading.Event) -> None:
        self.client = client
        self._halting = halting

    def devices(self, kind: type[D]) -> list[D]:
        """The robot's devices of a type."""
        return [device for _, device in self.client.devices() if isinstance(device, kind)]

    def wait(self, seconds: float) -> None:
        """Wait.

        Raises:
            InterruptedActionError: the action was halted.
            RobotConnectionError: the link to the robot broke.
        """
        clock = self.client.clock
        until = clock.time() + seconds
        while (remaining := until - clock.time()) > 0:
            if self._halting.is_set():
                raise InterruptedActionError
            self.client.require_link()
            clock.sleep(min(LOOK, remaining))


Action = Callable[[Hands], None]


def wheels(hands: Hands) -> None:
    """Drive 50 mm forward and back."""
    base = hands.devices(Base)[0]
    for speed in (TEST_SPEED, -TEST_SPEED):
        base.move(speed, 0)
        hands.wait(TEST_TIME)
    base.stop()


def face(hands: Hands) -> None:
    """Show joy for a moment."""
    screens = hands.devices(Display)
    for screen in screens:
        screen.show_emotion(Emotion.JOY)
    hands.wait(SHOWN)
    for screen in screens:
        screen.show_emotion(Emotion.NEUTRAL)


def lamps(hands: Hands) -> None:
    """Light all lamps for a moment."""
    _light(hands, on=True)
    hands.wait(SHOWN)
    _light(hands, on=False)


def beep(hands: Hands) -> None:
    """Play a short tone."""
    hands.devices(Speaker)[0].tone(*BEEP)
    hands.wait(BEEP[1] / 1000)


def distance(hands: Hands) -> None:
    """Drive 500 mm by the robot's own measure."""
    base = hands.devices(Base)[0]
    x, y, _ = base.pose()
    base.move(MEASURED_SPEED, 0)
    _until(hands, DISTANCE / MEASURED_SPEED, lambda: _gone(base, x, y) >= DISTANCE)


def angle(hands: Hands) -> None:
    """Turn by 360 degrees on the spot by the robot's own measure."""
    base = hands.devices(Base)[0]
    turned, before = 0.0, base.pose()[2]

    def is_round() -> bool:
        nonlocal turned, before
        now = base.pose()[2]
        turned += (now - before + 180) % 360 - 180
        before = now
        return turned >= ANGLE

    base.move(0, MEASURED_ROTATION)
    _until(hands, ANGLE / MEASURED_ROTATION, is_round)


#: Every action by its name.
ACTIONS: Mapping[str, Action] = {
    "wheels": wheels,
    "face": face,
    "lamps": lamps,
    "beep": beep,
    "distance": distance,
    "angle": angle,
}


def possible(client: Client) -> tuple[str, ...]:
    """The names of the actions that a robot can do."""
    offered = [device for _, device in client.devices()]

    def has(*kinds: type[Any]) -> bool:
        return any(isinstance(device, kinds) for device in offered)

    calibrates = isinstance(client, RealRobot) and client.calibration is not None
    can = {
        "wheels": has(Base),
        "face": has(Display),
        "lamps": has(Led, RGBLed) and not has(Display),
        "beep": any(
            isinstance(device, Speaker) and "tone" in device.functions for device in offered
        ),
        "distance": has(Base) and calibrates,
        "angle": has(Base) and calibrates,
    }
    return tuple(name for name in ACTIONS if can[name])


def _gone(base: Base, x: float, y: float) -> float:
    now = base.pose()
    return math.hypot(now[0] - x, now[1] - y)


def _until(hands: Hands, seconds: float, is_there: Callable[[], bool]) -> None:
    """Wait until the robot has arrived.

    Raises:
        RobotConnectionError: it does not arrive.
    """
    deadline = hands.client.clock.time() + seconds * PATIENCE
    while not is_there():
        if hands.client.clock.time() > deadline:
            raise RobotConnectionError("connect-wheels-stuck")
        hands.wait(LOOK)


def _light(hands: Hands, *, on: bool) -> None:
    for lamp in hands.devices(Led):
        lamp.set(on)
    for colored in hands.devices(RGBLed):
        colored.set_color(*(LIT if on else (0, 0, 0)))
