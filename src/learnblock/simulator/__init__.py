"""The embedded simulator: worlds, and robots with their sensors and cameras.

This package uses no clock, network or robot class: a world advances only by `World.step`.
"""

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from learnblock.simulator.camera import CameraModel, CameraPose, CameraView, Surface, render
    from learnblock.simulator.drawing import PenStroke
    from learnblock.simulator.goal import GoalState
    from learnblock.simulator.reachability import Unreachable, unreachable_goals
    from learnblock.simulator.robot_body import LogEntry, RobotBody
    from learnblock.simulator.robot_description import RobotDescription, load_robot, robot_names
    from learnblock.simulator.templates import Template, make_world
    from learnblock.simulator.vary import make_variant
    from learnblock.simulator.world import World, WorldEvent
    from learnblock.simulator.world_description import WorldDescription, WorldFile
    from learnblock.simulator.world_files import load_world, read_world, world_names, write_world

__all__ = [
    "CameraModel",
    "CameraPose",
    "CameraView",
    "GoalState",
    "LogEntry",
    "PenStroke",
    "RobotBody",
    "RobotDescription",
    "Surface",
    "Template",
    "Unreachable",
    "World",
    "WorldDescription",
    "WorldEvent",
    "WorldFile",
    "load_robot",
    "load_world",
    "make_variant",
    "make_world",
    "read_world",
    "render",
    "robot_names",
    "unreachable_goals",
    "world_names",
    "write_world",
]

_MODULES = {
    "camera": ("CameraModel", "CameraPose", "Surface", "CameraView", "render"),
    "drawing": ("PenStroke",),
    "goal": ("GoalState",),
    "reachability": ("Unreachable", "unreachable_goals"),
    "robot_body": ("LogEntry", "RobotBody"),
    "robot_description": ("RobotDescription", "load_robot", "robot_names"),
    "templates": ("Template", "make_world"),
    "vary": ("make_variant",),
    "world": ("World", "WorldEvent"),
    "world_description": ("WorldDescription", "WorldFile"),
    "world_files": ("load_world", "read_world", "world_names", "write_world"),
}


def __getattr__(name: str) -> Any:
    """Import a name when it is first used: robot descriptions do not need OpenCV."""
    for module, names in _MODULES.items():
        if name in names:
            return getattr(import_module(f"{__name__}.{module}"), name)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
