"""The form of the readings of each type of sensor, the same on every robot, and quiet ones."""

import math
from collections.abc import Callable, Mapping, Sequence
from typing import Any

from learnblock.devices import (
    NOTHING_SEEN,
    Accelerometer,
    Bumper,
    Camera,
    Controller,
    Device,
    DistanceSensors,
    GroundSensors,
    Gyroscope,
    Infrared,
    LightSensor,
    Sensor,
)

_BUTTONS = ("lUp", "lLeft", "lRight", "lDown", "rUp", "rLeft", "rRight", "rDown")


def has_form(sensor: Sensor[Any], reading: Any) -> bool:
    """Whether a reading has the right form and range for its type of sensor."""
    form = _FORMS.get(type(sensor))
    try:
        return form is None or form(reading)
    except (AttributeError, TypeError):
        # For example, a number has no length, and a text has no keys.
        return False


def quiet_readings() -> dict[type[Sensor[Any]], Any]:
    """Readings without obstacles, on a bright floor in a dark room, with no button pressed.

    Their sensors do nothing but read.
    """
    return {
        Accelerometer: (0.0, 0.0, 9.81),
        Bumper: False,
        Controller: dict.fromkeys(_BUTTONS, False),
        DistanceSensors: {side: [NOTHING_SEEN] for side in ("front", "left", "right", "back")},
        GroundSensors: {"left": 100.0, "central": 100.0, "right": 100.0},
        LightSensor: 0.0,
    }


def is_pose(value: Any) -> bool:
    """Whether a value is (x mm, y mm, heading in degrees)."""
    return isinstance(value, Sequence) and len(value) == 3 and all(map(is_number, value))


def is_number(value: object, least: float = -math.inf, most: float = math.inf) -> bool:
    """Whether a value is a finite number from `least` to `most`."""
    return (
        isinstance(value, int | float)
        and not isinstance(value, bool)
        and math.isfinite(value)
        and least <= value <= most
    )


def _are_distances(reading: Any) -> bool:
    return set(reading) <= {"front", "left", "right", "back"} and all(
        is_number(value, 0, NOTHING_SEEN) for several in reading.values() for value in several
    )


def _are_grounds(reading: Any) -> bool:
    return set(reading) <= {"left", "central", "right"} and all(
        value is None or is_number(value, 0, 100) for value in reading.values()
    )


def _is_frame(reading: Any) -> bool:
    return (
        reading is not None
        and reading.dtype == "uint8"
        and reading.ndim == 3
        and reading.shape[2] == 3
    )


_FORMS: Mapping[type[Device], Callable[[Any], bool]] = {
    Accelerometer: lambda reading: len(reading) == 3 and all(map(is_number, reading)),
    Bumper: lambda reading: isinstance(reading, bool),
    Camera: _is_frame,
    Controller: lambda reading: all(isinstance(value, bool) for value in reading.values()),
    DistanceSensors: _are_distances,
    GroundSensors: _are_grounds,
    Gyroscope: is_number,
    Infrared: lambda reading: reading is None or isinstance(reading, int),
    LightSensor: lambda reading: is_number(reading, 0, 1023),
}
