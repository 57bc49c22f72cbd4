"""A library as one file, a zip ``NAME.lblib``, or as a folder, and where to find it."""

from collections.abc import Iterator
from pathlib import Path
from urllib.parse import urlsplit
from urllib.request import url2pathname

from learnblock.blocks.installed_libraries import MANIFEST
from learnblock.errors import Diagnostic, LibraryError
from learnblock.extensions.libraries.contents import LARGEST, MOST_FILES, Library, from_files
from learnblock.i18n import Phrase
from learnblock.storage.archive import IGNORED, Rules, unzipped, zipped

ENDING = ".lblib"
#: Folders that are searched for a library's name.
_PLACES = (Path(), Path("libraries"))
_RULES = Rules(
    LibraryError,
    entries=MOST_FILES,
    total=LARGEST,
    file=LARGEST,
    damaged=Phrase("library-not-zip"),
    too_many=Phrase("library-too-many-files", most=MOST_FILES),
    too_large=Phrase("library-too-large", limit=LARGEST),
)


def pack(library: Library) -> bytes:
    """The bytes of a library as one file."""
    return zipped({name: text.encode() for name, text in library.files.items()})


def unpack(content: bytes, where: str) -> Library:
    """The library in a file's bytes.

    Raises:
        LibraryError: they are not a library in one file.
        ProgramError: a file in it is not valid Python or Block-Text.
        BlockConfigurationError: ``blocks.json`` is invalid.
    """
    if len(content) > LARGEST:
        raise _wrong(where, "too-large", Phrase("library-file-too-large", limit=LARGEST))
    return from_files(_unzipped(content, where), where)


def read(path: Path) -> Library:
    """The library in a file or a folder.

    Raises:
        LibraryError: it is not a library.
        ProgramError: a file in it is not valid Python or Block-Text.
        BlockConfigurationError: ``blocks.json`` is invalid.
        OSError: it cannot be read.
    """
    if path.is_dir():
        return from_files(dict(_files(path)), str(path))
    with path.open("rb") as file:
        return unpack(file.read(LARGEST + 1), path.name)


def _files(folder: Path) -> Iterator[tuple[str, bytes]]:
    paths = [path for path in sorted(folder.iterdir()) if not IGNORED.search(path.name)]
    if len(paths) > MOST_FILES:
        raise _too_many(str(folder))
    for path in paths:
        if path.is_symlink() or not path.is_file():
            message = Phrase("library-not-plain-file", file=path.name)
            raise _wrong(str(folder), "unknown-file", message)
        with path.open("rb") as file:
            yield path.name, file.read(LARGEST + 1)


def _unzipped(content: bytes, where: str) -> dict[str, bytes]:
    """The files of a zip; they may all be in one folder, as in a zip of a folder."""
    files: dict[str, bytes] = {}
    for path, unpacked in unzipped(where, content, _RULES).items():
        *folders, name = path.split("/")
        if len(folders) > 1:
            raise _wrong(where, "unknown-file", Phrase("library-file-outside", file=path))
        if name in files:
            raise _wrong(where, "two-files", Phrase("file-zip-two", file=name))
        files[name] = unpacked
    return files


def _too_many(where: str) -> LibraryError:
    return _wrong(where, "too-many-files", Phrase("library-too-many-files", most=MOST_FILES))


def _wrong(where: str, code: str, message: Phrase) -> LibraryError:
    return LibraryError(where, [Diagnostic(code, message)])


def find(address: str) -> Library:
    """The library at an address.

    Args:
        address: a path, a ``file://`` address, or the name of a library in the current folder or
            in its folder ``libraries``.

    Raises:
        LibraryError: there is no library.
        ProgramError: a file in it is not valid Python or Block-Text.
        BlockConfigurationError: ``blocks.json`` is invalid.
        OSError: it cannot be read.
    """
    path = _path(address)
    candidates = [
        path,
        *(place / f"{address}{ENDING}" for place in _PLACES if address.isidentifier()),
    ]
    candidates += [place / address for place in _PLACES if address.isidentifier()]
    for candidate in candidates:
        if candidate.is_file() or (candidate / MANIFEST).is_file():
            return read(candidate)
    message = Phrase("library-not-found", ending=ENDING, manifest=MANIFEST)
    raise LibraryError(address, [Diagnostic("no-library", message)])


def _path(address: str) -> Path:
    parts = urlsplit(address)
    # A single letter is a Windows drive.
    if len(parts.scheme) < 2:
        return Path(address)
    if parts.scheme == "file" and parts.netloc in {"", "localhost"}:
        return Path(url2pathname(parts.path))
    message = Phrase("library-not-downloaded")
    raise LibraryError(address, [Diagnostic("not-downloaded", message)])
