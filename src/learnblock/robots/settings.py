"""What a real robot has to be told about itself: addresses, ports, sizes.

Each robot says what that is with a Struct of its own, whose fields have types, bounds, defaults and
descriptions. What the user has chosen stands in ``settings.toml`` of `learnblock.home`, in a table
for each robot:

    [robots.cozmo]
    address = "192.168.1.20"
"""

import tomllib
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated, Any, TypeVar

import msgspec
import tomli_w
from msgspec import Meta, inspect

from learnblock import description_file
from learnblock.errors import SettingsError, UnknownNameError
from learnblock.files import save
from learnblock.home import home

Address = Annotated[
    str, Meta(min_length=1, max_length=253, description="a name or number in the network")
]
Port = Annotated[int, Meta(ge=1, le=65535, description="a port of the network")]
Patience = Annotated[float, Meta(ge=0.1, le=60, description="until it must have answered, s")]


class RobotSettings(msgspec.Struct, frozen=True, forbid_unknown_fields=True, kw_only=True):
    """The base of every robot's settings; each field has a default."""


SettingsT = TypeVar("SettingsT", bound=RobotSettings)


@dataclass(frozen=True, slots=True)
class Described:
    """One setting, as a person is shown it.

    Args:
        name: of the setting.
        value: as it is now.
        default: as it is where nobody has chosen.
        allowed: what it may be, such as ``a whole number from 1 to 65535 (a port)``.
    """

    name: str
    value: Any
    default: Any
    allowed: str


def file() -> Path:
    """Where the user's settings stand; the file need not be there."""
    return home() / "settings.toml"


def load(robot: str, kind: type[SettingsT], chosen: Mapping[str, Any] | None = None) -> SettingsT:
    """The settings of a robot.

    Args:
        robot: its id, such as ``cozmo``.
        kind: what can be set.
        chosen: settings by name, which go before those of the file.

    Raises:
        SettingsError: a value or a name is wrong, in the file or among those chosen.
    """
    if not file().exists():
        return _converted(robot, kind, dict(chosen or {}))
    whole = description_file.read(file(), _file_kind(robot, kind), SettingsError, lambda _: ())
    saved: SettingsT = getattr(whole.robots, _identifier(robot))
    return _converted(robot, kind, {**_as_dict(saved), **(chosen or {})}) if chosen else saved


def change(robot: str, kind: type[SettingsT], name: str, text: str | None) -> SettingsT:
    """Set one setting, given as text, in the user's file; None puts its default back.

    Raises:
        UnknownNameError: the robot has no such setting.
        SettingsError: the value is wrong, or what stands in the file already is.
    """
    field = next((field for field in msgspec.structs.fields(kind) if field.name == name), None)
    if field is None:
        known = [field.name for field in msgspec.structs.fields(kind)]
        raise UnknownNameError(f"setting of the robot {robot}", name, known)
    present = load(robot, kind)
    value = field.default if text is None else _value(text, present, name)
    changed = _converted(robot, kind, {**_as_dict(present), name: value})
    _save(robot, changed)
    return changed


def describe(robot: str, kind: type[RobotSettings]) -> Iterator[Described]:
    """Every setting of a robot as it is now.

    Raises:
        SettingsError: what stands in the user's file is wrong.
    """
    present = load(robot, kind)
    for field, info in zip(msgspec.structs.fields(kind), _struct_type(kind).fields, strict=True):
        allowed = description_file.describe(info.type)
        yield Described(field.name, getattr(present, field.name), field.default, allowed)


def _converted(robot: str, kind: type[SettingsT], values: Mapping[str, Any]) -> SettingsT:
    name = f"settings of the robot {robot}"
    return description_file.convert(values, kind, SettingsError, lambda _: (), name=name)


def _value(text: str, present: RobotSettings, name: str) -> Any:
    """What a text typed on a command line means: a text stays one, all else is as in the file."""
    if isinstance(getattr(present, name), str):
        return text
    try:
        return tomllib.loads(f"value = {text}")["value"]
    except tomllib.TOMLDecodeError:
        # Told as the wrong value that it is.
        return text


def _save(robot: str, settings: RobotSettings) -> None:
    whole = tomllib.loads(file().read_text("utf-8")) if file().exists() else {}
    given = {
        field.name: getattr(settings, field.name)
        for field in msgspec.structs.fields(settings)
        if getattr(settings, field.name) != field.default
    }
    whole.setdefault("robots", {})[robot] = given
    save(file(), tomli_w.dumps(whole).encode())


def _as_dict(settings: RobotSettings) -> dict[str, Any]:
    return {field.name: getattr(settings, field.name) for field in msgspec.structs.fields(settings)}


def _file_kind(robot: str, kind: type[RobotSettings]) -> Any:
    """The whole file as far as it concerns this robot, so that mistakes are told by their line."""
    robots = msgspec.defstruct(
        "Robots",
        [(_identifier(robot), kind, kind())],
        rename={_identifier(robot): robot},
        frozen=True,
    )
    return msgspec.defstruct("Settings", [("robots", robots, robots())])


def _identifier(robot: str) -> str:
    return robot.replace("-", "_")


def _struct_type(kind: type[RobotSettings]) -> inspect.StructType:
    found = inspect.type_info(kind)
    assert isinstance(found, inspect.StructType)  # noqa: S101 - for the type checker
    return found
