"""The commands for a brick and its state, the same for every connection."""

from typing import NamedTuple

import msgspec


class State(msgspec.Struct, frozen=True):
    """The state of a brick; an unplugged sensor reads None.

    Args:
        left: degrees that the left wheel has turned, forward positive.
        right: the same for the right wheel.
        ultrasonic: the distance in mm; 2550 if nothing is seen.
        colour: reflected light, 0 to 100.
        gyroscope: degrees, clockwise positive, since it was plugged in.
        touch: above 0 while pressed.
        battery: the battery's voltage, V.
    """

    left: float
    right: float
    ultrasonic: float | None = None
    colour: float | None = None
    gyroscope: float | None = None
    touch: float | None = None
    battery: float | None = None


class Look(NamedTuple):
    """Only request the state."""


class Drive(NamedTuple):
    """Turn the wheels at these speeds until the next command: degrees/s, forward positive."""

    left: float
    right: float


class Tone(NamedTuple):
    """Play a tone."""

    hertz: float
    milliseconds: float


class Say(NamedTuple):
    """Speak a text."""

    text: str


class Show(NamedTuple):
    """Show a text on the screen, instead of what was there; an empty one clears it."""

    text: str


Word = Look | Drive | Tone | Say | Show
