"""The programs in a zip as learning platforms give it to a teacher."""

import errno
import hashlib
import re
import tempfile
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path, PurePosixPath

from learnblock.errors import LearnBlockError
from learnblock.running.source import LARGEST_PROGRAM
from learnblock.runtime.limits import MEGABYTE
from learnblock.storage.archive import DEEPEST, Entry, RefusedError, ZipReader, ZipRule

#: The files that can be graded.
ENDINGS = (".bt", ".py", ".learnblock")
#: The name of a program, however its ending is written; systems that hide endings add a second one.
_PROGRAM = re.compile(
    r"(?P<stem>.+?)(?P<ending>\.bt|\.py|\.learnblock)(?:\.txt|\.json|\.download)*", re.I | re.S
)
#: What Moodle calls a pupil's folder, or puts before the names of a pupil's files.
MOODLE = re.compile(
    r"(?P<folder>(?P<pupil>.+?)_(?P<number>\d+)_assignsubmission_(?:file|onlinetext)_?)(?P<file>.*)"
)
#: The most entries of a zip, and the largest sum of the programs in it, in bytes.
MOST_ENTRIES, LARGEST_CLASS = 20_000, 256 * MEGABYTE
#: The largest zip inside a zip, in bytes.
LARGEST_INNER = 16 * MEGABYTE
#: What file systems refuse in names, and the most bytes of a name.
_REFUSED, _LONGEST_NAME = re.compile(r'[<>:"\\|?*\x00-\x1f]'), 200
#: How a system refuses a path: it is too long, leads through a file, or has a name it can't have.
_IMPOSSIBLE = {
    errno.EEXIST,
    errno.EILSEQ,
    errno.EINVAL,
    errno.ENAMETOOLONG,
    errno.ENOENT,
    errno.ENOTDIR,
}
#: The file in an unpacked zip with the names of what was left out.
_LEFT_OUT = ".left-out"
_ZIP = ".zip"


@dataclass(frozen=True, slots=True)
class Unpacked:
    """An unpacked zip.

    Args:
        folder: the folder with its programs.
        left_out: the names of entries that can't be unpacked.
    """

    folder: Path
    left_out: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class _File:
    """A file or a folder in a zip.

    Args:
        name: as it is written in the zip.
        parts: of its path, as names that stay in their folder on every system.
        content: of a program; None of anything else.
        is_damaged: whether it is a program or a zip that can't be read, or is none of a person.
    """

    name: str
    parts: Sequence[str]
    content: bytes | None = None
    is_damaged: bool = False


def program_name(name: str) -> str | None:
    """The name of a program with its ending as we write it; None for any other file.

    It is ``square.bt`` for ``square.BT`` and ``square.bt.txt``, too.
    """
    match = _PROGRAM.fullmatch(name.rstrip())
    return match["stem"] + match["ending"].lower() if match else None


def unpacked(file: Path, folder: Path) -> Unpacked:
    """Unpack the programs of a zip into a folder of their own, the same for the same zip.

    Zips inside it, as pupils make them of their folders, are unpacked into folders.

    Args:
        file: the zip.
        folder: the folder for the new one.

    Raises:
        LearnBlockError: the zip is damaged, encrypted or too large.
        OSError: it can't be read, or the folder can't be written.
    """
    with file.open("rb") as zipped:
        digest = hashlib.file_digest(zipped, "sha256").hexdigest()
    target = folder / f"{file.stem}-{digest[:8]}"
    if not target.exists():
        folder.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryDirectory(dir=folder) as unfinished:
            inside = Path(unfinished, "unpacked")
            inside.mkdir()
            if left_out := _write_all(file, inside):
                (inside / _LEFT_OUT).write_text("\n".join(left_out), "utf-8", "replace")
            inside.rename(target)
    left = target / _LEFT_OUT
    return Unpacked(target, tuple(left.read_text("utf-8").split("\n")) if left.exists() else ())


def _write_all(file: Path, folder: Path) -> list[str]:
    """Write the programs of a zip; return the names of the entries that are left out."""
    left_out: list[str] = []
    programs = damaged = 0
    for number, entry in enumerate(_all_files(file)):
        damaged += entry.is_damaged
        if entry.is_damaged or not _write(folder, number, entry):
            left_out.append(_printable(entry.name)[:_LONGEST_NAME])
        programs += entry.content is not None
    if damaged and not programs:
        raise LearnBlockError("grade-zip-damaged", file=str(file))
    return left_out


