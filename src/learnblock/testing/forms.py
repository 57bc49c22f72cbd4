"""Checks readings against the form of their type of sensor, and makes those of a quiet robot."""

from collections.abc import Sequence
from copy import deepcopy
from typing import Any

from learnblock.devices import DEVICE_TYPES, Camera, Sensor
from learnblock.devices.readings import is_number


def has_form(sensor: Sensor[Any], reading: Any) -> bool:
    """Whether a reading has the right form and range for its type of sensor."""
    try:
        if isinstance(sensor, Camera):
            return _is_frame(reading)
        return sensor.form is None or sensor.form.fits(reading)
    except (AttributeError, TypeError):
        # For example, a number has no length, and a text has no keys.
        return False


def quiet_readings() -> dict[type[Sensor[Any]], Any]:
    """Readings without obstacles, on a bright floor in a dark room, with no button pressed.

    Their sensors do nothing but read.
    """
    return {
        kind: deepcopy(kind.form.quiet)
        for kind in DEVICE_TYPES.values()
        if issubclass(kind, Sensor) and kind.form is not None and kind.form.quiet is not None
    }


def is_pose(value: Any) -> bool:
    """Whether a value is (x mm, y mm, heading in degrees)."""
    return isinstance(value, Sequence) and len(value) == 3 and all(map(is_number, value))


def _is_frame(reading: Any) -> bool:
    return (
        reading is not None
        and reading.dtype == "uint8"
        and reading.ndim == 3
        and reading.shape[2] == 3
    )
