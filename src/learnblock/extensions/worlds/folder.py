"""The user's own worlds, in the folder ``worlds`` of `home`; deleted ones are in ``.trash``."""

from collections.abc import Collection, Iterator
from itertools import count
from pathlib import Path, PurePosixPath

import msgspec

from learnblock.errors import Diagnostic, LearnBlockError, UnknownNameError, WorldError
from learnblock.extensions.worlds.packed_world import PackedWorld, is_same, picture_of, staged
from learnblock.i18n import Phrase
from learnblock.robots.simulated import find_world, known_worlds, own_worlds
from learnblock.simulator import WorldDescription, WorldFile, write_world
from learnblock.storage.files import save


def own_names() -> tuple[str, ...]:
    """The names of the user's own worlds."""
    return tuple(sorted(path.stem for path in own_worlds().glob("*.toml")))


def find(name: str) -> PackedWorld:
    """A world, with everything that belongs to it.

    Raises:
        UnknownNameError: there is no such world.
        WorldError: it is invalid.
        OSError: it can't be read.
    """
    _require(name, known_worlds())
    world = find_world(name)
    text = Path(world.folder, f"{name}.toml").read_text("utf-8-sig")
    return PackedWorld(name, text, picture_of(world))


def install(packed: PackedWorld) -> str:
    """Save a world under its name, or under a free one if another world has it.

    Returns:
        The name under which the world is known now; an equal world is used as it is.

    Raises:
        WorldError: the world or its name is invalid.
        OSError: it can't be written.
    """
    with staged(packed) as file:
        coming = find_world(str(file))
        for number, name in _names_like(packed.name):
            if _is_free(name):
                _write(packed, coming, name, number)
                return name
            if _has(name, coming):
                return name
    raise AssertionError  # the names are endless


def rename(name: str, title: str) -> None:
    """Give one of the user's worlds another title; programs still know it by its name.

    Raises:
        UnknownNameError: there is no such world.
        WorldError: it is invalid, or can't have this title.
        OSError: it can't be written.
    """
    path = _own(name)
    renamed = msgspec.structs.replace(_file(find_world(name)), title=title)
    save(path, write_world(renamed, name).encode())


def delete(name: str) -> None:
    """Move one of the user's worlds into the trash; `restore` undoes this.

    Raises:
        UnknownNameError: there is no such world.
        OSError: it can't be moved.
    """
    path = _own(name)
    trash = _trash(name)
    trash.parent.mkdir(exist_ok=True)
    path.replace(trash)


def restore(name: str) -> None:
    """Take a world out of the trash.

    Raises:
        UnknownNameError: it is not there.
        WorldError: there is now another world with its name.
        OSError: it can't be moved.
    """
    _require(name, [path.stem for path in _trash(name).parent.glob("*.toml")])
    if name in own_names():
        message = Phrase("server-world-exists", name=name)
        raise WorldError(name, [Diagnostic("name-taken", message)])
    _trash(name).replace(own_worlds() / f"{name}.toml")


def _own(name: str) -> Path:
    _require(name, own_names())
    return own_worlds() / f"{name}.toml"


def _trash(name: str) -> Path:
    return own_worlds() / ".trash" / f"{name}.toml"


def _require(name: str, names: Collection[str]) -> None:
    if name not in names:
        raise UnknownNameError("world", name, names)


def _names_like(name: str) -> Iterator[tuple[int, str]]:
    yield 1, name
    for number in count(2):
        yield number, f"{name[:36]}-{number}"


def _is_free(name: str) -> bool:
    # Windows and macOS ignore case in file names.
    return name.casefold() not in {world.casefold() for world in known_worlds()}


def _has(name: str, world: WorldDescription) -> bool:
    """Whether the world with a name is this one."""
    try:
        return is_same(find_world(name), world)
    except (LearnBlockError, OSError):
        # A broken world is left alone.
        return False


def _write(packed: PackedWorld, world: WorldDescription, name: str, number: int) -> None:
    picture = world.floor.picture
    if packed.picture is not None and picture:
        picture = _save_picture(PurePosixPath(picture).name, name, packed.picture)
    text = packed.text
    if number > 1 or picture != world.floor.picture:
        floor = msgspec.structs.replace(world.floor, picture=picture)
        title = f"{(world.title or packed.name)[:190]} {number}" if number > 1 else world.title
        text = write_world(msgspec.structs.replace(_file(world), title=title, floor=floor), name)
    save(own_worlds() / f"{name}.toml", text.encode())


def _save_picture(wish: str, world: str, content: bytes) -> str:
    """Save a floor picture under a name that no other picture has; return the name."""
    wishes = [wish] if wish.endswith(".png") else []
    numbered = (f"{world}-{number}.png" for number in count(2))
    for name in (*wishes, f"{world}.png"):
        if _take(name, content):
            return name
    return next(name for name in numbered if _take(name, content))


def _take(name: str, content: bytes) -> bool:
    """Save a picture unless another one has its name."""
    path = own_worlds() / name
    if path.is_file():
        return path.read_bytes() == content
    if path.exists():
        return False
    save(path, content)
    return True


def _file(world: WorldDescription) -> WorldFile:
    return WorldFile(**{field: getattr(world, field) for field in WorldFile.__struct_fields__})
