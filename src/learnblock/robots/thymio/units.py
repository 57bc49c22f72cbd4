"""Converts the Thymio's numbers to our units.

Sources: Aseba's documentation of the robot's programming interface, and measurements in Aseba's
playground, whose sensors were fitted to real robots (`benchmarks/robots_thymio.py` repeats them).
"""

from collections.abc import Mapping, Sequence

import numpy as np

from learnblock.devices import NOTHING_SEEN
from learnblock.errors import DeviceValueError, nearest
from learnblock.wheels import Drivetrain

#: The largest motor speed.
FASTEST = 500
#: The accelerometer's reading for 1 g, and 1 g in m/s2.
ACC_PER_G = 23
GRAVITY = 9.81
#: The highest level of a lamp.
BRIGHTEST = 32
#: The duration of a tone is in sixtieths of a second.
TICKS_PER_SECOND = 60
#: The largest 16-bit number.
LARGEST = 32767
#: The robot's built-in sounds, by their purpose.
SOUNDS: Mapping[str, int] = {
    "startup": 0,
    "shutdown": 1,
    "arrow": 2,
    "center": 3,
    "freefall": 4,
    "collision": 5,
    "friendly": 6,
    "detected": 7,
}
#: The built-in sound that is played for an effect: it can't play several tones in a row.
EFFECT_SOUNDS: Mapping[str, str] = {
    "pop": "arrow",
    "coin": "friendly",
    "jump": "arrow",
    "boing": "freefall",
    "laser": "detected",
    "crash": "collision",
    "magic": "friendly",
    "alarm": "detected",
    "bell": "center",
    "power up": "startup",
    "win": "friendly",
    "lose": "shutdown",
}
#: (a distance sensor's reading, mm to a white wall in front of it): the medians of twelve readings
#: in the playground, which vary by half a percent. There, nothing is seen beyond 140 mm; the last
#: line continues the curve for real robots, which see further.
PROXIMITY: tuple[tuple[int, float], ...] = (
    (4504, 0.0),
    (4491, 5.0),
    (4448, 10.0),
    (4374, 15.0),
    (4280, 20.0),
    (4019, 30.0),
    (3704, 40.0),
    (3364, 50.0),
    (3028, 60.0),
    (2705, 70.0),
    (2408, 80.0),
    (2144, 90.0),
    (1908, 100.0),
    (1700, 110.0),
    (1520, 120.0),
    (1360, 130.0),
    (1220, 140.0),
)
# numpy requires increasing values.
_FALLING, _RISING = [-reading for reading, _ in PROXIMITY], [mm for _, mm in PROXIMITY]


def wheels(adv: float, rot: float, *, track: float, unit: float) -> tuple[int, int]:
    """Motor speeds, left and right, -500 to 500.

    Args:
        adv: mm/s, forward positive.
        rot: degrees/s, clockwise positive.
        track: mm between the wheels.
        unit: mm/s of a wheel at motor speed 1.

    Returns:
        Both speeds, reduced by the same factor if one is too fast, so that the curve is unchanged.
    """
    left, right = drivetrain(track, unit).wheels(adv, rot)
    return round(left / unit), round(right / unit)


def drivetrain(track: float, unit: float) -> Drivetrain:
    """What the wheels can do, with the arguments of `wheels`."""
    return Drivetrain(track, FASTEST * unit)


def distance(reading: int) -> float:
    """The distance in mm for a sensor's reading, at most 140; 2000 if it sees nothing."""
    if reading <= 0:
        return NOTHING_SEEN
    return float(np.interp(-reading, _FALLING, _RISING))


def distances(readings: Sequence[int]) -> dict[str, list[float]]:
    """The distances in mm on each side; a sensor between two sides is listed on both."""
    left, left_front, front, right_front, right, back_left, back_right = map(distance, readings)
    return {
        "front": [left_front, front, right_front],
        "left": [left, left_front],
        "right": [right_front, right],
        "back": [back_left, back_right],
    }


def ground(deltas: Sequence[int]) -> dict[str, float | None]:
    """The floor's brightness, 0 to 100; there is no sensor in the middle."""
    left, right = (min(max(delta / 10, 0.0), 100.0) for delta in deltas)
    return {"left": left, "central": None, "right": right}


def acceleration(readings: Sequence[int]) -> tuple[float, float, float]:
    """(x forward, y left, z up) in m/s2; at rest z is 9.81.

    The robot reports the direction of gravity: left, rear and down are positive. An accelerometer
    measures the opposite force, which supports the robot.
    """
    to_left, to_rear, down = (reading / ACC_PER_G * GRAVITY for reading in readings)
    # Not `-to_left`, which would turn 0 into -0.0.
    return to_rear, 0 - to_left, down


def level(value: int) -> int:
    """A lamp's level from 0 to 32 for a brightness from 0 to 255."""
    return round(value * BRIGHTEST / 255)


def tone(hertz: float, milliseconds: float) -> tuple[int, int]:
    """The arguments of the robot's function for tones; 0 milliseconds stops a tone."""
    ticks = round(milliseconds * TICKS_PER_SECOND / 1000)
    # For the robot, 0 means forever and -1 means silence.
    lasting = min(max(ticks, 1), LARGEST) if milliseconds > 0 else -1
    return min(max(round(hertz), 0), LARGEST), lasting


def sound(name: str) -> int:
    """The number of one of the robot's sounds, or of the one that is nearest to an effect.

    Raises:
        DeviceValueError: the robot has no such sound.
    """
    name = EFFECT_SOUNDS.get(name, name)
    if name in SOUNDS:
        return SOUNDS[name]
    suggestion = nearest(name, [*SOUNDS, *EFFECT_SOUNDS])
    if suggestion is None:
        raise DeviceValueError("thymio-unknown-sound", name=name, known=tuple(SOUNDS))
    raise DeviceValueError("thymio-unknown-sound-like", name=name, suggestion=suggestion)
