"""A class as one file, which a teacher makes at home and opens at school."""

import re
import tempfile
import zipfile
from collections.abc import Callable
from pathlib import Path
from typing import BinaryIO

from learnblock.classroom import limits
from learnblock.classroom.archive import files_in
from learnblock.classroom.pupil_folder import HOME, PROJECTS
from learnblock.classroom.roster import FILE, read_class
from learnblock.errors import Diagnostic, FileError, LearnBlockError
from learnblock.i18n import Phrase
from learnblock.storage.archive import RefusedError, Rules, ZipReader, ZipRule, inner_path

#: The ending of the file.
ENDING = ".lbclass"
#: What belongs to a class: its file, and what its pupils have made.
_PUPILS = re.compile(rf"pupils/[a-z0-9]{{10}}/(?:{HOME}|{PROJECTS})/.+")
#: What file managers add; the history of a project is in a hidden folder, and is kept.
_IGNORED = re.compile(r"(?:^|/)(?:__MACOSX(?:/|$)|\.DS_Store$|Thumbs\.db$|desktop\.ini$)")
#: The most files, and bytes of all of them.
_MOST, _LARGEST = 200_000, 1024**3


class ClassFileError(FileError):
    """A file is no class."""


_RULES = Rules(
    error=ClassFileError,
    entries=_MOST,
    total=_LARGEST,
    file=limits.LARGEST_FILE,
    damaged=Phrase("class-file-damaged"),
    too_many=Phrase("class-file-too-many", most=_MOST),
    too_large=Phrase("class-file-too-large", most=_LARGEST // 1024**3),
)


def pack(folder: Path, target: Path) -> None:
    """Write a class into one file: with its word, its key, and the pupils' pictures as hashes.

    Raises:
        OSError: a file can't be read or written.
    """
    with zipfile.ZipFile(target, "w", zipfile.ZIP_DEFLATED) as archive:
        archive.write(folder / FILE, FILE)
        for path, name in files_in(folder):
            if _PUPILS.fullmatch(name):
                archive.write(path, name)


def unpack(source: Path, place: Callable[[str], Path]) -> str:
    """Take in a class from such a file; return its name.

    Args:
        source: the file.
        place: the folder of a class by its name.

    Raises:
        ClassFileError: it is no class, or too large.
        LearnBlockError: there is a class of this name, or it belongs to a newer version.
        OSError: it can't be read or written.
    """
    try:
        with source.open("rb") as opened:
            return _unpacked(opened, place)
    except RefusedError as refused:
        mistakes = [Diagnostic(refused.rule, _RULES.phrase(refused))]
        raise ClassFileError(source.name, mistakes) from refused


def _unpacked(opened: BinaryIO, place: Callable[[str], Path]) -> str:
    root = place("x").parent
    root.mkdir(parents=True, exist_ok=True)
    # In the same folder, so that the class appears there as a whole or not at all.
    with tempfile.TemporaryDirectory(prefix=".", dir=root) as temporary:
        folder = Path(temporary) / "class"
        _extract(opened, folder)
        file = read_class(folder)
        if file is None:
            raise RefusedError(ZipRule.NO_ZIP)
        target = place(file.title)
        if target.exists():
            raise LearnBlockError("class-exists", title=file.title)
        folder.rename(target)
    return file.title


def _extract(opened: BinaryIO, folder: Path) -> None:
    """Write the files of a class.

    Raises:
        RefusedError: one breaks a rule.
    """
    reader = ZipReader(_MOST, _LARGEST, _IGNORED)
    for entry in reader.entries(opened):
        if entry.is_folder:
            continue
        path = inner_path(entry.name)
        if path != FILE and not _PUPILS.fullmatch(path):
            raise RefusedError(ZipRule.UNKNOWN_FILE, path)
        content = reader.read(entry, limits.LARGEST_FILE + 1)
        if len(content) > limits.LARGEST_FILE:
            raise RefusedError(ZipRule.TOO_LARGE, path)
        _write(folder / path, content)


def _write(file: Path, content: bytes) -> None:
    file.parent.mkdir(parents=True, exist_ok=True)
    try:
        with file.open("xb") as opened:
            opened.write(content)
    except FileExistsError as error:
        raise RefusedError(ZipRule.TWO_FILES, file.name) from error
