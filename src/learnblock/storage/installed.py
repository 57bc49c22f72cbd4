"""What the installed packages declare, searched again only when packages have changed."""

import os
import sys
from collections.abc import Callable, Iterable
from functools import lru_cache
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from importlib.metadata import EntryPoint, EntryPoints

#: The folders of packages with the times at which they last changed.
_State = tuple[tuple[str, int], ...]


def entry_points(group: str) -> "Iterable[EntryPoint]":
    """The entry points of a group, such as ``learnblock.skills``.

    A search reads a file of each installed package, which takes longer than many a run of a
    program. Installing or removing a package changes the folder that it is in.
    """
    from importlib import metadata  # noqa: PLC0415 - slow, and few callers need it at once

    return _all(metadata.entry_points, _state()).select(group=group)


def _state() -> _State:
    return tuple((folder, _changed(folder)) for folder in sys.path)


def _changed(folder: str) -> int:
    """When a folder changed, in nanoseconds; 0 if there is none."""
    try:
        return os.stat(folder or ".").st_mtime_ns  # noqa: PTH116 - several per run
    except OSError:
        return 0


@lru_cache(maxsize=4)
def _all(search: "Callable[[], EntryPoints]", state: _State) -> "EntryPoints":  # noqa: ARG001 - searched again after a change
    """The entry points of all groups: a search for one of them reads the same files."""
    return search()
