"""The twin as a brick sees it: two motors, and four sensors."""

import math
from collections.abc import Mapping

from learnblock.emulators.twin import Twin
from learnblock.wheels import body_speeds

#: The motors of the twin: the left wheel's, the right wheel's.
LEFT, RIGHT = "B", "D"
#: Degrees/s of a large motor that runs as fast as it can.
FASTEST = 1050


class Vehicle:
    """A twin on the motors of a brick.

    Args:
        twin: what is driven.
    """

    def __init__(self, twin: Twin) -> None:
        self._twin = twin
        with twin.body() as body:
            wheels = body.description.wheels
        self._radius, self._track = wheels.radius, wheels.track

    def turn(self, speeds: Mapping[str, float]) -> None:
        """Turn the motors at these speeds, degrees/s by port."""
        left, right = (math.radians(speeds[port]) * self._radius for port in (LEFT, RIGHT))
        with self._twin.body() as body:
            body.drive(*body_speeds((left, right), self._track))

    def turned(self) -> dict[str, float]:
        """How far each motor has turned, degrees by port."""
        with self._twin.body() as body:
            left, right = body.wheels_rolled
        return {
            LEFT: math.degrees(left / self._radius),
            RIGHT: math.degrees(right / self._radius),
        }

    def distance(self) -> float:
        """Of the ultrasonic sensor, mm; 2550 when it sees nothing."""
        with self._twin.body() as body:
            nearest = body.distances()["front"][0]
        return nearest if nearest < 2000 else 2550.0

    def reflection(self) -> float:
        """Of the colour sensor, 0 to 100."""
        with self._twin.body() as body:
            return body.ground()["central"] or 0.0

    def angle(self) -> float:
        """Of the gyroscope, degrees clockwise since the start."""
        with self._twin.body() as body:
            return body.gyroscope()

    def touched(self) -> bool:
        """Whether the touch sensor is pressed."""
        with self._twin.body() as body:
            return body.bumper()

    def note(self, action: str, *values: object) -> None:
        """The loudspeaker was told something."""
        with self._twin.body() as body:
            body.note("Speaker", action, *values)
