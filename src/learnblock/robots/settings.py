"""The settings of real robots: addresses, ports, sizes.

Each robot defines its settings in a Struct; a description is a code of ``robot.ftl`` or, in a robot
of a user or a plugin, plain text. The user's choices are stored in a table of
`learnblock.storage.settings` for each robot, such as ``[robots.cozmo]``.
"""

import tomllib
from collections.abc import Iterator, Mapping
from typing import Annotated, Any, TypeVar

from msgspec import Meta

from learnblock.storage.settings import Described, Patience, Settings, SettingsSection, file

__all__ = [
    "LONGEST_NAME",
    "Address",
    "Baud",
    "Described",
    "GivenName",
    "Length",
    "Patience",
    "Port",
    "RobotSettings",
    "SerialPort",
    "SettingsT",
    "Speed",
    "change",
    "describe",
    "file",
    "given_names",
    "load",
    "table",
]

Address = Annotated[str, Meta(min_length=1, max_length=253, description="robot-setting-address")]
Port = Annotated[int, Meta(ge=1, le=65535, description="robot-setting-port")]
SerialPort = Annotated[
    str, Meta(min_length=1, max_length=200, description="robot-setting-serial-port")
]
Baud = Annotated[int, Meta(ge=300, le=4_000_000, description="robot-setting-baud")]
#: The limit in characters of the name that a user gives a robot.
LONGEST_NAME = 40
#: The name given by the user, such as ``Ada``.
GivenName = Annotated[str, Meta(max_length=LONGEST_NAME, description="robot-setting-name")]
Length = Annotated[float, Meta(ge=1, le=1000, description="robot-setting-length")]
Speed = Annotated[float, Meta(ge=1, le=5000, description="robot-setting-speed")]


class RobotSettings(Settings, frozen=True, kw_only=True):
    """The base class of every robot's settings; each field has a default."""

    name: GivenName = ""


SettingsT = TypeVar("SettingsT", bound=RobotSettings)


def load(
    robot: str, kind: type[SettingsT], overrides: Mapping[str, Any] | None = None
) -> SettingsT:
    """The settings of a robot.

    Args:
        robot: its id, such as ``cozmo``.
        kind: the robot's settings class.
        overrides: settings by name, which override those of the file.

    Raises:
        SettingsError: a value or a name in the file or in `overrides` is invalid.
    """
    return table(robot, kind).load(overrides)


def change(robot: str, kind: type[SettingsT], name: str, text: str | None) -> SettingsT:
    """Change one setting, given as a string, in the user's file; None restores its default.

    Raises:
        UnknownNameError: the robot has no such setting.
        SettingsError: the value is invalid, or the file already is.
    """
    return table(robot, kind).change(name, text)


def describe(robot: str, kind: type[RobotSettings]) -> Iterator[Described]:
    """Describe every setting of a robot with its current value.

    Raises:
        SettingsError: the user's file is invalid.
    """
    return table(robot, kind).describe()


def given_names() -> dict[str, str]:
    """The names given by the user, by robot id; read without the drivers, which load slowly."""
    try:
        whole = tomllib.loads(file().read_text("utf-8"))
    except (OSError, ValueError, RecursionError):
        # A file that can't be read is reported when its settings are used.
        return {}
    tables = whole.get("robots")
    if not isinstance(tables, dict):
        return {}
    names = {robot: table.get("name") for robot, table in tables.items() if isinstance(table, dict)}
    return {robot: name[:LONGEST_NAME] for robot, name in names.items() if isinstance(name, str)}


def table(robot: str, kind: type[SettingsT]) -> SettingsSection[SettingsT]:
    """The table with a robot's settings."""
    return SettingsSection(("robots", robot), f"the robot {robot}", kind)
