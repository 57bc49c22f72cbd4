"""The files of a lesson: read from a folder or a zip within limits, and zipped."""

import io
import re
import stat
import zipfile
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import NoReturn

from learnblock.errors import Diagnostic, LessonError
from learnblock.i18n import Phrase
from learnblock.runtime.limits import MEGABYTE
from learnblock.storage import zip_names

SUFFIX = ".lblesson"
#: The largest zip, and the largest sum of the files in it, in bytes.
LARGEST, LARGEST_TOTAL = 16 * MEGABYTE, 32 * MEGABYTE
#: The largest file, in bytes.
LARGEST_FILE = 8 * MEGABYTE
MOST_FILES = 300
#: How many bytes one byte of a zip may become: pictures become 1, texts 10, bombs 1,000.
LARGEST_RATIO = 100
#: Files so small may become any number of bytes.
_SMALL = 64 * 1024

_PROGRAM, _PICTURE = r"[\w-]{1,60}\.(?:bt|py)", r"[\w-]{1,60}\.(?:png|jpg|jpeg|svg)"
#: The files that a lesson can have.
_KNOWN = re.compile(
    rf"lesson\.toml|checks\.py|programs/{_PROGRAM}|pictures/{_PICTURE}"
    rf"|worlds/[\w -]{{1,60}}\.(?:toml|png)"
    rf"|teacher/(?:teacher\.toml|notes(?:\.[a-z]{{2,3}})?\.md|(?:solutions|wrong)/{_PROGRAM})"
)
#: What file managers add, and the folder where Python keeps compiled modules: pip makes one for
#: the checks of a lesson that it installs.
IGNORED = re.compile(r"(?:^|/)(?:(?:__MACOSX|__pycache__)(?:/|$)|\.|Thumbs\.db$|desktop\.ini$)")
_METHODS = {zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED}
#: As in the other zips that we make: the same files give the same bytes.
_TIME = (1980, 1, 1, 0, 0, 0)


def folder_files(folder: Path) -> dict[str, bytes]:
    """The files in a folder, by their paths inside.

    Raises:
        LessonError: it has files that no lesson has, too many, or too large ones.
        OSError: they cannot be read.
    """
    found: dict[str, bytes] = {}
    total = 0
    for path in _paths(folder, folder.name):
        name = path.relative_to(folder).as_posix()
        _check_name(folder.name, name)
        size = path.stat().st_size
        total += size
        _check_size(folder.name, name, size, total)
        found[name] = path.read_bytes()
    return found


def received_files(name: str, files: Mapping[str, bytes]) -> dict[str, bytes]:
    """The files of a folder that was sent, by their paths inside, without those to be ignored.

    Raises:
        LessonError: it has files that no lesson has, too many, or too large ones.
    """
    found = {path: data for path, data in files.items() if not IGNORED.search(path)}
    _check_count(name, len(found))
    total = 0
    for path, data in found.items():
        _check_name(name, path)
        total += len(data)
        _check_size(name, path, len(data), total)
    return found


def unzipped(filename: str, content: bytes) -> dict[str, bytes]:
    """The files in a zip, by their paths inside; none of them is written to disk.

    Raises:
        LessonError: it is damaged or too large, or has files that no lesson has.
    """
    if len(content) > LARGEST:
        limit = LARGEST // MEGABYTE
        _refuse(filename, "too-large", Phrase("file-too-large", name=filename, limit=limit))
    try:
        with zipfile.ZipFile(io.BytesIO(content)) as archive:
            return _contents(archive, filename)
    except LessonError:
        raise
    except Exception as error:
        # zipfile raises errors of many kinds for damaged files.
        raise LessonError(filename, [Diagnostic("no-zip", Phrase("lesson-zip-damaged"))]) from error


def zipped(files: Mapping[str, bytes]) -> bytes:
    """The files as a zip: the same bytes for the same files."""
    target = io.BytesIO()
    with zipfile.ZipFile(target, "w") as archive:
        for name in sorted(files):
            entry = zipfile.ZipInfo(name, _TIME)
            entry.create_system = 3
            entry.external_attr = 0o644 << 16
            archive.writestr(entry, files[name], zipfile.ZIP_DEFLATED, 9)
    return target.getvalue()


def _paths(folder: Path, name: str) -> Iterator[Path]:
    count = 0
    waiting = [folder]
    while waiting:
        for path in sorted(waiting.pop().iterdir()):
            inside = path.relative_to(folder).as_posix()
            if IGNORED.search(inside):
                continue
            count += 1
            _check_count(name, count)
            if path.is_symlink():
                _refuse(name, "link", Phrase("lesson-link", file=inside))
            if path.is_dir():
                waiting.append(path)
            elif path.is_file():
                yield path
            else:
                _refuse(name, "unknown-file", Phrase("lesson-unknown-file", file=inside))


def _contents(archive: zipfile.ZipFile, filename: str) -> dict[str, bytes]:
    entries = [one for one in zip_names.entries(archive) if not IGNORED.search(one.filename)]
    _check_count(filename, len(entries))
    files = [entry for entry in entries if not entry.is_dir()]
    outer = _outer_folder([entry.filename for entry in files])
    found: dict[str, bytes] = {}
    total = 0
    for entry in files:
        name = entry.filename.removeprefix(outer)
        _check_entry(filename, name, entry)
        if name in found:
            _refuse(filename, "two-files", Phrase("lesson-two-files", file=name))
        with archive.open(entry) as file:
            # The sizes in the zip may be false, so no more is unpacked than the limit.
            found[name] = file.read(LARGEST_FILE + 1)
        total += len(found[name])
        _check_size(filename, name, len(found[name]), total)
        if len(found[name]) > max(_SMALL, LARGEST_RATIO * entry.compress_size):
            _refuse(filename, "bomb", Phrase("lesson-zip-ratio", file=name))
    return found


def _outer_folder(names: list[str]) -> str:
    """The folder that all files are in, as when a folder was zipped; "" if there is none."""
    first = names[0].partition("/")[0] + "/" if names else ""
    is_outer = len(first) > 1 and f"{first}lesson.toml" in names
    return first if is_outer and all(name.startswith(first) for name in names) else ""


def _check_entry(filename: str, name: str, entry: zipfile.ZipInfo) -> None:
    if stat.S_ISLNK(entry.external_attr >> 16):
        _refuse(filename, "link", Phrase("lesson-link", file=name))
    if entry.flag_bits & 1 or entry.compress_type not in _METHODS:
        _refuse(filename, "encrypted", Phrase("lesson-zip-encrypted", file=name))
    _check_name(filename, name)


def _check_name(filename: str, name: str) -> None:
    # No other name is allowed, so none leaves the folder.
    if not _KNOWN.fullmatch(name):
        _refuse(filename, "unknown-file", Phrase("lesson-unknown-file", file=name[:100]))


def _check_count(filename: str, count: int) -> None:
    if count > MOST_FILES:
        _refuse(filename, "too-many-files", Phrase("lesson-too-many-files", most=MOST_FILES))


def _check_size(filename: str, name: str, size: int, total: int) -> None:
    if size > LARGEST_FILE or total > LARGEST_TOTAL:
        limit = (LARGEST_FILE if size > LARGEST_FILE else LARGEST_TOTAL) // MEGABYTE
        large = name if size > LARGEST_FILE else filename
        _refuse(filename, "too-large", Phrase("file-too-large", name=large, limit=limit))


def _refuse(filename: str, code: str, message: Phrase) -> NoReturn:
    raise LessonError(filename, [Diagnostic(code, message)])
