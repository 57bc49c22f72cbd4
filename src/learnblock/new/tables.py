"""The tables of a robot's description that `learnblock new robot` asks about."""

from learnblock.simulator.robot_description import (
    Body,
    Camera,
    Display,
    DistanceSensor,
    GroundSensor,
    GroundSide,
    Joint,
    Side,
    Wheels,
)

__all__ = [
    "Body",
    "Camera",
    "Display",
    "DistanceSensor",
    "GroundSensor",
    "GroundSide",
    "Joint",
    "Side",
    "Wheels",
]
