"""A pupil's work in lessons at a hub, as the pupil's server last reported it.

There the class does not reach the pupil's projects, from which it is read elsewhere.
"""

from pathlib import Path

import msgspec

from learnblock.project.files.lesson_work import LessonWork
from learnblock.storage.files import save

_NAME = "lessons.json"
#: The limit of the file in bytes.
_LARGEST = 2_000_000
_read = msgspec.json.Decoder(tuple[LessonWork, ...]).decode


class LessonWorkFile:
    """Where the work is kept.

    Args:
        folder: the class's folder for the pupil, which may not exist yet.
    """

    def __init__(self, folder: Path) -> None:
        self._path = folder / _NAME

    def keep(self, works: tuple[LessonWork, ...]) -> None:
        """Keep the work in place of what was known.

        Raises:
            OSError: it can't be saved.
        """
        content = msgspec.json.encode(works)
        if len(content) <= _LARGEST:
            self._path.parent.mkdir(parents=True, exist_ok=True)
            save(self._path, content)

    def works(self) -> tuple[LessonWork, ...] | None:
        """The work; None if none is known, or the file is damaged."""
        try:
            with self._path.open("rb") as file:
                return _read(file.read(_LARGEST + 1))
        except (OSError, msgspec.MsgspecError, RecursionError):
            return None
