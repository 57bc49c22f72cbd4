"""The programs in a zip as learning platforms give it to a teacher."""

import hashlib
import re
import tempfile
import zipfile
from collections.abc import Iterator
from pathlib import Path, PurePosixPath

from learnblock.errors import LearnBlockError
from learnblock.lessons.archive import IGNORED
from learnblock.running.source import LARGEST_PROGRAM
from learnblock.runtime.limits import MEGABYTE

#: The files that can be graded.
ENDINGS = (".bt", ".py", ".learnblock")
#: What Moodle calls a pupil's folder, or puts before the names of a pupil's files.
MOODLE = re.compile(
    r"(?P<folder>(?P<pupil>.+?)_(?P<number>\d+)_assignsubmission_(?:file|onlinetext)_?)(?P<file>.*)"
)
#: The most entries of a zip, and the largest sum of the programs in it, in bytes.
MOST_ENTRIES, LARGEST_CLASS = 20_000, 256 * MEGABYTE
#: What file systems refuse in names, and the most bytes of a name.
_REFUSED, _LONGEST_NAME = re.compile(r'[<>:"\\|?*\x00-\x1f]'), 200


def unpacked(file: Path, folder: Path) -> Path:
    """Unpack the programs of a zip into a folder of their own, the same for the same zip.

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
    if target.exists():
        return target
    folder.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(dir=folder) as unfinished:
        inside = Path(unfinished, "unpacked")
        inside.mkdir()
        for number, (parts, program) in enumerate(_entries(file)):
            _write(inside.joinpath(*parts), number, program)
        inside.rename(target)
    return target


def _write(path: Path, number: int, program: bytes | None) -> None:
    """Write a program; of any other file only the folder that it is in."""
    path.parent.mkdir(parents=True, exist_ok=True)
    if program is not None:
        if path.exists():
            path = path.with_name(f"{number}{path.suffix}")
        path.write_bytes(program)


def _entries(file: Path) -> Iterator[tuple[list[str], bytes | None]]:
    """The parts of the path of each file in a zip, and its content if it is a program."""
    try:
        with zipfile.ZipFile(file) as archive:
            entries = [one for one in archive.infolist() if not IGNORED.search(one.filename)]
            _check_size(file, len(entries), 0)
            total = 0
            for entry in entries:
                parts = _parts(entry.filename)
                if entry.is_dir():
                    yield [*parts, "_"], None
                elif not parts[-1].endswith(ENDINGS):
                    yield parts, None
                else:
                    # A larger one is refused when it is read; the sizes in a zip may be false.
                    with archive.open(entry) as program:
                        content = program.read(LARGEST_PROGRAM + 1)
                    total += len(content)
                    _check_size(file, len(entries), total)
                    yield parts, content
    except LearnBlockError:
        raise
    except Exception as error:
        # zipfile raises errors of many kinds for damaged files.
        raise LearnBlockError("grade-zip-damaged", file=str(file)) from error


def _parts(filename: str) -> list[str]:
    """The parts of a path in a zip, as names that stay in their folder on every system.

    Without folders, Moodle puts a folder's name before the file's.
    """
    *outer, last = [part for part in PurePosixPath(filename).parts if part != "/"]
    if (moodle := MOODLE.fullmatch(last)) and moodle["file"]:
        outer, last = [*outer, moodle["folder"]], moodle["file"]
    return [*map(_allowed, outer), _allowed(last)]


def _allowed(part: str) -> str:
    ending = next((one for one in ENDINGS if part.endswith(one)), "")
    stem = _REFUSED.sub("_", part.removesuffix(ending)).strip(" .")
    kept = stem.encode(errors="replace")[:_LONGEST_NAME].decode(errors="ignore")
    return (kept or "_") + ending


def _check_size(file: Path, entries: int, total: int) -> None:
    if entries > MOST_ENTRIES or total > LARGEST_CLASS:
        raise LearnBlockError("grade-zip-too-large", file=str(file))
