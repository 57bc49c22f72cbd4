"""Worlds as the page edits and draws them: values, pictures, and files in the user's folder."""

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import msgspec

from learnblock.errors import WorldError
from learnblock.i18n import Phrase
from learnblock.monitor.monitor import Lines
from learnblock.monitor.pictures import png
from learnblock.robots.simulated import check_file_name, find_world, own_worlds
from learnblock.simulator import RobotDescription, Template, WorldFile, read_world, write_world
from learnblock.simulator.colours import Colour
from learnblock.simulator.props import SIZES as PROP_SIZES
from learnblock.simulator.world_description import PropKind, Theme
from learnblock.storage.files import save

__all__ = [
    "PROP_SIZES",
    "Colour",
    "PropKind",
    "RobotDescription",
    "Template",
    "Theme",
    "WorldFile",
    "check_world",
    "face_picture",
    "floor_picture",
    "made_world",
    "save_world",
    "tag_picture",
    "unreachable",
    "world_from_values",
    "world_lines",
    "world_values",
]
_TWIN = "sim-"


def world_values(world: WorldFile) -> dict[str, Any]:
    """The values of a world's file, with all defaults, without its folder."""
    values = msgspec.to_builtins(world)
    return {field: values[field] for field in WorldFile.__struct_fields__}


def world_lines(world: WorldFile) -> Lines:
    """For each painted line, the corner points of its centre line, in mm."""
    return tuple(
        tuple((float(x), float(y)) for x, y in line.polyline().points) for line in world.line
    )


def world_from_values(values: Mapping[str, Any]) -> WorldFile:
    """Create the world edited in the page.

    Raises:
        WorldError: it is invalid; the diagnostics say where.
    """
    return read_world(values, own_worlds())


def check_world(values: Mapping[str, Any]) -> tuple[Phrase, ...]:
    """Report the mistakes in a world edited in the page."""
    try:
        world_from_values(values)
    except WorldError as error:
        return tuple(diagnostic.message for diagnostic in error.diagnostics)
    return ()


def made_world(template: Template, size: int, seed: int) -> WorldFile:
    """Make a world from a template; the same three values always make the same world."""
    from learnblock.simulator import make_world  # noqa: PLC0415 - most callers don't need it

    return make_world(template, size, seed)


def unreachable(world: WorldFile, robot: str) -> tuple[tuple[str, int, Phrase], ...]:
    """The goals that a kind of robot can't reach: kind, index and reason."""
    from learnblock.simulator import unreachable_goals  # noqa: PLC0415 - it loads OpenCV

    goals = unreachable_goals(world, _radius(robot))
    return tuple((goal.kind, goal.index, goal.reason) for goal in goals)


def _radius(robot: str) -> float:
    """Half of a robot's width in mm."""
    from learnblock.simulator import load_robot, robot_names  # noqa: PLC0415 - as above
    from learnblock.simulator.reachability import ROBOT_RADIUS  # noqa: PLC0415 - as above

    name = robot.removeprefix(_TWIN)
    if name not in robot_names():
        return ROBOT_RADIUS
    return max(abs(left) for _, left in load_robot(name).body.outline)


def save_world(name: str, values: Mapping[str, Any]) -> Path:
    """Write a world into the user's folder, completely or not at all.

    Raises:
        WorldError: the world or its name is invalid.
        OSError: the file cannot be written.
    """
    check_file_name(name)
    text = write_world(world_from_values(values), name)
    path = own_worlds() / f"{name}.toml"
    save(path, text.encode())
    return path


def tag_picture(number: int) -> bytes:
    """Draw a tag with its white margin, as PNG.

    Raises:
        TagNumberError: there is no such tag.
    """
    from learnblock.simulator import textures  # noqa: PLC0415 - it loads OpenCV

    return png(textures.tag(number, 160))


def face_picture(emotion: str) -> bytes:
    """Draw a face with an emotion, as PNG.

    Raises:
        UnknownNameError: there is no such face.
    """
    from learnblock.simulator import textures  # noqa: PLC0415 - as above

    return png(textures.face(emotion, 400))


def floor_picture(name: str) -> bytes | None:
    """Read the PNG file of a world's ground; None if it has none.

    Raises:
        UnknownNameError: there is no such world.
        WorldError: its file is invalid.
    """
    world = find_world(name)
    return Path(world.folder, world.floor.picture).read_bytes() if world.floor.picture else None
