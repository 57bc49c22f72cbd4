"""Frames as the pictures that travel to and from components."""

from enum import StrEnum

import cv2
import numpy as np

from learnblock.errors import LearnBlockError
from learnblock.ice.robocomp.recognition import Picture
from learnblock.perception.frames import Frame

#: No picture has a longer side, nor more pixels: a full HD camera's, and some more. In a picture of
#: one long row some of OpenCV's detectors look for hours.
LONGEST_SIDE = 1920
MOST_PIXELS = 1920 * 1200


class PictureError(LearnBlockError, ValueError):
    """What was sent is no picture."""


class Order(StrEnum):
    """What a picture's two numbers mean; the pixels stand row by row in either."""

    #: `width` carries the number of rows, `height` that of columns: RoboComp's components, and the
    #: paper's tool, hand on the shape of an array.
    ROWS = "rows"
    #: The numbers are what they are called.
    COLUMNS = "columns"


def packed(frame: Frame, order: Order) -> Picture:
    """A frame as a picture."""
    rows, columns, depth = frame.shape
    width, height = (rows, columns) if order is Order.ROWS else (columns, rows)
    return Picture(width, height, depth, np.ascontiguousarray(frame).tobytes())


def unpacked(picture: Picture, order: Order | None = None) -> Frame:
    """A picture as a frame.

    Args:
        picture: as it was sent.
        order: what its numbers mean; None finds it out.

    Raises:
        PictureError: it is none, or larger than any that a camera takes.
    """
    _check(picture)
    in_rows = _shaped(picture, picture.width, picture.height)
    if order is Order.ROWS or picture.width == picture.height:
        return in_rows
    in_columns = _shaped(picture, picture.height, picture.width)
    if order is Order.COLUMNS or _roughness(in_columns) < _roughness(in_rows):
        return in_columns
    return in_rows


def _check(picture: Picture) -> None:
    width, height, depth, size = picture.width, picture.height, picture.depth, len(picture.image)
    said = f"a picture of {width} by {height} pixels with {depth} bytes each"
    if min(width, height) < 1 or depth != 3:
        raise PictureError(f"{said} cannot be looked at: RGB is expected, 3 bytes a pixel")
    if max(width, height) > LONGEST_SIDE or width * height > MOST_PIXELS:
        raise PictureError(f"{said} is too large: 1920 by 1200 are allowed")
    if width * height * depth != size:
        raise PictureError(f"{said} has {width * height * depth} bytes, not the {size} sent")


def _shaped(picture: Picture, rows: int, columns: int) -> Frame:
    return np.frombuffer(picture.image, np.uint8).reshape(rows, columns, 3)


def _roughness(frame: Frame) -> float:
    """How much pixels differ from those beneath them; least where the rows are the true ones."""
    if len(frame) < 2:
        return float("inf")
    return cv2.norm(frame[1:], frame[:-1], cv2.NORM_L1) / frame[1:].size
