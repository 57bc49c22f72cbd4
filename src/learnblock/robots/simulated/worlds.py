"""All worlds: built in, in the user's folder and from plugins."""

import re
from collections.abc import Iterator
from pathlib import Path

from learnblock.errors import Diagnostic, UnknownNameError, WorldError
from learnblock.i18n import Phrase
from learnblock.simulator import WorldDescription, load_world, world_names
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
    from importlib.metadata import entry_points  # noqa: PLC0415 - see `find_world`
    from importlib.util import find_spec  # noqa: PLC0415

    for point in entry_points(group="learnblock.worlds"):
        found = find_spec(point.module)
        if found and found.submodule_search_locations:
            yield Path(found.submodule_search_locations[0])
