"""Settings as the page edits them, and the values that a page may choose."""

import re
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any, Literal

from msgspec import inspect

from learnblock import robots
from learnblock.errors import LearnBlockError
from learnblock.i18n import Phrase
from learnblock.perception import sources
from learnblock.robots.settings import table as robot_table
from learnblock.server.messages import Setting
from learnblock.storage import struct_types
from learnblock.storage.home import home
from learnblock.storage.settings import SettingsSection

Sort = Literal["text", "number", "whole", "choice", "boolean", "list"]

_SECRET = ("password", "token")
_DEVICE = re.compile(r"(?:/dev/[\w-]+(?:/[\w-]+)*|COM\d{1,3})?")


def table(robot: str) -> SettingsSection[Any]:
    """The settings for a real robot; for an empty name, those for camera recognition.

    Raises:
        LearnBlockError: there is no such robot, or it is simulated.
    """
    from learnblock.robots.real import RealRobot  # noqa: PLC0415 - the server answers first

    if not robot:
        return sources.TABLE
    robot_type = robots.find(robot).load()
    if not issubclass(robot_type, RealRobot):
        raise LearnBlockError("settings-simulated", robot=robot)
    return robot_table(robot_type.name(), robot_type.settings_type)


def described(settings: SettingsSection[Any]) -> Iterator[Setting]:
    """Describe every setting in a table with its current value.

    Raises:
        SettingsError: the user's file is invalid.
    """
    struct = inspect.type_info(settings.kind)
    assert isinstance(struct, inspect.StructType)  # noqa: S101 - for the type checker
    for setting, field in zip(settings.describe(), struct.fields, strict=True):
        kind = struct_types.bare(field.type)
        yield Setting(
            name=setting.name,
            sort=_sort(kind),
            value=setting.value,
            default=setting.default,
            allowed=struct_types.describe(kind),
            description=_description(field.type),
            **_bounds(kind),
            choices=tuple(map(str, struct_types.choices(kind))),
            secret=setting.name in _SECRET,
        )


def chosen(settings: SettingsSection[Any], values: Mapping[str, Any]) -> dict[str, Any]:
    """Check the values from a page; None means the default.

    Raises:
        LearnBlockError: a value is a path that pages must not use.
    """
    defaults = {setting.name: setting.default for setting in settings.describe()}
    return {
        name: defaults.get(name) if value is None else _permitted(name, value)
        for name, value in values.items()
    }


def videos() -> Path:
    """The folder of the videos that a page may choose from."""
    return home() / "videos"


# Why: docs/decisions.md, "A page may set less than the command line"
def _permitted(name: str, value: Any) -> Any:
    """Refuse paths: a page must not choose arbitrary files on this computer."""
    if name == "video" and value:
        return _video(str(value))
    if name == "device" and not _DEVICE.fullmatch(str(value)):
        raise LearnBlockError("settings-device", value=str(value)[:60])
    return value


def _video(name: str) -> str:
    paths = {path.name: path for path in videos().glob("*") if path.is_file()}
    present = {str(path): path for path in paths.values()}
    path = paths.get(name) or present.get(name)
    if path is None:
        raise LearnBlockError("settings-video", name=name[:80], folder=str(videos()))
    return str(path)


def _sort(kind: inspect.Type) -> Sort:
    sorts: dict[type[inspect.Type], Sort] = {
        inspect.BoolType: "boolean",
        inspect.IntType: "whole",
        inspect.FloatType: "number",
        inspect.LiteralType: "choice",
        inspect.TupleType: "list",
        inspect.VarTupleType: "list",
    }
    candidates = [
        sorts.get(type(alternative), "text") for alternative in struct_types.alternatives(kind)
    ]
    return next((sort for sort in candidates if sort != "choice"), candidates[0])


def _bounds(kind: inspect.Type) -> dict[str, Any]:
    for alternative in struct_types.alternatives(kind):
        if isinstance(alternative, inspect.IntType | inspect.FloatType):
            return {"least": alternative.ge, "most": alternative.le}
    return {}


def _description(kind: inspect.Type) -> Phrase | None:
    if not isinstance(kind, inspect.Metadata):
        return None
    description = (kind.extra_json_schema or {}).get("description")
    return Phrase(description) if description else _description(kind.type)
