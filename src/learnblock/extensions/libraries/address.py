"""Find a library by a file, a folder, an address or only its name."""

from pathlib import Path
from urllib.parse import urlsplit
from urllib.request import url2pathname

from learnblock.blocks.installed_libraries import MANIFEST
from learnblock.errors import Diagnostic, LibraryError
from learnblock.extensions.libraries.archive import ENDING, read
from learnblock.extensions.libraries.contents import Library
from learnblock.i18n import Phrase

#: Folders that are searched for a library's name.
_PLACES = (Path(), Path("libraries"))


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
