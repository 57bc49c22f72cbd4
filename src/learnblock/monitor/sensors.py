"""Single sensor readings, each with its identity, unit and range."""

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

from learnblock.devices import DEFAULT_KEY, NOTHING_SEEN

Value = float | bool | None

#: In the order of an accelerometer's readings.
_AXES = ("forward", "left", "up")


@dataclass(frozen=True, slots=True)
class Sensor:
    """A single reading.

    ``device``, ``key``, ``place`` and ``number`` together identify it.

    Args:
        device: the type of the device, such as ``DistanceSensors``.
        key: the device's key.
        place: a side, an axis or a button; empty if the device has only one reading.
        number: its number among those with the same `place`, from 1; 0 if there is only one.
        value: None if nothing is measured.
        unit: the unit of the value, such as ``mm``; empty if it has none.
        lowest: the smallest usual value.
        highest: the largest usual value.
    """

    device: str
    key: str
    place: str
    number: int
    value: Value
    unit: str
    lowest: float
    highest: float

    def without_value(self) -> "Sensor":
        """The same sensor while nothing is measured."""
        return replace(self, value=None)


@dataclass(frozen=True, slots=True)
class _Quantity:
    """The unit and range of a type of device."""

    unit: str
    lowest: float
    highest: float


def sensors_of(device: str, reading: Any, key: str = DEFAULT_KEY) -> Iterator[Sensor]:
    """The single readings of a device.

    Args:
        device: its type; types that are not sensors have no readings.
        reading: the result of its ``read``.
        key: its key.
    """
    if device not in _QUANTITIES or reading is None:
        return
    quantity, take_apart = _QUANTITIES[device]
    for place, number, value in take_apart(reading):
        yield Sensor(
            device, key, place, number, value, quantity.unit, quantity.lowest, quantity.highest
        )


_Single = tuple[str, int, Value]


def _one(reading: float | bool) -> Iterator[_Single]:  # noqa: FBT001 - a bumper reads True or False
    yield "", 0, reading


def _lists(reading: Mapping[str, Sequence[float]]) -> Iterator[_Single]:
    for side, distances in reading.items():
        for number, distance in enumerate(distances, start=1):
            yield side, number, distance


def _sides(reading: Mapping[str, float | None]) -> Iterator[_Single]:
    # A side without a sensor reads None.
    return ((side, 0, value) for side, value in reading.items() if value is not None)


def _axes(reading: Sequence[float]) -> Iterator[_Single]:
    return ((axis, 0, value) for axis, value in zip(_AXES, reading, strict=True))


_QUANTITIES: Mapping[str, tuple[_Quantity, Callable[[Any], Iterator[_Single]]]] = {
    "DistanceSensors": (_Quantity("mm", 0, NOTHING_SEEN), _lists),
    "GroundSensors": (_Quantity("%", 0, 100), _sides),
    "Gyroscope": (_Quantity("°", -360, 360), _one),
    "Accelerometer": (_Quantity("m/s²", -20, 20), _axes),
    "Bumper": (_Quantity("", 0, 1), _one),
    "LightSensor": (_Quantity("", 0, 1023), _one),
    "Controller": (_Quantity("", 0, 1), _sides),
    "Infrared": (_Quantity("", 0, 255), _one),
}
#: The types of sensors that are shown as numbers, in the order in which they are shown.
SENSOR_TYPES = tuple(_QUANTITIES)