def _write(folder: Path, number: int, entry: _File) -> bool:
    """Write a program, and of any other file only its folder; return whether that is possible."""
    if len(entry.parts) > DEEPEST:
        return False
    path = folder.joinpath(*entry.parts)
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        if entry.content is not None:
            if path.exists():
                path = path.with_name(f"{number}{path.suffix}")
            path.write_bytes(entry.content)
    except OSError as error:
        if error.errno in _IMPOSSIBLE:
            return False
        raise
    return True


def _printable(name: str) -> str:
    return "".join(letter if letter.isprintable() else "_" for letter in name)


def _all_files(file: Path) -> Iterator[_File]:
    """What is in a zip.

    Raises:
        LearnBlockError: it is damaged or too large.
    """
    reader = ZipReader(MOST_ENTRIES, LARGEST_CLASS)
    try:
        with file.open("rb") as opened:
            yield from _files(reader, reader.entries(opened), ())
    except RefusedError as refused:
        code = "grade-zip-too-large" if _is_of_all(refused) else "grade-zip-damaged"
        raise LearnBlockError(code, file=str(file)) from refused


def _files(reader: ZipReader, entries: Iterator[Entry], outer: tuple[str, ...]) -> Iterator[_File]:
    """The programs in a zip, those in zips inside it, and the folders of all other files."""
    for entry in entries:
        if not (names := _parts(entry.name)):
            continue
        parts = (*outer, *names)
        if entry.is_folder:
            yield _File(entry.name, (*parts, "_"))
        elif program_name(parts[-1]):
            yield _program(reader, entry, parts)
        elif parts[-1].lower().endswith(_ZIP) and not outer:
            yield from _inner(reader, entry, parts)
        else:
            yield _File(entry.name, parts)


def _program(reader: ZipReader, entry: Entry, parts: Sequence[str]) -> _File:
    try:
        # A larger one is refused when it is read.
        return _File(entry.name, parts, reader.read(entry, LARGEST_PROGRAM + 1))
    except RefusedError as refused:
        if _is_of_all(refused):
            raise
        return _File(entry.name, parts, is_damaged=True)


def _inner(reader: ZipReader, entry: Entry, parts: Sequence[str]) -> Iterator[_File]:
    """What is in a zip inside, in a folder with its name."""
    *outer, name = parts
    folder = (*outer, name[: -len(_ZIP)] or "_")
    # Its pupil has a folder, whatever is in it.
    yield _File(entry.name, (*folder, "_"))
    try:
        yield from _files(reader, reader.inner(entry, LARGEST_INNER), folder)
    except RefusedError as refused:
        if _is_of_all(refused):
            raise
        yield _File(entry.name, folder, is_damaged=True)


def _is_of_all(refused: RefusedError) -> bool:
    """Whether there is too much in the zip, and not just an entry that is wrong."""
    return refused.rule in {ZipRule.TOO_MANY_FILES, ZipRule.TOO_LARGE}


def _parts(filename: str) -> list[str]:
    """The parts of a path in a zip, as names that stay in their folder on every system.

    There are none if it leads out of its folder.

    Without folders, Moodle puts a folder's name before the file's.
    """
    parts = [part for part in PurePosixPath(filename).parts if part not in {"/", "//"}]
    if not parts or ".." in parts:
        return []
    *outer, last = parts
    if (moodle := MOODLE.fullmatch(last)) and moodle["file"]:
        outer, last = [*outer, moodle["folder"]], moodle["file"]
    return [*map(_allowed, outer), _allowed(program_name(last) or last)]


def _allowed(part: str) -> str:
    ending = next((suffix for suffix in (*ENDINGS, _ZIP) if part.lower().endswith(suffix)), "")
    stem = _REFUSED.sub("_", part[: len(part) - len(ending)]).strip(" .")
    name = stem.encode(errors="replace")[:_LONGEST_NAME].decode(errors="ignore")
    return (name or "_") + part[len(part) - len(ending) :]
