"""Settings as the page edits them, and what a page may choose."""

import re
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any, Literal

from msgspec import inspect

from learnblock import description_file, robots, vision
from learnblock.errors import LearnBlockError
from learnblock.home import home
from learnblock.robots.settings import table as robot_table
from learnblock.server.messages import Setting
from learnblock.settings import Table

Sort = Literal["text", "number", "whole", "choice", "boolean", "list"]

_SECRET = ("password", "token")
_DEVICE = re.compile(r"(?:/dev/[\w-]+(?:/[\w-]+)*|COM\d{1,3})?")


def table(robot: str) -> Table[Any]:
    """The settings of a real robot, or of perception where no robot is named.

    Raises:
        LearnBlockError: there is no such robot, or nothing can be set about it.
    """
    from learnblock.robots.real import RealRobot  # noqa: PLC0415 - the server answers first

    if not robot:
        return vision.TABLE
    found = robots.find(robot).load()
    if not issubclass(found, RealRobot):
        raise LearnBlockError(f"the robot `{robot}` has no settings: it is no real one")
    return robot_table(found.name(), found.settings_type)


def described(settings: Table[Any]) -> Iterator[Setting]:
    """Every setting of a table as it is now.

    Raises:
        SettingsError: what stands in the user's file is wrong.
    """
    found = inspect.type_info(settings.kind)
    assert isinstance(found, inspect.StructType)  # noqa: S101 - for the type checker
    for one, field in zip(settings.describe(), found.fields, strict=True):
        kind = description_file.bare(field.type)
        yield Setting(
            name=one.name,
            sort=_sort(kind),
            value=one.value,
            default=one.default,
            allowed=description_file.describe(kind),
            description=_description(field.type),
            **_bounds(kind),
            choices=tuple(map(str, description_file.choices(kind))),
            secret=one.name in _SECRET,
        )


def chosen(settings: Table[Any], values: Mapping[str, Any]) -> dict[str, Any]:
    """The values that a page has chosen, None being the default.

    Raises:
        LearnBlockError: a value names a file that no page may name.
    """
    defaults = {one.name: one.default for one in settings.describe()}
    return {
        name: defaults.get(name) if value is None else _permitted(name, value)
        for name, value in values.items()
    }


def videos() -> Path:
    """Where the videos lie that a page may choose from."""
    return home() / "videos"


def _permitted(name: str, value: Any) -> Any:
    """Whoever has the page has not yet the run of this machine's files."""
    if name == "video" and value:
        return _video(str(value))
    if name == "device" and not _DEVICE.fullmatch(str(value)):
        raise LearnBlockError(
            f"`device` is {value!r:.60}: from the page it can be a device alone, such as"
            " /dev/ttyACM0 or COM3"
        )
    return value


def _video(name: str) -> str:
    known = {path.name: path for path in videos().glob("*") if path.is_file()}
    present = {str(path): path for path in known.values()}
    found = known.get(name) or present.get(name)
    if found is None:
        raise LearnBlockError(
            f"there is no video {name!r:.80} in {videos()}: from the page it can be the name of a"
            " file in that folder alone; put the video there"
        )
    return str(found)


def _sort(kind: inspect.Type) -> Sort:
    sorts: dict[type[inspect.Type], Sort] = {
        inspect.BoolType: "boolean",
        inspect.IntType: "whole",
        inspect.FloatType: "number",
        inspect.LiteralType: "choice",
        inspect.TupleType: "list",
        inspect.VarTupleType: "list",
    }
    found = [sorts.get(type(one), "text") for one in description_file.alternatives(kind)]
    return next((one for one in found if one != "choice"), found[0])


def _bounds(kind: inspect.Type) -> dict[str, Any]:
    for one in description_file.alternatives(kind):
        if isinstance(one, inspect.IntType | inspect.FloatType):
            return {"least": one.ge, "most": one.le}
    return {}


def _description(kind: inspect.Type) -> str:
    if not isinstance(kind, inspect.Metadata):
        return ""
    return str((kind.extra_json_schema or {}).get("description", "")) or _description(kind.type)
