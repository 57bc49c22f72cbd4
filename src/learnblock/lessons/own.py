"""The user's own lessons: files in the folder ``lessons`` of LEARNBLOCK_HOME."""

import re
from pathlib import Path

from learnblock.lessons.archive import SUFFIX
from learnblock.storage.home import home

#: More files than this are not read.
MOST = 200

_NAME = re.compile(r"\w[\w .-]{0,78}\w")


def own_folder() -> Path:
    """Where the user's own lessons are, if there are any."""
    return home() / "lessons"


def own_files() -> list[Path]:
    """The files of the user's lessons."""
    files = (file for file in own_folder().glob(f"*{SUFFIX}") if is_name(file.stem))
    return sorted(files)[:MOST]


def is_name(text: str) -> bool:
    """Whether a lesson of the user's can have this name."""
    return _NAME.fullmatch(text) is not None
