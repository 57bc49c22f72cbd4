"""New files: either all of them are written or none, and no existing file is replaced."""

from collections.abc import Mapping
from pathlib import Path

from learnblock.errors import FileTakenError
from learnblock.storage.files import save


def write_new(files: Mapping[Path, str], *, force: bool = False) -> None:
    """Write new files.

    Args:
        files: the text of each file, by path.
        force: replace existing files.

    Raises:
        FileTakenError: one of them exists, so nothing is written.
        OSError: one cannot be written.
    """
    existing = tuple(str(path) for path in files if path.exists())
    if existing and not force:
        raise FileTakenError("new-files-exist", files=existing)
    for path, text in files.items():
        save(path, text.encode())
