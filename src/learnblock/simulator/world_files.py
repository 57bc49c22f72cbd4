"""Worlds read from files and written to them, and the worlds that come with LearnBlock."""

from collections.abc import Mapping, Sequence
from functools import cache, lru_cache
from pathlib import Path
from typing import Any

from learnblock.errors import WorldError
from learnblock.simulator.world_check import check_world
from learnblock.simulator.world_description import WorldDescription, WorldFile
from learnblock.storage import toml_source

SHIPPED_WORLDS = Path(__file__).parent / "worlds"


def load_world(name_or_path: str | Path, folders: Sequence[Path] = ()) -> WorldDescription:
    """Load the description of a world.

    Args:
        name_or_path: the name of a world in `folders` or a built-in one, or a path ending in .toml.
        folders: the folders to search before ours, in this order.

    Raises:
        UnknownNameError: there is no such world.
        WorldError: the file is invalid.
    """
    file = toml_source.locate("world", name_or_path, [*folders, SHIPPED_WORLDS])
    return _shipped(file) if file.parent == SHIPPED_WORLDS else _read(file)


def _read(file: Path) -> WorldDescription:
    text = toml_source.text_of(file, WorldError)
    world = _last_described(file, text)
    # The file of a picture may have gone since.
    return world if world.floor.picture is None else _described(file, text)


def _described(file: Path, text: str) -> WorldDescription:
    world = toml_source.read_text(
        text, file.name, WorldFile, WorldError, lambda world: check_world(world, file.parent)
    )
    values = {field: getattr(world, field) for field in WorldFile.__struct_fields__}
    return WorldDescription(name=file.stem, folder=str(file.parent), **values)


#: Many runs in the same world follow each other.
_last_described = lru_cache(maxsize=8)(_described)
#: Reading them all takes a tenth of a second, each time that a page opens.
_shipped = cache(_read)


def read_world(values: Mapping[str, Any], folder: Path) -> WorldFile:
    """Create a world from values, such as an editor's; its floor picture is in `folder`.

    Raises:
        WorldError: they are invalid.
    """
    return toml_source.convert(
        values, WorldFile, WorldError, lambda world: check_world(world, folder), name="world.toml"
    )


def write_world(world: WorldFile, name: str) -> str:
    """Format a world as the text of its file.

    Raises:
        WorldError: it would be larger than `load_world` accepts.
    """
    return toml_source.write(world, f"{name}.toml", WorldError)


def world_names(folders: Sequence[Path] = ()) -> tuple[str, ...]:
    """The worlds of `folders` and ours, in alphabetical order."""
    return tuple(toml_source.names([*folders, SHIPPED_WORLDS]))
