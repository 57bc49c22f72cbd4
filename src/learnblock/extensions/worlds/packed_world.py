"""A world as a value that can leave this computer: its file, and its floor picture."""

import re
import unicodedata
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from tempfile import TemporaryDirectory

import msgspec

from learnblock.errors import WorldError
from learnblock.robots.simulated import check_file_name, find_world
from learnblock.simulator import WorldDescription
from learnblock.storage import toml_source

_NOT_IN_NAMES = re.compile(r"[^\w -]+")
_LONGEST_NAME = 40


@dataclass(frozen=True)
class PackedWorld:
    """A world with everything that its file names.

    Args:
        name: the name of the world.
        text: the text of its file.
        picture: the PNG of its floor, if it has one.
    """

    name: str
    text: str
    picture: bytes | None = None


@contextmanager
def staged(packed: PackedWorld) -> Iterator[Path]:
    """Write a world into a temporary folder, and check it; yield the path of its file.

    Raises:
        WorldError: the world or its name is invalid.
    """
    check_file_name(packed.name)
    with TemporaryDirectory(prefix="learnblock-") as folder:
        file = Path(folder).resolve() / f"{packed.name}.toml"
        file.write_text(packed.text, "utf-8", newline="\n")
        _stage_picture(packed, file.parent)
        find_world(str(file))
        yield file


def is_same(one: WorldDescription, other: WorldDescription) -> bool:
    """Whether two worlds are the same apart from their names and titles."""
    return _bare(one) == _bare(other) and picture_of(one) == picture_of(other)


def picture_of(world: WorldDescription) -> bytes | None:
    """The PNG of a world's floor.

    Raises:
        OSError: it can't be read.
    """
    name = world.floor.picture
    return Path(world.folder, name).read_bytes() if name else None


def plain_name(wish: str) -> str:
    """Convert any string to the name of a world, which is empty if nothing is left."""
    plain = _NOT_IN_NAMES.sub(" ", unicodedata.normalize("NFC", wish))
    return " ".join(plain.split())[:_LONGEST_NAME].strip(" -")


def _stage_picture(packed: PackedWorld, folder: Path) -> None:
    name = picture_name(packed)
    if packed.picture is None or name is None or "\0" in name:
        return
    target = (folder / name).resolve()
    # The check of the world reports a picture outside its folder.
    if target.is_relative_to(folder) and not target.exists():
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_bytes(packed.picture)


def picture_name(packed: PackedWorld) -> str | None:
    """The path of the floor picture as the file names it.

    Raises:
        WorldError: the file is not TOML.
    """
    floor = toml_source.parse(packed.text, f"{packed.name}.toml", WorldError).get("floor")
    name = floor.get("picture") if isinstance(floor, dict) else None
    return name if isinstance(name, str) and name else None


def _bare(world: WorldDescription) -> WorldDescription:
    floor = msgspec.structs.replace(world.floor, picture=None)
    return msgspec.structs.replace(world, name="", title="", folder="", floor=floor)
