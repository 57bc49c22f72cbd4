"""Files that are written as a whole or not at all."""

import os
import re
from pathlib import Path

_DEVICE = re.compile(r"(?:con|prn|aux|nul|com\d|lpt\d)(?:\..*)?", re.IGNORECASE)


def is_device_name(name: str) -> bool:
    """Whether Windows keeps the name to a device, with any ending: no file can be called so."""
    return bool(_DEVICE.fullmatch(name))


def save(path: Path, data: bytes) -> None:
    """Write a file so that a crash, even of the machine, leaves the old file or the new one.

    Raises:
        OSError: it cannot be written; the old one is as it was.
    """
    path.parent.mkdir(parents=True, exist_ok=True)
    # Hidden, and with an ending that nobody lists, until it is complete.
    unfinished = path.with_name(f".{path.name}.new")
    with unfinished.open("wb") as file:
        file.write(data)
        file.flush()
        os.fsync(file.fileno())
    unfinished.replace(path)
    _sync(path.parent)


def _sync(folder: Path) -> None:
    """Make the new name as lasting as the file."""
    if os.name == "nt":
        # Windows opens no folders, and keeps names by itself.
        return
    opened = os.open(folder, os.O_RDONLY)
    try:
        os.fsync(opened)
    finally:
        os.close(opened)
