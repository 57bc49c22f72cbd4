"""Files that are written completely or not at all."""

import os
import re
from collections.abc import Callable
from pathlib import Path
from uuid import uuid4

from learnblock.storage import quota

_DEVICE = re.compile(r"(?:con|prn|aux|nul|com\d|lpt\d)(?:\..*)?", re.IGNORECASE)


def is_device_name(name: str) -> bool:
    """Whether Windows reserves a name, with any suffix, for a device."""
    return bool(_DEVICE.fullmatch(name))


def save(
    path: Path,
    data: bytes,
    *,
    private: bool = False,
    still_wanted: Callable[[], bool] | None = None,
) -> os.stat_result | None:
    """Write a file so that a crash, even of the machine, leaves either the old file or the new one.

    Of several writers at once, in any processes, the last one wins.

    Args:
        path: of the file; missing folders are made.
        data: its whole contents.
        private: whether only its owner may read it.
        still_wanted: called when everything is written, just before the old file is replaced.

    Returns:
        The status of the new file; None if it was not wanted any more.

    Raises:
        OSError: it cannot be written, or there is no room; the old file is unchanged.
    """
    quota.require_room(path, len(data))
    path.parent.mkdir(parents=True, exist_ok=True)
    # Hidden, and with a suffix that is never listed, until it is complete.
    unfinished = path.with_name(f".{uuid4().hex}.new")
    try:
        with open(unfinished, "xb", opener=_private if private else None) as file:
            file.write(data)
            file.flush()
            os.fsync(file.fileno())
            status = os.fstat(file.fileno())
        if still_wanted and not still_wanted():
            unfinished.unlink()
            return None
        unfinished.replace(path)
    except BaseException:
        # A full disk must not fill up further with each attempt.
        unfinished.unlink(missing_ok=True)
        raise
    _sync(path.parent)
    return status


def _private(path: str, flags: int) -> int:
    return os.open(path, flags, 0o600)


def _sync(folder: Path) -> None:
    """Write the folder to disk, so that the new name survives a crash too."""
    if os.name == "nt":
        # Windows can't open folders, and writes names to disk by itself.
        return
    opened = os.open(folder, os.O_RDONLY)
    try:
        os.fsync(opened)
    finally:
        os.close(opened)
