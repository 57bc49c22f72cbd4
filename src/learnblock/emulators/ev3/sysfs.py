"""The sysfs files of ev3dev's motors and sensors, connected to a vehicle.

They follow the kernel's documentation (docs.ev3dev.org, "tacho-motor" and "lego-sensor"): a motor
executes the last ``command`` at the ``speed_sp`` that was set when it was written.
"""

import math
import os
from collections.abc import Callable
from pathlib import Path

from learnblock.emulators.ev3.motors import FASTEST, LEFT, RIGHT
from learnblock.emulators.vehicle import Vehicle

#: Characters of every file, more than any value, so that each value overwrites the last one.
WIDTH = 64
#: The voltage of a full set of batteries.
MICROVOLTS = 7_800_000

#: The start of every address.
PORTS = "ev3-ports:"


class Attribute:
    """A kernel file.

    An ordinary file does not report writes, so its time is set to 0 after each check: a file with
    another time has been written since.
    """

    def __init__(self, path: Path, mode: int, value: object = "") -> None:
        self.path = path
        path.touch()
        self._file = path.open("r+b", buffering=0)
        path.chmod(mode)
        self.value = str(value)
        self._write()

    def show(self, value: object) -> None:
        """Make a value visible to readers."""
        if str(value) != self.value:
            self.value = str(value)
            self._write()

    def written(self) -> str | None:
        """The value written by a client since the last call, or None."""
        if self.path.stat().st_mtime_ns == 0:
            return None
        # In this order: a write between the two is found by the next call.
        os.utime(self.path, ns=(0, 0))
        self._file.seek(0)
        text = self._file.read(WIDTH).decode("ascii", "replace")
        return text.partition("\n")[0].strip()

    def close(self) -> None:
        self._file.close()

    def lose(self) -> None:
        """Become empty, also for readers that have it open."""
        self._file.truncate(0)

    def _write(self) -> None:
        # In a single write, so that a reader finds either the old value or the new one.
        self._file.seek(0)
        self._file.write(f"{self.value}\n".ljust(WIDTH).encode())
        os.utime(self.path, ns=(0, 0))


class DeviceFolder:
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
        # The emulator, as the owner, may read and write; others have the kernel's permissions.
        self._attributes[name] = Attribute(self.folder / name, mode | 0o600, value)


class MotorFolder(DeviceFolder):
    """A large motor with its current `speed` in degrees/s."""

    def __init__(self, folder: Path, port: str) -> None:
        super().__init__(folder)
        self.speed = 0.0
        self._add("address", PORTS + f"out{port}")
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

    def execute(self) -> None:
        """Execute the values written since the last call."""
        # First, so that the values that a client has written before its command are there.
        command = self["command"].written()
        for name in ("speed_sp", "stop_action"):
            value = self[name].written()
            if value is not None:
                self[name].show(value)
        if command == "run-forever":
            self.speed = _speed(self["speed_sp"].value)
        elif command in {"stop", "reset"}:
            self.speed = 0.0

    def report(self, turned: float) -> None:
        """Show the degrees that it has turned."""
        self["position"].show(round(turned))
        self["speed"].show(round(self.speed))
        self["state"].show("running" if self.speed else "")


class SensorFolder(DeviceFolder):
    """A sensor with several modes; it measures only in the first one."""

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
        self._add("address", PORTS + f"in{port}")
        self._add("driver_name", driver)
        self._add("modes", " ".join(modes))
        # It starts in the first mode.
        self._add("mode", modes[0], mode=0o664)
        self._add("decimals", decimals)
        self._add("num_values", 1)
        self._add("value0", 0)
        self.report()

    def execute(self) -> None:
        """Switch to the mode written since the last call."""
        mode = self["mode"].written()
        if mode is not None and mode in self["modes"].value.split():
            self["mode"].show(mode)

    def unplug(self) -> None:
        """Unplug it: the kernel removes it."""
        self.plugged = False
        for attribute in self._attributes.values():
            attribute.lose()

    def report(self) -> None:
        """Show its reading; 0 in other modes."""
        measures = self["mode"].value == self._mode
        self["decimals"].show(self._decimals if measures else 0)
        self["value0"].show(round(self._measure() * 10**self._decimals) if measures else 0)


class BatteryFolder(DeviceFolder):
    """The battery of a brick, which never runs down."""

    def __init__(self, folder: Path) -> None:
        super().__init__(folder)
        self._add("voltage_now", MICROVOLTS)


class Tree:
    """All files, in a folder that replaces /sys/class.

    Args:
        root: the folder.
        vehicle: the robot that they drive.
    """

    def __init__(self, root: Path, vehicle: Vehicle) -> None:
        self._vehicle = vehicle
        motors, sensors = root / "tacho-motor", root / "lego-sensor"
        self._battery = BatteryFolder(root / "power_supply" / "lego-ev3-battery")
        self.motors = {
            port: MotorFolder(motors / f"motor{index}", port)
            for index, port in enumerate((LEFT, RIGHT))
        }
        self.sensors = {
            "touch": SensorFolder(
                sensors / "sensor0", 1, "lego-ev3-touch", modes=("TOUCH",), measure=vehicle.touched
            ),
            "gyroscope": SensorFolder(
                sensors / "sensor1",
                2,
                "lego-ev3-gyro",
                modes=("GYRO-ANG", "GYRO-RATE", "GYRO-CAL"),
                measure=vehicle.angle,
            ),
            "colour": SensorFolder(
                sensors / "sensor2",
                3,
                "lego-ev3-color",
                modes=("COL-REFLECT", "COL-AMBIENT", "COL-COLOR"),
                measure=vehicle.reflection,
            ),
            "ultrasonic": SensorFolder(
                sensors / "sensor3",
                4,
                "lego-ev3-us",
                modes=("US-DIST-CM", "US-DIST-IN", "US-LISTEN"),
                measure=lambda: vehicle.distance() / 10,
                decimals=1,
            ),
        }

    def turn(self) -> None:
        """Execute the written commands, and show the results."""
        for motor in self.motors.values():
            motor.execute()
        self._vehicle.turn({port: motor.speed for port, motor in self.motors.items()})
        turned = self._vehicle.turned()
        for port, motor in self.motors.items():
            motor.report(turned[port])
        for sensor in self.sensors.values():
            if sensor.plugged:
                sensor.execute()
                sensor.report()

    def close(self) -> None:
        for device in (self._battery, *self.motors.values(), *self.sensors.values()):
            device.close()


def _speed(text: str) -> float:
    """The value written to ``speed_sp``; 0 if it is out of range, since the kernel refuses it."""
    try:
        speed = float(text)
    except ValueError:
        return 0.0
    return speed if math.isfinite(speed) and abs(speed) <= FASTEST else 0.0
