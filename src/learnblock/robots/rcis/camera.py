"""Decodes the pictures of the camera in RCIS."""

from math import isqrt
from typing import TYPE_CHECKING

from learnblock.errors import RobotConnectionError

if TYPE_CHECKING:
    from learnblock.devices import Frame


class FrameConverter:
    """Converts packed RGB bytes to frames; the same picture twice gives the same frame."""

    def __init__(self) -> None:
        self._bytes: bytes | None = None
        self._frame: Frame | None = None

    def unpacked(self, packed: bytes) -> "Frame | None":
        """The picture as a frame; None before the first picture.

        Raises:
            RobotConnectionError: the number of bytes does not match any picture size.
        """
        if not packed:
            return None
        if packed != self._bytes:
            import numpy as np  # noqa: PLC0415 - not needed if the camera is not used

            self._frame = np.frombuffer(packed, np.uint8).reshape(shape_of(len(packed)))
            self._bytes = packed
        return self._frame


def shape_of(size: int) -> tuple[int, int, int]:
    """Rows, columns and bytes per pixel of a 4:3 picture with this many bytes.

    Some cameras swap width and height in their parameters, so only the number of bytes is reliable.

    Raises:
        RobotConnectionError: no 4:3 picture has this many bytes.
    """
    # 4 n columns and 3 n rows of 3 bytes.
    unit = isqrt(size // 36)
    if not unit or 36 * unit * unit != size:
        raise RobotConnectionError("rcis-picture-size", bytes=size)
    return 3 * unit, 4 * unit, 3
