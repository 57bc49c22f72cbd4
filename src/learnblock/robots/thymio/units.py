"""What the Thymio's numbers mean in our units.

Sources: the robot's programming interface as Aseba documents it, and measurements in Aseba's
playground, whose sensors were fitted to real robots (`benchmarks/robots_thymio.py` repeats them).
"""

from collections.abc import Mapping, Sequence

import numpy as np

from learnblock.devices import NOTHING_SEEN
from learnblock.errors import DeviceValueError, did_you_mean
from learnblock.wheels import limited, wheel_speeds

#: The most that a motor may be told.
FASTEST = 500
#: What the accelerometer reads for 1 g, and that in m/s2.
ACC_PER_G = 23
GRAVITY = 9.81
#: Levels of a lamp.
BRIGHTEST = 32
#: A tone lasts as many sixtieths of a second.
TICKS_PER_SECOND = 60
#: Numbers of 16 bits.
LARGEST = 32767
#: The sounds in the robot, by what it uses them for itself.
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
#: (what a distance sensor reads, mm to a white wall across its direction), the medians of twelve
#: readings in the playground, which vary by half a percent. Beyond 140 mm it reads nothing at all
#: there; the last line continues the curve, for real robots that read on.
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
# numpy wants what it looks up in rising order.
_FALLING, _RISING = [-reading for reading, _ in PROXIMITY], [mm for _, mm in PROXIMITY]


def wheels(adv: float, rot: float, *, track: float, unit: float) -> tuple[int, int]:
    """Motor speeds, left and right, -500 to 500.

    Args:
        adv: mm/s, forward positive.
        rot: degrees/s, clockwise positive.
        track: mm between the wheels.
        unit: mm/s of a wheel at motor speed 1.

    Returns:
        Both reduced alike where a wheel would have to run faster than it can, so that the curve
        stays the same.
    """
    left, right = limited(wheel_speeds(adv, rot, track), FASTEST * unit)
    return round(left / unit), round(right / unit)


def distance(reading: int) -> float:
    """The mm to what a distance sensor sees, 140 at most; 2000 where it sees nothing."""
    if reading <= 0:
        return NOTHING_SEEN
    return float(np.interp(-reading, _FALLING, _RISING))


def distances(readings: Sequence[int]) -> dict[str, list[float]]:
    """The mm on each side, from left to right; a sensor between two sides counts for both."""
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

    The robot shows where gravity pulls: to its left, to its rear and down are positive. What holds
    it against gravity, which is what an accelerometer feels, points the other way.
    """
    to_left, to_rear, down = (reading / ACC_PER_G * GRAVITY for reading in readings)
    # Not its negative: that of 0 would be shown as -0.0.
    return to_rear, 0 - to_left, down


def level(value: int) -> int:
    """A lamp's brightness, 0 to 255, as 0 to 32."""
    return round(value * BRIGHTEST / 255)


def tone(hertz: float, milliseconds: float) -> tuple[int, int]:
    """What the robot's function for tones takes; no time at all makes it silent."""
    ticks = round(milliseconds * TICKS_PER_SECOND / 1000)
    # To the robot 0 means for ever, and -1 silence.
    lasting = min(max(ticks, 1), LARGEST) if milliseconds > 0 else -1
    return min(max(round(hertz), 0), LARGEST), lasting


def sound(name: str) -> int:
    """The number of one of the robot's sounds.

    Raises:
        DeviceValueError: it has no such sound.
    """
    if name not in SOUNDS:
        hint = did_you_mean(name, SOUNDS) or "known are: " + ", ".join(SOUNDS)
        raise DeviceValueError(
            f"a Thymio has no sound {name!r}; {hint}; a number plays a file of its memory card"
        )
    return SOUNDS[name]
