"""A class as one file, which a teacher makes at home and opens at school."""

import re
import tempfile
import zipfile
from pathlib import Path
from typing import BinaryIO

from learnblock.classroom import hand_ins, limits
from learnblock.classroom.archive import files_in
from learnblock.classroom.pupil_folder import HOME, PROJECTS
from learnblock.classroom.roster import FILE, class_folder, classes_folder, read_class
from learnblock.errors import FileError, LearnBlockError
from learnblock.i18n import Phrase
from learnblock.lessons.grading import journal
from learnblock.storage.archive import RefusedError, Rules, ZipRule, read_files, refusing

#: What belongs to a class, besides its file: what its pupils have made and handed in, and the runs
#: of its checks.
_PARTS = (
    re.compile(rf"pupils/[a-z0-9]{{10}}/(?:{HOME}|{PROJECTS})/.+"),
    hand_ins.PATH,
    re.compile(rf"{hand_ins.RUNS}/\w[\w .-]{{0,78}}\w\.[0-9]{{1,2}}/{journal.NAME}"),
)
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
            if _belongs(name):
                archive.write(path, name)


def unpack(source: Path) -> str:
    """Take in a class from such a file; return its name.

    Raises:
        ClassFileError: it is no class, or too large.
        LearnBlockError: there is a class of this name, or it belongs to a newer version.
        OSError: it can't be read or written.
    """
    with refusing(source.name, _RULES), source.open("rb") as opened:
        return _unpacked(opened)


def _unpacked(opened: BinaryIO) -> str:
    classes_folder().mkdir(parents=True, exist_ok=True)
    # In the same folder, so that the class appears there as a whole or not at all.
    with tempfile.TemporaryDirectory(prefix=".", dir=classes_folder()) as temporary:
        folder = Path(temporary) / "class"
        for path, content in read_files(opened, _RULES, _IGNORED):
            if path != FILE and not _belongs(path):
                raise RefusedError(ZipRule.UNKNOWN_FILE, path)
            _write(folder / path, content)
        file = read_class(folder)
        if file is None:
            raise RefusedError(ZipRule.NO_ZIP)
        target = class_folder(file.title)
        if target.exists():
            raise LearnBlockError("class-exists", title=file.title)
        folder.rename(target)
    return file.title


def _belongs(path: str) -> bool:
    return any(part.fullmatch(path) for part in _PARTS)


def _write(file: Path, content: bytes) -> None:
    file.parent.mkdir(parents=True, exist_ok=True)
    try:
        with file.open("xb") as opened:
            opened.write(content)
    except FileExistsError as error:
        # Some systems don't tell capitals from small letters.
        raise RefusedError(ZipRule.TWO_FILES, file.name) from error
