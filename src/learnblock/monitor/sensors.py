"""Single sensor readings, and the units and ranges of the types of devices."""

from collections.abc import Callable, Iterator, Mapping, Sequence
from types import MappingProxyType
from typing import Any

from msgspec import Struct, structs

from learnblock.devices import DEFAULT_KEY, NOTHING_SEEN

Value = float | bool | None

#: In the order of an accelerometer's readings.
_AXES = ("forward", "left", "up")


class Sensor(Struct, frozen=True, omit_defaults=True):
    """A single reading; `QUANTITIES` has the unit and range of its device.

    ``device``, ``key``, ``place`` and ``number`` together identify it.

    Args:
        device: the type of the device, such as ``DistanceSensors``.
        key: the device's key.
        value: None if nothing is measured.
        place: a side, an axis or a button; empty if the device has only one reading.
        number: its number among those with the same `place`, from 1; 0 if there is only one.
    """

    device: str
    key: str
    value: Value
    place: str = ""
    number: int = 0

    def without_value(self) -> "Sensor":
        """The same sensor while nothing is measured."""
        return structs.replace(self, value=None)


class Quantity(Struct, frozen=True):
    """What a type of device measures.

    Args:
        unit: the unit of its values, such as ``mm``; empty if they have none.
        lowest: the smallest usual value.
        highest: the largest usual value.
        digits: the decimals that are shown.
    """

    unit: str
    lowest: float
    highest: float
    digits: int


def sensors_of(device: str, reading: Any, key: str = DEFAULT_KEY) -> Iterator[Sensor]:
    """The single readings of a device.

    Args:
        device: its type; types that are not sensors have no readings.
        reading: the result of its ``read``.
        key: its key.
    """
    if device not in _KINDS or reading is None:
        return
    _, take_apart = _KINDS[device]
    for place, number, value in take_apart(reading):
        yield Sensor(device, key, value, place, number)


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


_KINDS: Mapping[str, tuple[Quantity, Callable[[Any], Iterator[_Single]]]] = {
    "DistanceSensors": (Quantity("mm", 0, NOTHING_SEEN, 0), _lists),
    "GroundSensors": (Quantity("%", 0, 100, 0), _sides),
    "Gyroscope": (Quantity("°", -360, 360, 1), _one),
    "Accelerometer": (Quantity("m/s²", -20, 20, 2), _axes),
    "Bumper": (Quantity("", 0, 1, 1), _one),
    "LightSensor": (Quantity("", 0, 1023, 0), _one),
    "Controller": (Quantity("", 0, 1, 1), _sides),
    "Infrared": (Quantity("", 0, 255, 0), _one),
}
#: What the sensors that are shown as numbers measure, in the order in which they are shown.
QUANTITIES = MappingProxyType({kind: quantity for kind, (quantity, _) in _KINDS.items()})
SENSOR_TYPES = tuple(QUANTITIES)
