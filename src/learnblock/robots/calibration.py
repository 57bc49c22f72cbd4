"""Corrects the size of a robot's wheels from what a person has measured."""

from collections.abc import Mapping
from dataclasses import dataclass

from learnblock.robots.settings import RobotSettings

#: The drives to measure: mm forward, and degrees on the spot.
DISTANCE, ANGLE = 500.0, 360.0
#: The digits after the point that a tape measure justifies.
_DIGITS = 3


@dataclass(frozen=True, slots=True)
class Calibration:
    """The settings of a robot that a measurement corrects.

    Args:
        distance: the setting to which the driven distance is proportional, such as the radius of
            the wheels.
        angle: the distance between the wheels, to which the angle is inversely proportional.
    """

    distance: str
    angle: str

    def sizes(self, settings: RobotSettings) -> dict[str, float]:
        """The values of the settings, by name."""
        return {name: float(getattr(settings, name)) for name in (self.distance, self.angle)}

    def corrected(
        self, settings: RobotSettings, distance: float = DISTANCE, angle: float = ANGLE
    ) -> dict[str, float]:
        """The new values of the settings, by name; see `corrected_sizes`.

        Args:
            settings: those with which the robot has driven.
            distance: the measured distance in mm after being asked to drive 500 mm.
            angle: the measured angle in degrees after being asked to turn by 360 degrees.
        """
        return self.corrected_sizes(self.sizes(settings), distance, angle)

    def corrected_sizes(
        self, sizes: Mapping[str, float], distance: float = DISTANCE, angle: float = ANGLE
    ) -> dict[str, float]:
        """The new values of the settings, by name.

        A robot turns its wheels by `distance / radius`. If it was asked to drive 500 mm and has
        driven d mm, its wheels are d / 500 times as large as it believes:

            radius' = radius * d / 500

        To turn by an angle, each wheel drives along a circle whose diameter is the track. If the
        robot was asked to turn by 360 degrees and has turned by a degrees, the circle was 360 / a
        times as long for it as it should have been, besides the wheels' own error:

            track' = track * (d / 500) * (360 / a)

        Both were driven with the same settings. Without a measurement, the robot's is trusted.

        Args:
            sizes: the values with which the robot has driven.
            distance: the measured distance in mm after being asked to drive 500 mm.
            angle: the measured angle in degrees after being asked to turn by 360 degrees.
        """
        scale = distance / DISTANCE
        return {
            self.distance: round(sizes[self.distance] * scale, _DIGITS),
            self.angle: round(sizes[self.angle] * scale * ANGLE / angle, _DIGITS),
        }
