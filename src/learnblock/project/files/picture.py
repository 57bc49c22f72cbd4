"""Pictures of projects, which pages send: small JPEG files."""

from collections.abc import Iterator

from learnblock.errors import LearnBlockError

#: The limit of a picture in bytes.
LARGEST_PICTURE = 80_000
#: The limit of a side in pixels, so that a small file does not become a huge picture in a browser.
LARGEST_SIDE = 1000

_START, _START_OF_SCAN = b"\xff\xd8", 0xDA
#: The headers with the size of the picture, for any kind of compression (ITU T.81, table B.1).
_FRAMES = frozenset(range(0xC0, 0xD0)) - {0xC4, 0xC8, 0xCC}


class PictureError(LearnBlockError, ValueError):
    """A file is not a picture of a project."""


def check_picture(data: bytes) -> None:
    """Check that bytes are a picture of a project.

    Raises:
        PictureError: they are not a JPEG, or too large.
    """
    width, height = _size(data) or (0, 0)
    sides_fit = 0 < width <= LARGEST_SIDE and 0 < height <= LARGEST_SIDE
    if len(data) > LARGEST_PICTURE or not sides_fit:
        raise PictureError("project-picture-wrong", limit=LARGEST_PICTURE, side=LARGEST_SIDE)


def _size(data: bytes) -> tuple[int, int] | None:
    """Width and height of a JPEG in pixels; None if the bytes are not a JPEG."""
    for kind, content in _segments(data):
        if kind in _FRAMES and len(content) > 5:
            return int.from_bytes(content[3:5]), int.from_bytes(content[1:3])
    return None


def _segments(data: bytes) -> Iterator[tuple[int, bytes]]:
    """The segments before the pixels, each with its kind."""
    at = len(_START)
    if data[:at] != _START:
        return
    while at + 4 <= len(data) and data[at] == 0xFF and data[at + 1] != _START_OF_SCAN:
        # The length counts its own two bytes.
        end = at + 2 + int.from_bytes(data[at + 2 : at + 4])
        if not at + 4 <= end <= len(data):
            return
        yield data[at + 1], data[at + 4 : end]
        at = end
