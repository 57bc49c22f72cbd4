"""The file of a new world."""

from pathlib import Path

import msgspec

from learnblock.errors import NewNameError
from learnblock.new.template import fill
from learnblock.robots.simulated import check_file_name, known_worlds, own_worlds
from learnblock.simulator import WorldFile, write_world


def world_files(name: str, folder: Path, world: WorldFile | None = None) -> dict[Path, str]:
    """A new world.

    Args:
        name: the name of the world and its file.
        folder: `learnblock.storage.home.home`, or another folder with the same structure.
        world: what is in it; by default one object of most kinds.

    Raises:
        WorldError: the name is not allowed.
        NewNameError: a world of LearnBlock or a plugin has this name.
    """
    check_file_name(name)
    if name in known_worlds() and not (own_worlds() / f"{name}.toml").is_file():
        raise NewNameError("new-world-exists", name=name)
    title = name.replace("_", " ").replace("-", " ").capitalize()
    text = fill("world.toml", title=title)
    if world is not None:
        text = write_world(msgspec.structs.replace(world, title=title), name)
    return {folder / "worlds" / f"{name}.toml": text}
