"""The motors and sensors of an emulated hub: what a program on it asks, answered by a twin."""

import colorsys
import errno
from collections.abc import Callable, Sequence
from typing import Any

from learnblock.devices import NOTHING_SEEN
from learnblock.emulators.vehicle import Vehicle

#: The motor ports of the left and right wheels.
LEFT, RIGHT = "A", "B"
#: The number of the device at each port, in LEGO's protocol.
PLUGGED = {LEFT: 48, RIGHT: 48, "C": 62, "D": 61, "E": 63}
#: The battery, mV.
VOLTAGE = 8000
#: The force on a pressed sensor, N.
PRESSED = 5
#: Degrees/s of a medium motor at full speed.
FASTEST = 1000
#: The lamp of the hub's centre button.
STATUS_LIGHT = "Status"


class HubDevices:
    """Answers a program's questions.

    Args:
        vehicle: the robot.

    Attributes:
        plugged: the number of the device at each port; a test unplugs one.
    """

    def __init__(self, vehicle: Vehicle) -> None:
        self._vehicle = vehicle
        self._speeds = {LEFT: 0.0, RIGHT: 0.0}
        self.plugged = dict(PLUGGED)
        self._answers: dict[str, Callable[..., Any]] = {
            "number": self._number,
            "run": self._run,
            "angle": self._angle,
            "reflection": self._sensor(lambda: round(vehicle.reflection())),
            "distance": self._sensor(lambda: round(min(vehicle.distance(), NOTHING_SEEN))),
            "force": self._sensor(lambda: PRESSED * vehicle.touched()),
            "show": vehicle.show,
            "beep": lambda hertz, duration: vehicle.note("tone", hertz, duration),
            "light": self._light,
            "heading": vehicle.angle,
            "voltage": lambda: VOLTAGE,
        }

    def answer(self, words: Sequence[Any]) -> dict[str, Any]:
        """The answer to a question: a value, or the number of an error."""
        name, *arguments = words
        try:
            return {"value": self._answers[name](*arguments)}
        except OSError as error:
            return {"error": error.errno}

    def rest(self) -> None:
        """Stop everything, as the hub does at the end of a program."""
        self._speeds = dict.fromkeys(self._speeds, 0.0)
        self._vehicle.turn(self._speeds)
        self._vehicle.show("")

    def _require(self, port: str) -> None:
        if port not in self.plugged:
            raise OSError(errno.ENODEV, "unplugged")

    def _number(self, port: str) -> int:
        self._require(port)
        return self.plugged[port]

    def _sensor(self, read: Callable[[], float]) -> Callable[[str], float]:
        """Reads a sensor, if it is plugged in."""

        def reading(port: str) -> float:
            self._require(port)
            return read()

        return reading

    def _run(self, port: str, speed: float) -> None:
        self._require(port)
        # The left motor is mounted the other way round.
        forward = -speed if port == LEFT else speed
        self._speeds[port] = min(max(forward, -FASTEST), FASTEST)
        self._vehicle.turn(self._speeds)

    def _angle(self, port: str) -> int:
        self._require(port)
        turned = round(self._vehicle.turned()[port])
        return -turned if port == LEFT else turned

    def _light(self, hue: float, saturation: float, brightness: float) -> None:
        colour = colorsys.hsv_to_rgb(hue / 360, saturation / 100, brightness / 100)
        red, green, blue = (round(255 * part) for part in colour)
        self._vehicle.light(STATUS_LIGHT, (red, green, blue))
