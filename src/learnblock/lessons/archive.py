"""The files of a lesson: read from a folder or a zip within limits."""

import re
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import NoReturn

from learnblock.errors import Diagnostic, LessonError
from learnblock.i18n import Phrase
from learnblock.runtime.limits import MEGABYTE
from learnblock.storage import archive
from learnblock.storage.archive import IGNORED, Rules

SUFFIX = ".lblesson"
#: The largest zip, and the largest sum of the files in it, in bytes.
LARGEST, LARGEST_TOTAL = 16 * MEGABYTE, 32 * MEGABYTE
#: The largest file, in bytes.
LARGEST_FILE = 8 * MEGABYTE
MOST_FILES = 300

_PROGRAM, _PICTURE = r"[\w-]{1,60}\.(?:bt|py)", r"[\w-]{1,60}\.(?:png|jpg|jpeg|svg)"
#: The files that a lesson can have.
_KNOWN = re.compile(
    rf"lesson\.toml|checks\.(?:py|[a-z]{{2,3}}\.toml)|programs/{_PROGRAM}|pictures/{_PICTURE}"
    rf"|worlds/[\w -]{{1,60}}\.(?:toml|png)"
    rf"|teacher/(?:teacher\.toml|notes(?:\.[a-z]{{2,3}})?\.md|(?:solutions|wrong)/{_PROGRAM})"
)


def folder_files(folder: Path) -> dict[str, bytes]:
    """The files in a folder, by their paths inside.

    Raises:
        LessonError: it has files that no lesson has, too many, or too large ones.
        OSError: they cannot be read.
    """
    files: dict[str, bytes] = {}
    total = 0
    for path in _paths(folder, folder.name):
        name = path.relative_to(folder).as_posix()
        _check_name(folder.name, name)
        size = path.stat().st_size
        total += size
        _check_size(folder.name, name, size, total)
        files[name] = path.read_bytes()
    return files


def received_files(name: str, files: Mapping[str, bytes]) -> dict[str, bytes]:
    """The files of a folder that was sent, by their paths inside, without those to be ignored.

    Raises:
        LessonError: it has files that no lesson has, too many, or too large ones.
    """
    lesson_files = {path: data for path, data in files.items() if not IGNORED.search(path)}
    _check_count(name, len(lesson_files))
    total = 0
    for path, data in lesson_files.items():
        _check_name(name, path)
        total += len(data)
        _check_size(name, path, len(data), total)
    return lesson_files


def unzipped(filename: str, content: bytes) -> dict[str, bytes]:
    """The files in a zip, by their paths inside; none of them is written to disk.

    Raises:
        LessonError: it is damaged or too large, or has files that no lesson has.
    """
    if len(content) > LARGEST:
        limit = LARGEST // MEGABYTE
        _refuse(filename, "too-large", Phrase("file-too-large", name=filename, limit=limit))
    rules = Rules(
        LessonError,
        entries=MOST_FILES,
        total=LARGEST_TOTAL,
        file=LARGEST_FILE,
        damaged=Phrase("lesson-zip-damaged"),
        too_many=Phrase("lesson-too-many-files", most=MOST_FILES),
        too_large=Phrase("file-too-large", name=filename, limit=LARGEST_TOTAL // MEGABYTE),
    )
    files = archive.unzipped(filename, content, rules)
    outer = _outer_folder([*files])
    lesson_files = {path.removeprefix(outer): data for path, data in files.items()}
    for path in lesson_files:
        _check_name(filename, path)
    return lesson_files


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
                _refuse(name, "link", Phrase("file-link", file=inside))
            if path.is_dir():
                waiting.append(path)
            elif path.is_file():
                yield path
            else:
                _refuse(name, "unknown-file", Phrase("lesson-unknown-file", file=inside))


def _outer_folder(names: list[str]) -> str:
    """The folder that all files are in, as when a folder was zipped; "" if there is none."""
    first = names[0].partition("/")[0] + "/" if names else ""
    is_outer = len(first) > 1 and f"{first}lesson.toml" in names
    return first if is_outer and all(name.startswith(first) for name in names) else ""


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
