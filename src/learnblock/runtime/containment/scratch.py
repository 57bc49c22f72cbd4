"""The temporary folder of a program: the only place where it can write."""

import os
import shutil
import stat
import subprocess
import tempfile
from collections.abc import Iterator
from contextlib import suppress
from typing import NamedTuple

from learnblock.runtime.limits import Limits


class Usage(NamedTuple):
    """What a program occupies.

    Args:
        disk: bytes, including files that it has deleted but still holds.
        files: in its temporary folder, with the folders.
        threads: of its process.
    """

    disk: int = 0
    files: int = 0
    threads: int = 0


class Scratch:
    """A new temporary folder."""

    def __init__(self) -> None:
        self.path = os.path.realpath(tempfile.mkdtemp(prefix="learnblock-"))

    def usage(self, process: int, limits: Limits) -> Usage:
        """What the program in this process occupies; where it is too much, counting ends early."""
        disk, files = _held(process, self.path, limits.file_size), 0
        with suppress(FileNotFoundError, PermissionError):
            for size in _sizes(self.path):
                disk, files = disk + size, files + 1
                if disk > limits.disk or files > limits.files:
                    break
        return Usage(disk, files, _threads(process))

    def remove(self) -> None:
        """Delete the folder with all that is in it; a second time does nothing."""
        with suppress(FileNotFoundError):
            try:
                shutil.rmtree(self.path)
            except (OSError, RecursionError):
                _remove_deep(self.path)


def _sizes(folder: str) -> Iterator[int]:
    """The bytes of everything in a folder."""
    waiting = [folder]
    while waiting:
        with suppress(FileNotFoundError), os.scandir(waiting.pop()) as entries:
            for entry in entries:
                with suppress(FileNotFoundError):
                    yield _bytes(entry.stat(follow_symlinks=False))
                    if entry.is_dir(follow_symlinks=False):
                        waiting.append(entry.path)


def _held(process: int, folder: str, most: int) -> int:
    """The bytes of files that a program has deleted but still has open or in its memory."""
    held = 0
    with suppress(OSError):
        for entry in os.scandir(f"/proc/{process}/fd"):
            with suppress(FileNotFoundError):
                held += _deleted(entry.stat())
        with open(f"/proc/{process}/maps", "rb") as maps:  # noqa: PTH123 - as fast as can be
            mapped = sum(folder.encode() in line for line in maps if line.endswith(b"(deleted)\n"))
        # Of these only the name is left; none is larger than a file may be.
        held += mapped * most
    return held


def _deleted(found: os.stat_result) -> int:
    return _bytes(found) if stat.S_ISREG(found.st_mode) and found.st_nlink == 0 else 0


def _bytes(found: os.stat_result) -> int:
    # A file with holes occupies less than its size; Windows does not say.
    return getattr(found, "st_blocks", -(-found.st_size // 512)) * 512


def _threads(process: int) -> int:
    """The threads of a process, where the system tells."""
    try:
        return os.stat(f"/proc/{process}/task").st_nlink - 2  # noqa: PTH116 - as above
    except OSError:
        return 0


def _remove_deep(folder: str) -> None:
    """Remove folders nested deeper than Python's way goes."""
    if os.name == "posix":
        # What is left then is the system's to clean up, as everything in its temporary folder.
        subprocess.run(["rm", "-rf", "--", folder], check=False, stderr=subprocess.DEVNULL)  # noqa: S603, S607
