"""The devices of robots, and the units they use.

A device is built from the functions that access the hardware, so those functions are all that a
new robot has to provide:

    >>> from learnblock.devices import Gyroscope
    >>> gyroscope = Gyroscope(read=lambda: 90.0, reset=lambda: None)
    >>> gyroscope.read()
    90.0

All devices use these units and signs: millimetres and mm/s (forward is positive), degrees and
degrees/s (clockwise seen from above, a turn to the right, is positive), seconds, and images as
uint8 RGB arrays of shape (height, width, 3).
"""

from collections.abc import Mapping
from types import MappingProxyType, ModuleType

from learnblock.devices import actuators, sensors
from learnblock.devices.actuators import *
from learnblock.devices.device import *
from learnblock.devices.readings import Form
from learnblock.devices.sensors import *
from learnblock.devices.values import *


def _defined_in(module: ModuleType) -> dict[str, type[Device]]:
    return {
        name: kind
        for name, kind in vars(module).items()
        if isinstance(kind, type)
        and issubclass(kind, Device)
        and kind.__module__ == module.__name__
    }


_SENSORS = _defined_in(sensors)
#: Every type of device, by its name.
DEVICE_TYPES: Mapping[str, type[Device]] = MappingProxyType(
    dict(sorted({**_SENSORS, **_defined_in(actuators)}.items()))
)
#: What the readings of each type of sensor look like, in the order in which the page shows them.
FORMS: Mapping[str, Form] = MappingProxyType(
    {
        name: kind.form
        for name, kind in _SENSORS.items()
        if issubclass(kind, Sensor) and kind.form is not None
    }
)
