"""The user's own lessons: files in a folder of LEARNBLOCK_HOME."""

import re
from pathlib import Path

from learnblock.lessons.archive import SUFFIX
from learnblock.storage.home import home

#: The folder of lessons in a home.
FOLDER = "lessons"
#: More files than this are not read.
MOST_OWN = 200

_NAME = re.compile(r"\w[\w .-]{0,78}\w")


def own_folder() -> Path:
    """Where the user's own lessons are, if there are any."""
    return home() / FOLDER


def own_files() -> list[Path]:
    """The files of the user's lessons."""
    files = (file for file in own_folder().glob(f"*{SUFFIX}") if is_name(file.stem))
    return sorted(files)[:MOST_OWN]


def is_name(text: str) -> bool:
    """Whether a lesson of the user's can have this name."""
    return _NAME.fullmatch(text) is not None
