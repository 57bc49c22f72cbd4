"""Detection of changes to the files that define blocks, which users may edit by hand."""

from collections.abc import Iterator
from pathlib import Path

from learnblock.storage.home import home

_PATTERNS = ("skills/*.py", "blocks/*.json", "libraries/*/*")

Version = frozenset[tuple[Path, int, int]]


class BlockFiles:
    """The user's skills, the configurations of their blocks, and the libraries."""

    def __init__(self) -> None:
        self._seen = version()

    def have_changed(self) -> bool:
        """Whether any has changed since the last call."""
        before, self._seen = self._seen, version()
        return self._seen != before


def version() -> Version:
    """The files, each with its modification time and size."""
    return frozenset(_stamps())


def _stamps() -> Iterator[tuple[Path, int, int]]:
    folder = home()
    for pattern in _PATTERNS:
        for path in folder.glob(pattern):
            try:
                status = path.stat()
            except OSError:
                # It was deleted just now.
                continue
            yield path, status.st_mtime_ns, status.st_size
