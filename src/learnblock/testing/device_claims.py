"""Checks of a client's devices and their readings."""

import re
from contextlib import redirect_stdout
from io import StringIO
from statistics import median
from time import monotonic
from typing import Any

from learnblock.blocks.known import all_configurations
from learnblock.client import Client
from learnblock.devices import DEVICE_TYPES, Accelerometer, Camera, Gyroscope, Sensor
from learnblock.testing.bench import Bench, SkippedClaimError, require
from learnblock.testing.forms import has_form


def connects(bench: Bench) -> str:
    """Check that it connects within the timeout."""
    began = monotonic()
    with bench.in_time("connecting"):
        robot = bench.make()
    robot.stop()
    return f"{monotonic() - began:.2f} s"


def has_announced_devices(bench: Bench) -> str:
    """Check that it has exactly the devices that its class announces."""
    with bench.robot() as robot:
        devices = {f"{type(device).__name__}:{key}" for key, device in robot.devices()}
        announced = robot.known_devices()
    require(bool(devices), "it has no device")
    require(
        announced is None or announced == devices, f"it announces {announced}, but has {devices}"
    )
    return ", ".join(sorted(devices))


def has_words_as_keys(bench: Bench) -> str:
    """Check that its keys are words, and that a gyroscope has the usual key."""
    with bench.robot() as robot:
        keys = {(type(device), key) for key, device in robot.devices()}
    wrong = [key for _, key in keys if not re.fullmatch(r"\w[\w ]*", key)]
    require(not wrong, f"these keys are not words: {wrong}")
    gyroscopes = {key for kind, key in keys if kind is Gyroscope}
    require(not gyroscopes or "Z_AXIS" in gyroscopes, "no gyroscope has the key Z_AXIS")
    return ""


def has_valid_readings(bench: Bench) -> str:
    """Check the form and range of one reading of each sensor."""
    with bench.robot() as robot:
        sensors = _sensors(robot)
        for name, sensor in sensors.items():
            _check_reading(bench, name, sensor)
    return f"{len(sensors)} sensors"


def _sensors(robot: Client) -> dict[str, Sensor[Any]]:
    """The robot's sensors by ``Type:KEY``."""
    devices = [(f"{type(device).__name__}:{key}", device) for key, device in robot.devices()]
    sensors = {name: device for name, device in devices if isinstance(device, Sensor)}
    if not sensors:
        raise SkippedClaimError("it has no sensor")
    return sensors


def _check_reading(bench: Bench, name: str, sensor: Sensor[Any]) -> None:
    reading = sensor.read()
    if isinstance(sensor, Camera):
        until = monotonic() + bench.patience
        while reading is None and monotonic() < until:
            reading = sensor.read()
    require(has_form(sensor, reading), f"{name} reads {reading!r:.120}")


def measures_gravity(bench: Bench) -> str:
    """Check the direction and unit of the accelerometer of a robot at rest."""
    with bench.robot() as robot:
        sensor = robot.device(Accelerometer)
        if sensor is None:
            raise SkippedClaimError("it has no accelerometer")
        x, y, z = sensor.read()
    require(7 < z < 12.5 and abs(x) < 4 and abs(y) < 4, f"it reads {(x, y, z)} m/s² at rest")
    return f"{z:.2f} m/s² upwards"


def reads_often(bench: Bench) -> str:
    """Check that each sensor can be read at least 5 times a second."""
    with bench.robot() as robot:
        rates = {name: _rate(sensor) for name, sensor in _sensors(robot).items()}
    slow = [name for name, rate in rates.items() if rate < 5]
    require(not slow, f"less than 5 readings a second: {', '.join(slow)}")
    return ", ".join(f"{name} {min(rate, 9999):.0f}/s" for name, rate in sorted(rates.items()))


def _rate(sensor: Sensor[Any]) -> float:
    """The readings per second, by the median of nine: a busy computer delays single ones."""
    # The first reading may have to open the sensor.
    sensor.read()
    return 1 / max(median(_seconds_of(sensor) for _ in range(9)), 1e-6)


def _seconds_of(sensor: Sensor[Any]) -> float:
    """The duration of a reading."""
    began = monotonic()
    sensor.read()
    return monotonic() - began


def ignores_missing_devices(bench: Bench) -> str:
    """Check that skills without their device do nothing and return nothing."""
    count = 0
    with bench.robot() as robot:
        for kind in DEVICE_TYPES.values():
            missing = f"{kind.__name__}:NONE"
            require(robot.device(kind, "NONE") is None, f"it has a {missing}")
        for skill in all_configurations().values():
            required = any(parameter.required for parameter in skill.parameters)
            if required or not skill.lacks(robot.equipment):
                continue
            # A text for a screen is printed.
            with redirect_stdout(StringIO()):
                answer = getattr(robot, skill.name)()
            require(answer is None or not answer, f"{skill.name} returns {answer!r}")
            count += 1
    return f"{count} skills"
