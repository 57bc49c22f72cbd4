"""What a real robot measures, for the log of its run: a simulated world shows that again by itself.

Its pose and its sensors are read in the background, as for the page, whether or not the program
asks for them.
"""

from collections.abc import Callable
from functools import partial
from typing import Any

import msgspec

from learnblock.client import Client
from learnblock.devices import (
    Base,
    Bumper,
    Device,
    DistanceSensors,
    GroundSensors,
    Gyroscope,
    Sensor,
)
from learnblock.runtime.log.keeping import RunLog
from learnblock.runtime.values import plain

#: Seconds between two values of one device that are kept.
PERIOD = 0.1
#: The sensors whose readings are kept.
_SENSORS = (Bumper, DistanceSensors, GroundSensors, Gyroscope)
#: Digits after the point: a tenth of a mm and of a degree.
_DIGITS = 1


def keep_readings(client: Client, log: RunLog) -> None:
    """Keep the pose and the readings of a real robot from now on."""
    for key, device in client.devices():
        if isinstance(device, _SENSORS) or (isinstance(device, Base) and device.has_odometry):
            _keep(client, log, key, device)


def keep_operations(client: Client, log: RunLog) -> None:
    """Keep what the driver calls on the robot by name, for each function of a device once."""
    operations = client.operations
    operations.found = partial(_found, client, log)
    for key, device in client.devices():
        for name, function in device.functions.items():
            of = f"{type(device).__name__}:{key}.{name}"
            device.functions[name] = partial(operations.serve, of, function)
        if isinstance(device, Sensor):
            device.read = device.functions["read"]


def _found(client: Client, log: RunLog, of: str, operation: str) -> None:
    log.operated(client.clock.time(), of, operation)


def _keep(client: Client, log: RunLog, key: str, device: Device) -> None:
    name = "odometry" if isinstance(device, Base) else f"{type(device).__name__}:{key}"
    sensor_log = _Kept(log, name, client.clock.time)
    read = device.functions["read"] = partial(sensor_log.read, device.functions["read"])
    if isinstance(device, Sensor):
        device.read = read
    client.readings.watch((type(device), key), read)


class _Kept:
    """The readings of one device."""

    def __init__(self, log: RunLog, name: str, time: Callable[[], float]) -> None:
        self._log = log
        self._name = name
        self._time = time
        self._kept_at = -PERIOD
        self._value: Any = None

    def read(self, function: Callable[[], Any]) -> Any:
        """Read the device, and keep the value if it is another one."""
        value = function()
        now = self._time()
        if now - self._kept_at >= PERIOD:
            self._keep(now, _rounded(msgspec.to_builtins(value, enc_hook=plain)))
        return value

    def _keep(self, now: float, value: Any) -> None:
        if value != self._value:
            self._kept_at, self._value = now, value
            self._log.sensed(now, self._name, value)


def _rounded(value: Any) -> Any:
    if isinstance(value, float):
        return round(value, _DIGITS) + 0.0
    if isinstance(value, list | tuple):
        return [_rounded(item) for item in value]
    if isinstance(value, dict):
        return {key: _rounded(item) for key, item in value.items()}
    return value
