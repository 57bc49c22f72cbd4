"""The file of a new world."""

from pathlib import Path

from learnblock.errors import NewNameError
from learnblock.new.template import fill
from learnblock.robots.simulated import check_file_name, known_worlds, own_worlds


def world_files(name: str, folder: Path) -> dict[Path, str]:
    """A new world with one object of most kinds.

    Args:
        name: the name of the world and its file.
        folder: `learnblock.storage.home.home`, or another folder with the same structure.

    Raises:
        WorldError: the name is not allowed.
        NewNameError: a world of LearnBlock or a plugin has this name.
    """
    check_file_name(name)
    if name in known_worlds() and not (own_worlds() / f"{name}.toml").is_file():
        raise NewNameError("new-world-exists", name=name)
    title = name.replace("_", " ").replace("-", " ").capitalize()
    return {folder / "worlds" / f"{name}.toml": fill("world.toml", title=title)}
