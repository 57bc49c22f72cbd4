"""New files: all of them are written, or none, and none that is there already."""

from collections.abc import Mapping
from pathlib import Path

from learnblock.errors import FileTakenError
from learnblock.files import save


def write_new(files: Mapping[Path, str], *, force: bool = False) -> None:
    """Write files.

    Args:
        files: their texts by their paths.
        force: replace those that are there.

    Raises:
        FileTakenError: one is there already; then nothing is written.
        OSError: one cannot be written.
    """
    taken = [str(path) for path in files if path.exists()]
    if taken and not force:
        raise FileTakenError(
            f"there is already {', '.join(taken)}; choose another name, or replace it with --force"
        )
    for path, text in files.items():
        save(path, text.encode())
