"""Names of projects that every file system takes."""

import re
import unicodedata
from collections.abc import Iterator
from itertools import count

from learnblock.errors import ProjectError
from learnblock.project.files.project import LONGEST_NAME, checked_name
from learnblock.storage.files import is_device_name

_NOT_IN_NAMES = re.compile(r"[^\w .-]+")


def names_like(wish: str) -> Iterator[str]:
    """List the names for a project with a wish, best first: `wish`, `wish 2`, `wish 3`, ..."""
    plain = _plain(wish)
    yield plain
    for number in count(2):
        yield f"{plain} {number}"


def _plain(wish: str) -> str:
    """Convert any string to a valid project name."""
    wish = unicodedata.normalize("NFC", wish)
    short = _NOT_IN_NAMES.sub(" ", wish).encode("utf-8", "ignore")[: LONGEST_NAME - 10]
    name = short.decode("utf-8", "ignore").strip(" ._-")
    if is_device_name(name):
        # Windows has no file with such a name, but one that contains it.
        name = f"program {name}"
    try:
        return checked_name(name)
    except ProjectError:
        return "program"
