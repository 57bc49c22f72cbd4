"""Two motors and four sensors of a LEGO brick or hub, connected to a twin."""

import math
from collections.abc import Mapping

from learnblock.emulators.twin import Twin
from learnblock.simulator.colours import RGB
from learnblock.wheels import body_speeds


class Vehicle:
    """The motors and sensors of a brick, which move and read a twin.

    Args:
        twin: the robot.
        left: the motor port of the left wheel.
        right: the motor port of the right wheel.
    """

    def __init__(self, twin: Twin, left: str, right: str) -> None:
        self._twin = twin
        self._ports = left, right
        with twin.body() as body:
            wheels = body.description.wheels
        self._radius, self._track = wheels.radius, wheels.track

    def turn(self, speeds: Mapping[str, float]) -> None:
        """Turn the motors at these speeds: degrees/s by port."""
        left, right = (math.radians(speeds[port]) * self._radius for port in self._ports)
        with self._twin.body() as body:
            body.drive(*body_speeds((left, right), self._track))

    def turned(self) -> dict[str, float]:
        """The degrees that each motor has turned, by port."""
        with self._twin.body() as body:
            left, right = body.wheels_rolled
        angles = (math.degrees(rolled / self._radius) for rolled in (left, right))
        return dict(zip(self._ports, angles, strict=True))

    def distance(self) -> float:
        """The ultrasonic sensor's distance in mm; 2550 if it sees nothing."""
        with self._twin.body() as body:
            nearest = body.distances()["front"][0]
        return nearest if nearest < 2000 else 2550.0

    def reflection(self) -> float:
        """The colour sensor's reading, 0 to 100."""
        with self._twin.body() as body:
            return body.ground()["central"] or 0.0

    def angle(self) -> float:
        """The gyroscope's angle in degrees clockwise since the start."""
        with self._twin.body() as body:
            return body.gyroscope()

    def touched(self) -> bool:
        """Whether the touch sensor is pressed."""
        with self._twin.body() as body:
            return body.bumper()

    def show(self, text: str) -> None:
        """Show a text on the screen."""
        with self._twin.body() as body:
            body.show_text(text)

    def light(self, lamp: str, colour: RGB) -> None:
        """Show a colour on a lamp."""
        with self._twin.body() as body:
            body.set_led(lamp, colour)

    def note(self, action: str, *values: object) -> None:
        """Record a command for the loudspeaker."""
        with self._twin.body() as body:
            body.note("Speaker", action, *values)
