"""The files by which the kernel of ev3dev offers motors and sensors, moved by a vehicle.

As the kernel's documentation has them (docs.ev3dev.org, "tacho-motor" and "lego-sensor"): a motor
does what was last written to ``command``, at the ``speed_sp`` that stood there at that moment.
"""

import math
import os
from collections.abc import Callable
from pathlib import Path

from learnblock.emulators.ev3.vehicle import FASTEST, LEFT, RIGHT, Vehicle

#: Characters of every file: longer than any value, so that each is written over the last one whole.
WIDTH = 64


class Attribute:
    """A file of the kernel's.

    What lies in an ordinary file does not say when it was written: an attribute whose time is 0 was
    not, since it was last looked at.
    """

    def __init__(self, path: Path, mode: int, value: object = "") -> None:
        self.path = path
        path.touch()
        self._file = path.open("r+b", buffering=0)
        path.chmod(mode)
        self.value = str(value)
        self._write()

    def tell(self, value: object) -> None:
        """Let readers find a value."""
        if str(value) != self.value:
            self.value = str(value)
            self._write()

    def written(self) -> str | None:
        """What was written by others since this was last asked."""
        if self.path.stat().st_mtime_ns == 0:
            return None
        # In this order: what is written between the two is found the next time.
        os.utime(self.path, ns=(0, 0))
        self._file.seek(0)
        text = self._file.read(WIDTH).decode("ascii", "replace")
        return text.partition("\n")[0].strip()

    def close(self) -> None:
        self._file.close()

    def lose(self) -> None:
        """Have nothing to say any more, also to those who have it open."""
        self._file.truncate(0)

    def _write(self) -> None:
        # At one go: a reader finds the old value or the new one.
        self._file.seek(0)
        self._file.write(f"{self.value}\n".ljust(WIDTH).encode())
        os.utime(self.path, ns=(0, 0))


class Device:
    """A device's folder."""

    def __init__(self, folder: Path) -> None:
        folder.mkdir(parents=True)
        self.folder = folder
        self._attributes: dict[str, Attribute] = {}

    def __getitem__(self, name: str) -> Attribute:
        return self._attributes[name]

    def close(self) -> None:
        for attribute in self._attributes.values():
            attribute.close()

    def _add(self, name: str, value: object = "", mode: int = 0o444) -> None:
        # The owner, this emulator, may do both; what others may is what the kernel allows.
        self._attributes[name] = Attribute(self.folder / name, mode | 0o600, value)


class Motor(Device):
    """A large motor; what it does is `speed`, degrees/s."""

    def __init__(self, folder: Path, port: str) -> None:
        super().__init__(folder)
        self.speed = 0.0
        self._add("address", f"ev3-ports:out{port}")
        self._add("driver_name", "lego-ev3-l-motor")
        self._add("max_speed", FASTEST)
        self._add("count_per_rot", 360)
        self._add("commands", "run-forever run-to-abs-pos run-timed run-direct stop reset")
        self._add("command", mode=0o220)
        self._add("speed_sp", 0, mode=0o664)
        self._add("stop_action", "coast", mode=0o664)
        self._add("position", 0, mode=0o664)
        self._add("speed", 0)
        self._add("state")

    def obey(self) -> None:
        """Do what was written since the last time."""
        for name in ("speed_sp", "stop_action"):
            written = self[name].written()
            if written is not None:
                self[name].tell(written)
        command = self["command"].written()
        if command == "run-forever":
            self.speed = _speed(self["speed_sp"].value)
        elif command in {"stop", "reset"}:
            self.speed = 0.0

    def report(self, turned: float) -> None:
        """Let readers find how far it has turned, degrees."""
        self["position"].tell(round(turned))
        self["speed"].tell(round(self.speed))
        self["state"].tell("running" if self.speed else "")


class Sensor(Device):
    """A sensor with a mode in which it measures something, of several it has."""

    def __init__(
        self,
        folder: Path,
        port: int,
        driver: str,
        *,
        modes: tuple[str, ...],
        measure: Callable[[], float],
        decimals: int = 0,
    ) -> None:
        super().__init__(folder)
        self.plugged = True
        self._measure, self._mode, self._decimals = measure, modes[0], decimals
        self._add("address", f"ev3-ports:in{port}")
        self._add("driver_name", driver)
        self._add("modes", " ".join(modes))
        # The first is the one in which it begins.
        self._add("mode", modes[0], mode=0o664)
        self._add("decimals", decimals)
        self._add("num_values", 1)
        self._add("value0", 0)
        self.report()

    def obey(self) -> None:
        """Measure what was asked for since the last time."""
        mode = self["mode"].written()
        if mode is not None and mode in self["modes"].value.split():
            self["mode"].tell(mode)

    def unplug(self) -> None:
        """Pull its cable: the kernel forgets it."""
        self.plugged = False
        for attribute in self._attributes.values():
            attribute.lose()

    def report(self) -> None:
        """Let readers find what it measures; in other modes, nothing."""
        measures = self["mode"].value == self._mode
        self["decimals"].tell(self._decimals if measures else 0)
        self["value0"].tell(round(self._measure() * 10**self._decimals) if measures else 0)


class Tree:
    """All the files, under a folder that stands for /sys/class.

    Args:
        root: that folder.
        vehicle: what is driven.
    """

    def __init__(self, root: Path, vehicle: Vehicle) -> None:
        self._vehicle = vehicle
        motors, sensors = root / "tacho-motor", root / "lego-sensor"
        self.motors = {
            port: Motor(motors / f"motor{index}", port) for index, port in enumerate((LEFT, RIGHT))
        }
        self.sensors = {
            "touch": Sensor(
                sensors / "sensor0", 1, "lego-ev3-touch", modes=("TOUCH",), measure=vehicle.touched
            ),
            "gyroscope": Sensor(
                sensors / "sensor1",
                2,
                "lego-ev3-gyro",
                modes=("GYRO-ANG", "GYRO-RATE", "GYRO-CAL"),
                measure=vehicle.angle,
            ),
            "colour": Sensor(
                sensors / "sensor2",
                3,
                "lego-ev3-color",
                modes=("COL-REFLECT", "COL-AMBIENT", "COL-COLOR"),
                measure=vehicle.reflection,
            ),
            "ultrasonic": Sensor(
                sensors / "sensor3",
                4,
                "lego-ev3-us",
                modes=("US-DIST-CM", "US-DIST-IN", "US-LISTEN"),
                measure=lambda: vehicle.distance() / 10,
                decimals=1,
            ),
        }

    def turn(self) -> None:
        """Do what was written, and let readers find what has come of it."""
        for motor in self.motors.values():
            motor.obey()
        self._vehicle.turn({port: motor.speed for port, motor in self.motors.items()})
        turned = self._vehicle.turned()
        for port, motor in self.motors.items():
            motor.report(turned[port])
        for sensor in self.sensors.values():
            if sensor.plugged:
                sensor.obey()
                sensor.report()

    def close(self) -> None:
        for device in (*self.motors.values(), *self.sensors.values()):
            device.close()


def _speed(text: str) -> float:
    """What is written to ``speed_sp``; out of range the kernel refuses it."""
    try:
        speed = float(text)
    except ValueError:
        return 0.0
    return speed if math.isfinite(speed) and abs(speed) <= FASTEST else 0.0
