"""What is said to a brick, and what it says of itself, whichever way it is reached."""

from typing import NamedTuple

import msgspec

from learnblock.errors import RobotConnectionError


class State(msgspec.Struct, frozen=True):
    """How the brick is; a sensor that is not plugged in reads None.

    Args:
        left: degrees the left wheel has turned, forward positive.
        right: the right wheel likewise.
        ultrasonic: mm; 2550 when nothing is seen.
        colour: reflected light, 0 to 100.
        gyroscope: degrees, clockwise positive, since it was plugged in.
        touch: above 0 while it is pressed.
    """

    left: float
    right: float
    ultrasonic: float | None = None
    colour: float | None = None
    gyroscope: float | None = None
    touch: float | None = None


class Look(NamedTuple):
    """Only its state is asked for."""


class Drive(NamedTuple):
    """Turn the wheels at these speeds, degrees/s, forward positive, until told otherwise."""

    left: float
    right: float


class Tone(NamedTuple):
    """Sound for a while."""

    hertz: float
    milliseconds: float


class Say(NamedTuple):
    """Speak."""

    text: str


Word = Look | Drive | Tone | Say


class NoSuchWayError(RobotConnectionError):
    """Nobody answers on this way to the brick; another way may be open."""


class TakenError(RobotConnectionError):
    """The brick is used by another program."""
