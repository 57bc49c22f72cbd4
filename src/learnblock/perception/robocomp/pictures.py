"""Frames as the pictures sent to and from components."""

from enum import StrEnum

import cv2
import numpy as np

from learnblock.errors import PictureError
from learnblock.ice.robocomp.recognition import Picture
from learnblock.perception.frames import Frame

#: The longest side and the most pixels of a picture, a little more than full HD. Some of OpenCV's
#: detectors would search a picture of one long row for hours.
LONGEST_SIDE = 1920
MOST_PIXELS = 1920 * 1200


class PixelOrder(StrEnum):
    """The meaning of a picture's two numbers; the pixels are in rows in either case."""

    #: `width` is the number of rows, `height` the number of columns: RoboComp's components, and the
    #: paper's tool, send the shape of an array.
    ROWS = "rows"
    #: The numbers have the meaning of their names.
    COLUMNS = "columns"


def packed(frame: Frame, order: PixelOrder) -> Picture:
    """Convert a frame to a picture."""
    rows, columns, depth = frame.shape
    width, height = (rows, columns) if order is PixelOrder.ROWS else (columns, rows)
    return Picture(width, height, depth, np.ascontiguousarray(frame).tobytes())


def unpacked(picture: Picture, order: PixelOrder | None = None) -> Frame:
    """Convert a picture to a frame.

    Args:
        picture: the picture as received.
        order: the meaning of its numbers; None detects it.

    Raises:
        PictureError: it is not RGB, too large or incomplete.
    """
    _check(picture)
    in_rows = _shaped(picture, picture.width, picture.height)
    if order is PixelOrder.ROWS or picture.width == picture.height:
        return in_rows
    in_columns = _shaped(picture, picture.height, picture.width)
    if order is PixelOrder.COLUMNS or _roughness(in_columns) < _roughness(in_rows):
        return in_columns
    return in_rows


def _check(picture: Picture) -> None:
    width, height, depth, size = picture.width, picture.height, picture.depth, len(picture.image)
    if min(width, height) < 1 or depth != 3:
        raise PictureError("perception-picture-not-rgb", width=width, height=height, depth=depth)
    if max(width, height) > LONGEST_SIDE or width * height > MOST_PIXELS:
        raise PictureError("perception-picture-too-large", width=width, height=height)
    if width * height * depth != size:
        expected = width * height * depth
        raise PictureError(
            "perception-picture-wrong-size",
            width=width,
            height=height,
            expected=expected,
            size=size,
        )


def _shaped(picture: Picture, rows: int, columns: int) -> Frame:
    return np.frombuffer(picture.image, np.uint8).reshape(rows, columns, 3)


def _roughness(frame: Frame) -> float:
    """How much pixels differ from those below them; minimal if the row length is correct."""
    if len(frame) < 2:
        return float("inf")
    return cv2.norm(frame[1:], frame[:-1], cv2.NORM_L1) / frame[1:].size
