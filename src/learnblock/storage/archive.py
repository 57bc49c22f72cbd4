"""Reads zips of any origin, within limits and without writing to disk.

A zip can lie about its sizes, have names that lead out of any folder, and contain files that its
author never put there. `unzipped` refuses all of that; a caller of `ZipReader` leaves such files
out.
"""

import io
import re
import stat
import unicodedata
import zipfile
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass
from enum import StrEnum
from pathlib import PurePosixPath, PureWindowsPath
from typing import BinaryIO

from learnblock.errors import Diagnostic, FileError
from learnblock.i18n import Phrase

#: How many bytes one byte of a zip may become: pictures become 1, texts 10, bombs 1,000.
LARGEST_RATIO = 100
#: Files so small may become any number of bytes.
_SMALL = 64 * 1024
#: The most folders in one another.
DEEPEST = 32
#: What file managers add, hidden files, and the folder where Python keeps compiled modules: pip
#: makes one for the checks of a lesson that it installs.
IGNORED = re.compile(r"(?:^|/)(?:(?:__MACOSX|__pycache__)(?:/|$)|\.|Thumbs\.db$|desktop\.ini$)")

_MEGABYTE = 1024**2
_METHODS = {zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED}
#: Set for names in UTF-8; names without it should be in code page 437, that of the first PCs.
_UTF_8 = 0x800
#: Set for encrypted files.
_ENCRYPTED = 0x1
#: The time of every file, so that the same files always give the same bytes.
_TIME = (1980, 1, 1, 0, 0, 0)


class ZipRule(StrEnum):
    """What can be wrong with a zip, or with a file in it."""

    NO_ZIP = "no-zip"
    TOO_MANY_FILES = "too-many-files"
    TOO_LARGE = "too-large"
    UNKNOWN_FILE = "unknown-file"
    LINK = "link"
    ENCRYPTED = "encrypted"
    TWO_FILES = "two-files"
    BOMB = "bomb"


class RefusedError(Exception):
    """A zip, or a file in it, breaks a rule.

    Args:
        rule: the rule.
        file: the name of the file; empty for the zip as a whole.
    """

    def __init__(self, rule: ZipRule, file: str = "") -> None:
        super().__init__(rule, file)
        self.rule = rule
        self.file = file


@dataclass(frozen=True)
class Entry:
    """A file or a folder in an open zip.

    Args:
        archive: the zip.
        info: what the zip says of it.
        name: its path as its author wrote it, in NFC; that of a folder ends with a slash.
    """

    archive: zipfile.ZipFile
    info: zipfile.ZipInfo
    name: str

    @property
    def is_folder(self) -> bool:
        """Whether it is a folder."""
        return self.name.endswith("/")

    def unpacked(self, most: int) -> bytes:
        """Its first bytes, at most so many, since the sizes in a zip may be false.

        Raises:
            RefusedError: it is a link, encrypted, damaged, or packed as no file of a person is.
        """
        if stat.S_ISLNK(self.info.external_attr >> 16):
            raise RefusedError(ZipRule.LINK, self.name)
        if self.info.flag_bits & _ENCRYPTED or self.info.compress_type not in _METHODS:
            raise RefusedError(ZipRule.ENCRYPTED, self.name)
        try:
            with self.archive.open(self.info) as file:
                return file.read(most)
        except Exception as error:
            # zipfile raises errors of many kinds for damaged files.
            raise RefusedError(ZipRule.NO_ZIP, self.name) from error

    def is_bomb(self, content: bytes) -> bool:
        """Whether it was packed smaller than any file of a person."""
        return len(content) > max(_SMALL, LARGEST_RATIO * self.info.compress_size)


class ZipReader:
    """Reads zips, and adds up what was read of them.

    Args:
        entries: the most files and folders.
        total: the most bytes of the files that are read.
        ignored: what is left out as if it were not there.
    """

    def __init__(self, entries: int, total: int, ignored: re.Pattern[str] = IGNORED) -> None:
        self._entries = entries
        self._left = total
        self._ignored = ignored

    def entries(self, opened: BinaryIO) -> Iterator[Entry]:
        """The files and folders in a zip that its author has put there.

        Raises:
            RefusedError: it is no zip, or there are too many.
        """
        try:
            archive = zipfile.ZipFile(opened)
        except Exception as error:
            # As above.
            raise RefusedError(ZipRule.NO_ZIP) from error
        with archive:
            entries = [Entry(archive, info, _name(info)) for info in archive.infolist()]
            kept = [entry for entry in entries if not self._ignores(entry.name)]
            self._entries -= len(kept)
            if self._entries < 0:
                raise RefusedError(ZipRule.TOO_MANY_FILES)
            yield from kept

    def _ignores(self, name: str) -> bool:
        """Whether its author has not put an entry there; one that leads out is for the rules."""
        path = _with_slashes(name)
        return ".." not in path.parts and self._ignored.search(path.as_posix()) is not None

    def inner(self, entry: Entry, most: int) -> Iterator[Entry]:
        """What is in a zip in the zip.

        Raises:
            RefusedError: it is larger, damaged or refused like any other entry.
        """
        yield from self.entries(io.BytesIO(entry.unpacked(most)))

    def read(self, entry: Entry, most: int) -> bytes:
        """The first bytes of a file, at most so many.

        Raises:
            RefusedError: it can't be read, or with it too much is read.
        """
        content = entry.unpacked(min(most, self._left + 1))
        self._left -= len(content)
        if self._left < 0:
            raise RefusedError(ZipRule.TOO_LARGE)
        if entry.is_bomb(content):
            raise RefusedError(ZipRule.BOMB, entry.name)
        return content


