"""Single sensor readings, and the units and ranges of the types of devices."""

from collections.abc import Iterator
from types import MappingProxyType
from typing import Any

from msgspec import Struct, structs

from learnblock.devices import DEFAULT_KEY, FORMS
from learnblock.devices.readings import Value


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
    if device not in FORMS or reading is None:
        return
    for place, number, value in FORMS[device].singles(reading):
        yield Sensor(device, key, value, place, number)


#: What the sensors that are shown as numbers measure, in the order in which they are shown.
QUANTITIES = MappingProxyType(
    {
        kind: Quantity(form.unit, form.lowest, form.highest, form.digits)
        for kind, form in FORMS.items()
    }
)
SENSOR_TYPES = tuple(FORMS)
