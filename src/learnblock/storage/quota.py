"""How much a person's folder may hold, where others share the disk.

A variable of the environment says so, because it holds for a whole process and all that it starts,
as the system's limits do.
"""

import errno
import os
import time
from functools import cache
from pathlib import Path

from learnblock.errors import LearnBlockError

#: The variable: a number of bytes, a space, and the folder.
VARIABLE = "LEARNBLOCK_QUOTA"
#: Files up to this size, in bytes, can still be replaced when the folder is full, so that work on
#: existing projects continues.
_SMALL = 4 * 1024 * 1024
#: Seconds for which a measurement holds; files written in this time are added.
_FRESH = 10.0


class FolderFullError(LearnBlockError, OSError):
    """A person's folder has no room for another file."""

    def __init__(self, most: int) -> None:
        super().__init__("file-quota", most=most // 2**20)
        self.errno = errno.EDQUOT


class FolderQuota:
    """The files of a folder.

    Args:
        most: their size in bytes.
        folder: the folder.
    """

    def __init__(self, most: int, folder: Path) -> None:
        self._most = most
        self._folder = folder
        self._used = 0
        self._measured = -_FRESH

    def require(self, path: Path, size: int) -> None:
        """Check that there is room for a file.

        Args:
            path: where it will be written.
            size: its size in bytes.

        Raises:
            FolderFullError: there is none.
        """
        if time.monotonic() - self._measured >= _FRESH:
            self._used = _size(self._folder)
            self._measured = time.monotonic()
        if self._used + size <= self._most:
            self._used += size
        elif size > _SMALL or not path.exists():
            raise FolderFullError(self._most)


def require_room(path: Path, size: int) -> None:
    """Check that this process may write a file of this size.

    Raises:
        FolderFullError: the folder that it may write to is full.
    """
    if setting := os.environ.get(VARIABLE):
        _quota(setting).require(path, size)


def setting(most: int, folder: Path) -> str:
    """The value of the variable for a folder with this many bytes at most."""
    return f"{most} {folder}"


@cache
def _quota(text: str) -> FolderQuota:
    most, _, folder = text.partition(" ")
    return FolderQuota(int(most), Path(folder))


def _size(folder: Path) -> int:
    """The size of all files in a folder, in bytes."""
    total = 0
    for where, _, names in os.walk(folder):
        for name in names:
            try:
                status = os.lstat(os.path.join(where, name))  # noqa: PTH118 - thousands of them
            except FileNotFoundError:
                # It has just been deleted.
                continue
            total += status.st_size
    return total
