"""The distance and ground sensors of a simulated robot."""

from collections.abc import Sequence
from typing import Protocol

from learnblock.simulator.chassis import Chassis
from learnblock.simulator.floor import Floor
from learnblock.simulator.geometry import Point, forward
from learnblock.simulator.noise import Noise
from learnblock.simulator.physics import Physics
from learnblock.simulator.robot_description import (
    NOTHING_SEEN,
    DistanceSensor,
    GroundSensor,
    RobotDescription,
)

BEAM_RAYS = 5
"""Rays into which a sensor's beam is divided."""


class RangeSurroundings(Protocol):
    """The parts of the world that these sensors need."""

    physics: Physics
    floor: Floor
    steps: int


class RangeSensors:
    """The distance and ground sensors of one robot.

    Args:
        description: the description of the robot.
        chassis: carries the sensors.
        world: the world that they measure.
        noise: the noise of the robot.
    """

    def __init__(
        self,
        description: RobotDescription,
        chassis: Chassis,
        world: RangeSurroundings,
        noise: Noise,
    ) -> None:
        self._description = description
        self._chassis = chassis
        self._world = world
        self._noise = noise
        #: The offsets of each distance sensor's rays, and the sensors of each side, by their index.
        self._offsets = [_beam_offsets(sensor.beam) for sensor in description.distance]
        self._sides = [
            (side, [i for i, sensor in enumerate(description.distance) if side in sensor.sides])
            for side in ("front", "left", "right", "back")
        ]

    def distances(self) -> dict[str, list[float]]:
        """The distances in mm, from left to right on each side."""
        sensors = self._description.distance
        readings = [self._distance(i, sensor) for i, sensor in enumerate(sensors)]
        return {side: [readings[i] for i in indexes] for side, indexes in self._sides}

    def looked_at(self, side: str) -> str | None:
        """The name of what is nearest to the sensors of a side; None if they see nothing."""
        readings: list[tuple[float, str]] = []
        for sensor in self._description.distance:
            start = self._chassis.to_world(sensor.x, sensor.y)
            heading = self._chassis.pose.heading + sensor.direction
            for offset in _beam_offsets(sensor.beam) if side in sensor.sides else ():
                end = _ahead(start, heading + offset, sensor.maximum)
                if seen := self._world.physics.seen(start, end, self._chassis.filter):
                    readings.append((seen[0] * sensor.maximum, seen[1]))
        return min(readings)[1] or None if readings else None

    def ground(self) -> dict[str, float | None]:
        """The reflectances of the floor, from 0 to 100."""
        readings: dict[str, float | None] = {"left": None, "central": None, "right": None}
        for sensor in self._description.ground:
            readings[sensor.side] = self._ground(sensor)
        return readings

    def _distance(self, index: int, sensor: DistanceSensor) -> float:
        nearest = min(self._rays(sensor, self._offsets[index]))
        if nearest >= sensor.maximum:
            return NOTHING_SEEN
        noise = 1 + sensor.noise * self._noise.normal(f"distance {index}", self._world.steps)
        return round(min(max(nearest * noise, sensor.minimum), NOTHING_SEEN), 1)

    def _rays(self, sensor: DistanceSensor, offsets: Sequence[float]) -> list[float]:
        """The length of each ray of the sensor's beam, which ends at an object or at its range."""
        start = self._chassis.to_world(sensor.x, sensor.y)
        heading = self._chassis.pose.heading + sensor.direction
        ray, looker, reach = self._world.physics.ray, self._chassis.filter, sensor.maximum
        parts = [ray(start, _ahead(start, heading + offset, reach), looker) for offset in offsets]
        return [reach if part is None else part * reach for part in parts]

    def _ground(self, sensor: GroundSensor) -> float:
        x, y = self._chassis.to_world(sensor.x, sensor.y)
        if sensor.kind == "cliff":
            return 100.0 if self._world.floor.reaches(x, y) else 0.0
        level = self._world.floor.reflectance(x, y, sensor.spot)
        noise = sensor.noise * self._noise.normal(f"ground {sensor.side}", self._world.steps)
        return round(min(max(level + noise, 0.0), 100.0), 2)


def _ahead(start: Point, heading: float, reach: float) -> Point:
    x, y = forward(heading)
    return start[0] + reach * x, start[1] + reach * y


def _beam_offsets(beam: float) -> Sequence[float]:
    if not beam:
        return (0.0,)
    return [beam * (i / (BEAM_RAYS - 1) - 0.5) for i in range(BEAM_RAYS)]
