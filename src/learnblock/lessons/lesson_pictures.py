"""The pictures in a lesson's texts, for pages without a server."""

import base64
import re
from collections.abc import Iterable
from pathlib import PurePosixPath
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from learnblock.lessons.opened import OpenLesson

_PICTURE = re.compile(r"!\[[^\[\]\n]*\]\((?:\./)?(?:pictures/)?([\w-]{1,60}\.\w{1,8})\)")
#: The types of a lesson's pictures, by the endings of their files.
PICTURE_TYPES = {
    ".png": "image/png",
    ".jpg": "image/jpeg",
    ".jpeg": "image/jpeg",
    ".svg": "image/svg+xml",
}


def pictures_in(opened: "OpenLesson", texts: Iterable[str]) -> dict[str, str]:
    """The pictures that texts in Markdown show, as addresses with their data, by their names."""
    names = dict.fromkeys(name for text in texts for name in _PICTURE.findall(text))
    files = ((name, opened.files.get(f"pictures/{name}")) for name in names)
    return {name: address for name, data in files if data and (address := _address(name, data))}


def _address(name: str, data: bytes) -> str:
    """The address of a picture with its data; empty if it is none that browsers show."""
    kind = PICTURE_TYPES.get(PurePosixPath(name).suffix.lower())
    return f"data:{kind};base64,{base64.b64encode(data).decode()}" if kind else ""
