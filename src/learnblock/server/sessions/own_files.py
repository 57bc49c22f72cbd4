"""Whether the files that make blocks have changed: someone may have edited one by hand."""

from collections.abc import Iterator
from pathlib import Path

from learnblock.home import home

_PATTERNS = ("skills/*.py", "blocks/*.json", "libraries/*/*")

Version = frozenset[tuple[Path, int, int]]


class OwnFiles:
    """The user's own skills, what is chosen for their blocks, and the libraries."""

    def __init__(self) -> None:
        self._seen = version()

    def have_changed(self) -> bool:
        """Whether they have since this was last asked."""
        before, self._seen = self._seen, version()
        return self._seen != before


def version() -> Version:
    """Which files there are, when each was changed and how large it is."""
    return frozenset(_stamps())


def _stamps() -> Iterator[tuple[Path, int, int]]:
    folder = home()
    for pattern in _PATTERNS:
        for path in folder.glob(pattern):
            try:
                found = path.stat()
            except OSError:
                # It has gone in this moment.
                continue
            yield path, found.st_mtime_ns, found.st_size