@dataclass(frozen=True)
class Rules:
    """What a zip of one kind may have, and the words for one that has more.

    Args:
        error: the kind of error.
        entries: the most files and folders.
        total: the most bytes of all files.
        file: the most bytes of a file.
        damaged: says that it is no zip.
        too_many: says that it has too many files.
        too_large: says that its files have too many bytes.
    """

    error: type[FileError]
    entries: int
    total: int
    file: int
    damaged: Phrase
    too_many: Phrase
    too_large: Phrase

    def phrase(self, refused: RefusedError) -> Phrase:
        """What is wrong with a zip."""
        match refused.rule:
            case ZipRule.NO_ZIP:
                return self.damaged
            case ZipRule.TOO_MANY_FILES:
                return self.too_many
            case ZipRule.TOO_LARGE if not refused.file:
                return self.too_large
            case ZipRule.TOO_LARGE:
                limit = self.file // _MEGABYTE
                return Phrase("file-too-large", name=refused.file, limit=limit)
        return Phrase(_WORDS[refused.rule], file=refused.file)


_WORDS: Mapping[ZipRule, str] = {
    ZipRule.UNKNOWN_FILE: "file-zip-outside",
    ZipRule.LINK: "file-link",
    ZipRule.ENCRYPTED: "file-zip-encrypted",
    ZipRule.TWO_FILES: "file-zip-two",
    ZipRule.BOMB: "file-zip-bomb",
}


def unzipped(filename: str, content: bytes, rules: Rules) -> dict[str, bytes]:
    """The files in a zip, by their paths inside, which lead nowhere else.

    Args:
        filename: the name of the zip, for errors.
        content: its bytes.
        rules: what it may have.

    Raises:
        FileError: it breaks a rule; of the kind that the rules name.
    """
    with refusing(filename, rules):
        return dict(read_files(io.BytesIO(content), rules))


@contextmanager
def refusing(filename: str, rules: Rules) -> Iterator[None]:
    """Raise the error of the rules where a zip breaks one.

    Raises:
        FileError: it does; of the kind that the rules name.
    """
    try:
        yield
    except RefusedError as refused:
        raise rules.error(filename, [Diagnostic(refused.rule, rules.phrase(refused))]) from refused


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


def read_files(
    opened: BinaryIO, rules: Rules, ignored: re.Pattern[str] = IGNORED
) -> Iterator[tuple[str, bytes]]:
    """The files in an open zip, one after the other: their paths inside, and what they contain.

    Raises:
        RefusedError: the zip breaks a rule.
    """
    reader = ZipReader(rules.entries, rules.total, ignored)
    paths: set[str] = set()
    for entry in reader.entries(opened):
        if entry.is_folder:
            continue
        path = _path(entry.name)
        if path in paths:
            raise RefusedError(ZipRule.TWO_FILES, path)
        paths.add(path)
        content = reader.read(entry, rules.file + 1)
        if len(content) > rules.file:
            raise RefusedError(ZipRule.TOO_LARGE, path)
        yield path, content


def _path(name: str) -> str:
    """The path of a file, on whatever system the zip was made.

    Raises:
        RefusedError: it leads out of the folder, or too deep into it.
    """
    path = _with_slashes(name)
    leads_out = path.is_absolute() or ".." in path.parts or PureWindowsPath(name).drive
    if leads_out or not path.parts or len(path.parts) > DEEPEST:
        raise RefusedError(ZipRule.UNKNOWN_FILE, name)
    return path.as_posix()


def _with_slashes(name: str) -> PurePosixPath:
    return PurePosixPath(name.replace("\\", "/"))


def _name(info: zipfile.ZipInfo) -> str:
    """The name of an entry as its author wrote it, in NFC.

    The zips of macOS, among others, have names in UTF-8 and don't say so.
    """
    return unicodedata.normalize("NFC", _decoded(info))


def _decoded(info: zipfile.ZipInfo) -> str:
    if info.flag_bits & _UTF_8:
        return info.filename
    try:
        # Hardly any text in another encoding is valid UTF-8 by chance.
        return info.filename.encode("cp437").decode("utf-8")
    except UnicodeError:
        return info.filename
