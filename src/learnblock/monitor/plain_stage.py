"""The plain floor on which a real robot is drawn, and that robot's appearance."""

from functools import cache
from typing import Any

import msgspec

from learnblock.client import Client
from learnblock.monitor.monitor import Scene

#: The body of a robot whose appearance and size are unknown.
_BODY = {"shape": "disc", "radius": 60, "height": 70, "mass": 0.5, "colour": "grey"}
_WHEELS = {"radius": 25, "track": 100, "maximum_speed": 100}


def scene(robot: type[Client]) -> Scene:
    """A real robot on an empty floor.

    Args:
        robot: its class; its `model` names the simulated robot that looks like it.
    """
    devices = robot.known_devices() or frozenset()
    cameras = sorted(name.partition(":")[2] for name in devices if name.startswith("Camera:"))
    return Scene(
        name="",
        world=_floor(),
        lines=(),
        robots=(("robot", _look(robot.model, devices)),),
        cameras=tuple(cameras),
        real=True,
    )


@cache
def _floor() -> dict[str, Any]:
    # The simulator is slow to load, and a program without a page never draws.
    from learnblock.monitor.worlds import world_values  # noqa: PLC0415
    from learnblock.simulator import load_world  # noqa: PLC0415

    values = world_values(load_world("empty"))
    return {**values, "title": "", "start": [], "floor": {**values["floor"], "border": 0}}


def _look(model: str, devices: frozenset[str]) -> dict[str, Any]:
    from learnblock.simulator import RobotDescription, load_robot  # noqa: PLC0415 - as above

    description = load_robot(model) if model else msgspec.convert(_plain(devices), RobotDescription)
    look: dict[str, Any] = msgspec.to_builtins(description)
    return look


def _plain(devices: frozenset[str]) -> dict[str, Any]:
    """A robot whose appearance is unknown, with its screen, lights and joints."""
    parts: dict[str, list[str]] = {}
    for name in sorted(devices):
        kind, _, key = name.partition(":")
        parts.setdefault(kind, []).append(key)
    lights = [{"slot": slot} for slot in parts.get("RGBLed", ())]
    lamps = [{"slot": slot, "kind": "single"} for slot in parts.get("Led", ())]
    joints = [{"key": key, "minimum": -90, "maximum": 90} for key in parts.get("JointMotor", ())]
    return {
        "name": "robot",
        "body": _BODY,
        "wheels": _WHEELS,
        "joint": joints,
        "led": [*lights, *lamps],
        **({"display": {}} if "Display" in parts else {}),
    }
