"""The temporary folder of a program: the only place where it can write."""

import os
import shutil
import stat
import subprocess
import tempfile
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor, wait
from contextlib import suppress
from typing import NamedTuple

from learnblock.runtime.limits import Limits

#: Seconds for the removal of a folder.
_REMOVING = 10.0


class Usage(NamedTuple):
    """The disk space, files and threads that a program uses.

    Args:
        disk: bytes, including files that it has deleted but still has open.
        files: the number of files and folders in its temporary folder.
        threads: the number of threads in its process.
    """

    disk: int = 0
    files: int = 0
    threads: int = 0


class Scratch:
    """A new temporary folder, which a thread looks after that keeps all its rights.

    The host's own thread gives up its rights once there is a robot: see `driver`.
    """

    def __init__(self) -> None:
        self._keeper = ThreadPoolExecutor(1, "scratch")
        self.path = os.path.realpath(self._keeper.submit(_make).result())
        self._is_removed = False

    def usage(self, process: int, limits: Limits) -> Usage:
        """What the program in this process uses; counting stops early if it exceeds a limit."""
        return self._keeper.submit(_usage, process, self.path, limits).result()

    def remove(self) -> None:
        """Delete the folder with everything in it; calling it twice is harmless."""
        if not self._is_removed:
            self._is_removed = True
            removing = self._keeper.submit(_remove, self.path)
            # Slower work, such as on a network drive, continues without its run.
            _, slower = wait([removing], _REMOVING)
            # Its thread ends, too, so that a process which has no other one may fork.
            self._keeper.shutdown(wait=not slower)


def _make() -> str:
    return tempfile.mkdtemp(prefix="learnblock-")


def _remove(folder: str) -> None:
    with suppress(FileNotFoundError):
        try:
            shutil.rmtree(folder)
        except (OSError, RecursionError):
            _remove_deep(folder)


def _usage(process: int, folder: str, limits: Limits) -> Usage:
    disk, files = _held(process, folder, limits.file_size), 0
    with suppress(FileNotFoundError, PermissionError):
        for size in _sizes(folder):
            disk, files = disk + size, files + 1
            if disk > limits.disk or files > limits.files:
                break
    return Usage(disk, files, _threads(process))


def _sizes(folder: str) -> Iterator[int]:
    """The size of each file and folder inside a folder, in bytes."""
    waiting = [folder]
    while waiting:
        with suppress(FileNotFoundError), os.scandir(waiting.pop()) as entries:
            for entry in entries:
                with suppress(FileNotFoundError):
                    yield _bytes(entry.stat(follow_symlinks=False))
                    if entry.is_dir(follow_symlinks=False):
                        waiting.append(entry.path)


def _held(process: int, folder: str, most: int) -> int:
    """The bytes in files that a program has deleted but still has open or mapped in memory."""
    held = 0
    with suppress(OSError):
        for entry in os.scandir(f"/proc/{process}/fd"):
            with suppress(FileNotFoundError):
                held += _deleted(entry.stat())
        with open(f"/proc/{process}/maps", "rb") as maps:  # noqa: PTH123 - as fast as can be
            mapped = sum(folder.encode() in line for line in maps if line.endswith(b"(deleted)\n"))
        # The sizes of mapped files are unknown, but none exceeds the limit for one file.
        held += mapped * most
    return held


def _deleted(status: os.stat_result) -> int:
    return _bytes(status) if stat.S_ISREG(status.st_mode) and status.st_nlink == 0 else 0


def _bytes(status: os.stat_result) -> int:
    # A sparse file occupies less than its size; Windows does not report how much.
    return getattr(status, "st_blocks", -(-status.st_size // 512)) * 512


def _threads(process: int) -> int:
    """The number of threads in a process; 0 if the system does not report it."""
    try:
        return os.stat(f"/proc/{process}/task").st_nlink - 2  # noqa: PTH116 - as above
    except OSError:
        return 0


def _remove_deep(folder: str) -> None:
    """Remove folders that are nested too deeply for `shutil.rmtree`."""
    if os.name == "posix":
        # The system cleans up whatever remains, as it does with all temporary files.
        with suppress(subprocess.TimeoutExpired):
            subprocess.run(  # noqa: S603
                ["rm", "-rf", "--", folder],  # noqa: S607
                check=False,
                stderr=subprocess.DEVNULL,
                timeout=_REMOVING,
            )
