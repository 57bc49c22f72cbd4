"""A world that can leave this computer: as a value, and as ``NAME.toml`` or ``NAME.zip``."""

import re
import unicodedata
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path, PurePosixPath
from tempfile import TemporaryDirectory

import msgspec

from learnblock.errors import Diagnostic, WorldError
from learnblock.i18n import Phrase
from learnblock.robots.simulated import check_file_name, find_world
from learnblock.simulator import WorldDescription
from learnblock.storage import toml_source
from learnblock.storage.archive import Rules, unzipped, zipped

_NOT_IN_NAMES = re.compile(r"[^\w -]+")
_LONGEST_NAME = 40
ENDINGS = (".toml", ".zip")
#: The limit in bytes of a file, packed and unpacked: the largest picture and a world's file.
LARGEST = 12 * 1024 * 1024
#: A system adds files of its own to a zip.
MOST_FILES = 20
_TOO_LARGE = Phrase("world-file-too-large", limit=LARGEST // 1024**2)
_RULES = Rules(
    WorldError,
    entries=MOST_FILES,
    total=LARGEST,
    file=LARGEST,
    damaged=Phrase("world-zip-damaged"),
    too_many=Phrase("world-zip-too-many", most=MOST_FILES),
    too_large=_TOO_LARGE,
)


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


def is_same(first: WorldDescription, other: WorldDescription) -> bool:
    """Whether two worlds are the same apart from their names and titles."""
    return _bare(first) == _bare(other) and picture_of(first) == picture_of(other)


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


def pack(world: PackedWorld) -> tuple[str, bytes]:
    """The name and the bytes of a world as one file."""
    text = world.text.encode()
    picture = picture_name(world)
    if world.picture is None or picture is None:
        return f"{world.name}.toml", text
    files = {f"{world.name}.toml": text, picture: world.picture}
    return f"{world.name}.zip", zipped(files)


def unpack(filename: str, content: bytes) -> PackedWorld:
    """The world in a file, not checked yet.

    Raises:
        WorldError: the file has another type, is damaged or too large.
    """
    if len(content) > LARGEST:
        raise _wrong(filename, "too-large", _TOO_LARGE)
    stem = PurePosixPath(filename.replace("\\", "/")).stem
    if filename.endswith(".toml"):
        return PackedWorld(plain_name(stem), _text(content, filename))
    if not filename.endswith(".zip"):
        raise _wrong(filename, "unknown-file", Phrase("world-file-type"))
    return _world(unzipped(filename, content, _RULES), filename)


def _world(contents: dict[str, bytes], filename: str) -> PackedWorld:
    files = {PurePosixPath(path): content for path, content in contents.items()}
    paths = [path for path in files if path.suffix == ".toml"]
    if len(paths) != 1:
        raise _wrong(filename, "no-world", Phrase("world-zip-contents", count=len(paths)))
    (path,) = paths
    world = PackedWorld(plain_name(path.stem), _text(files[path], path.name))
    picture = picture_name(world)
    content = files.get(path.parent / picture) if picture else None
    return PackedWorld(world.name, world.text, content)


def _text(content: bytes, filename: str) -> str:
    if len(content) > toml_source.MAXIMUM_FILE_SIZE:
        limit = Phrase(
            "file-too-many-bytes", size=len(content), limit=toml_source.MAXIMUM_FILE_SIZE
        )
        raise _wrong(filename, "too-large", limit)
    try:
        return content.decode("utf-8-sig").replace("\r\n", "\n")
    except UnicodeDecodeError:
        raise _wrong(filename, "not-utf-8", Phrase("library-not-utf-8")) from None


def _wrong(filename: str, code: str, message: Phrase) -> WorldError:
    return WorldError(filename, [Diagnostic(code, message)])
