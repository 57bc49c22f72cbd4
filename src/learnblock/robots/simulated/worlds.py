"""All worlds: built in, in the user's folder and from plugins."""

import re
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

import msgspec
from msgspec import structs

from learnblock.errors import Diagnostic, UnknownNameError, WorldError
from learnblock.i18n import Phrase
from learnblock.simulator import WorldDescription, WorldFile, load_world, read_world, world_names
from learnblock.storage import installed
from learnblock.storage.files import is_device_name
from learnblock.storage.home import home

_NAME = re.compile(r"\w(?:[\w -]{0,38}\w)?")


def find_world(name_or_path: str) -> WorldDescription:
    """Find a world by its path, or by its name: in the user's folder, built in or from a plugin.

    Raises:
        UnknownNameError: there is no such world.
        WorldError: its file is invalid.
    """
    try:
        return load_world(name_or_path, folders=(own_worlds(),))
    except UnknownNameError:
        # Plugins last: finding them means searching all installed packages.
        return load_world(name_or_path, folders=(own_worlds(), *_plugin_worlds()))


def worlds() -> Iterator[WorldDescription]:
    """Every world: built in, the user's and from plugins."""
    for name in known_worlds():
        yield find_world(name)


def known_worlds() -> tuple[str, ...]:
    """The names of all worlds."""
    return world_names(folders=(own_worlds(), *_plugin_worlds()))


def described_world(world: WorldDescription) -> dict[str, Any]:
    """A world as plain data, without the folder of its picture."""
    data: dict[str, Any] = msgspec.to_builtins(structs.replace(world, folder=""))
    return data


def world_of_data(data: Mapping[str, Any]) -> WorldDescription:
    """The world that `described_world` described, perhaps on another computer.

    Its floor's picture, which is not part of the data, is that of the same world here.

    Raises:
        WorldError: the data is not a world.
        UnknownNameError: its floor has a picture, and there is no such world here.
    """
    values = {name: value for name, value in data.items() if name in WorldFile.__struct_fields__}
    name, variant = str(data.get("name", "world")), data.get("variant", 0)
    has_picture = bool((data.get("floor") or {}).get("picture"))
    folder = find_world(name).folder if has_picture else ""
    world = read_world(values, Path(folder))
    fields = {field: getattr(world, field) for field in WorldFile.__struct_fields__}
    return WorldDescription(
        name=name, folder=folder, variant=variant if isinstance(variant, int) else 0, **fields
    )


def own_worlds() -> Path:
    """The folder of the user's worlds, which may not exist."""
    return home() / "worlds"


def check_file_name(name: str) -> None:
    """Check the name of a world's file.

    Raises:
        WorldError: the name is not allowed.
    """
    if not _NAME.fullmatch(name) or is_device_name(name):
        raise WorldError(name, [Diagnostic("wrong-name", Phrase("world-bad-name", name=name))])


def _plugin_worlds() -> Iterator[Path]:
    """The folders of the packages named by entry points of the group ``learnblock.worlds``."""
    from importlib.util import find_spec  # noqa: PLC0415

    for point in installed.entry_points("learnblock.worlds"):
        spec = find_spec(point.module)
        if spec and spec.submodule_search_locations:
            yield Path(spec.submodule_search_locations[0])
