"""The pictures of RCIS's camera."""

from math import isqrt
from typing import TYPE_CHECKING

from learnblock.errors import RobotConnectionError

if TYPE_CHECKING:
    from learnblock.devices import Frame


class Pictures:
    """Makes frames of packed RGB bytes; the same picture twice gives the same frame."""

    def __init__(self) -> None:
        self._bytes: bytes | None = None
        self._frame: Frame | None = None

    def unpacked(self, packed: bytes) -> "Frame | None":
        """The picture as a frame; None where there is none yet.

        Raises:
            RobotConnectionError: so many bytes are no picture.
        """
        if not packed:
            return None
        if packed != self._bytes:
            import numpy as np  # noqa: PLC0415 - a robot whose camera nobody uses needs none

            self._frame = np.frombuffer(packed, np.uint8).reshape(shape_of(len(packed)))
            self._bytes = packed
        return self._frame


def shape_of(size: int) -> tuple[int, int, int]:
    """Rows, columns and bytes a pixel of a picture of 4 to 3 with so many bytes.

    The camera's parameters name its rows width and its columns height, or the other way round: the
    number of bytes alone cannot be mistaken.

    Raises:
        RobotConnectionError: so many bytes are no such picture.
    """
    # 4 n columns and 3 n rows of 3 bytes.
    unit = isqrt(size // 36)
    if not unit or 36 * unit * unit != size:
        raise RobotConnectionError(
            f"the camera of the robot `rcis` sends pictures of {size} bytes, which are none of"
            " 4 to 3, such as 320 by 240, in RGB"
        )
    return 3 * unit, 4 * unit, 3
