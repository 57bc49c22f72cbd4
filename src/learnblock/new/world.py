"""The file of a new world."""

from pathlib import Path

from learnblock.errors import NewNameError
from learnblock.new.template import fill
from learnblock.robots.simulated import known_worlds, own_worlds
from learnblock.robots.worlds import check_name


def world_files(name: str, folder: Path) -> dict[Path, str]:
    """A world with one thing of most kinds, to be changed.

    Args:
        name: of the world and its file.
        folder: a user's own, `learnblock.home.home`, or another of that kind.

    Raises:
        WorldError: it is no name of a world.
        NewNameError: there is one of ours, or of a plugin, that has it.
    """
    check_name(name)
    if name in known_worlds() and not (own_worlds() / f"{name}.toml").is_file():
        raise NewNameError(f"there is a world `{name}` already: choose another name")
    title = name.replace("_", " ").replace("-", " ").capitalize()
    return {folder / "worlds" / f"{name}.toml": fill("world.toml", title=title)}
