"""What a real robot has to be told about itself: addresses, ports, sizes.

Each robot says what that is with a Struct of its own. What the user has chosen stands in a table of
`learnblock.settings` for each robot, such as ``[robots.cozmo]``.
"""

from collections.abc import Iterator, Mapping
from typing import Annotated, Any, TypeVar

from msgspec import Meta

from learnblock.settings import Described, Patience, Settings, Table, file

__all__ = [
    "Address",
    "Baud",
    "Described",
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
    "load",
    "table",
]

Address = Annotated[
    str, Meta(min_length=1, max_length=253, description="a name or number in the network")
]
Port = Annotated[int, Meta(ge=1, le=65535, description="a port of the network")]
SerialPort = Annotated[
    str,
    Meta(min_length=1, max_length=200, description="a serial port, such as /dev/ttyUSB0 or COM3"),
]
Baud = Annotated[int, Meta(ge=300, le=4_000_000, description="bits a second")]
Length = Annotated[float, Meta(ge=1, le=1000, description="mm")]
Speed = Annotated[float, Meta(ge=1, le=5000, description="mm/s")]


class RobotSettings(Settings, frozen=True):
    """The base of every robot's settings; each field has a default."""


SettingsT = TypeVar("SettingsT", bound=RobotSettings)


def load(robot: str, kind: type[SettingsT], chosen: Mapping[str, Any] | None = None) -> SettingsT:
    """The settings of a robot.

    Args:
        robot: its id, such as ``cozmo``.
        kind: what can be set.
        chosen: settings by name, which go before those of the file.

    Raises:
        SettingsError: a value or a name is wrong, in the file or among those chosen.
    """
    return table(robot, kind).load(chosen)


def change(robot: str, kind: type[SettingsT], name: str, text: str | None) -> SettingsT:
    """Set one setting, given as text, in the user's file; None puts its default back.

    Raises:
        UnknownNameError: the robot has no such setting.
        SettingsError: the value is wrong, or what stands in the file already is.
    """
    return table(robot, kind).change(name, text)


def describe(robot: str, kind: type[RobotSettings]) -> Iterator[Described]:
    """Every setting of a robot as it is now.

    Raises:
        SettingsError: what stands in the user's file is wrong.
    """
    return table(robot, kind).describe()


def table(robot: str, kind: type[SettingsT]) -> Table[SettingsT]:
    """Where a robot's settings stand."""
    return Table(("robots", robot), f"the robot {robot}", kind)
