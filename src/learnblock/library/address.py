"""Where a library is that somebody names: a file, a folder, an address, or a name alone."""

from pathlib import Path
from urllib.parse import urlsplit
from urllib.request import url2pathname

from learnblock.blocks.libraries import MANIFEST
from learnblock.errors import Diagnostic, LibraryError
from learnblock.library.archive import ENDING, read
from learnblock.library.contents import Library

#: Folders in which a library is looked for by its name alone.
_PLACES = (Path(), Path("libraries"))


def find(address: str) -> Library:
    """The library at an address, or of a name.

    Args:
        address: a path, a ``file://`` address, or the name of a library in the folder that one is
            in or in its ``libraries``.

    Raises:
        LibraryError: there is none.
        ProgramError: a file in it is no Python, or no Block-Text.
        BlockConfigurationError: ``blocks.json`` is wrong.
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
    message = (
        f"there is no library here: a file with the ending {ENDING}, or a folder with {MANIFEST}"
    )
    raise LibraryError(address, [Diagnostic("no-library", message)])


def _path(address: str) -> Path:
    parts = urlsplit(address)
    # A single letter is a drive of Windows.
    if len(parts.scheme) < 2:
        return Path(address)
    if parts.scheme == "file" and parts.netloc in {"", "localhost"}:
        return Path(url2pathname(parts.path))
    message = (
        "LearnBlock downloads nothing: download the library yourself, look at it, and import the"
        " file"
    )
    raise LibraryError(address, [Diagnostic("not-downloaded", message)])
