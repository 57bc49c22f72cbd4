"""Black, red and blue lines, by the colours of pixels in three parts of a frame."""

from collections.abc import Sequence
from itertools import pairwise
from typing import TYPE_CHECKING

import cv2
import numpy as np

from learnblock.perception.detections import Lines, LineView
from learnblock.perception.frames import Frame, checked

if TYPE_CHECKING:
    from learnblock.perception.sight import Sight

Triple = tuple[int, int, int]

# Hue (0 to 180), saturation and value in OpenCV's units. Red is at both ends of the scale.
RED = (((0, 50, 100), (10, 255, 255)), ((170, 50, 100), (180, 255, 255)))
BLUE = (((100, 50, 50), (130, 255, 255)),)
# Black is judged by value, a pixel's brightest channel; by luminance, pure blue is as dark.
BLACK = ((0, 0, 0), (180, 255, 50))
# In a frame of 320 by 240: the searched region, and the pixels by which colours are dilated.
ROWS = (15, 225)
COLUMNS = (0, 120, 200, 320)
DILATION = 3


def look(sight: "Sight") -> Lines:
    return detect_lines(sight.frame)


def detect_lines(frame: Frame) -> Lines:
    """Count black, red and blue pixels in the left, the centre and the right of a frame.

    Args:
        frame: RGB, uint8, shape (height, width, 3).

    Returns:
        The pixel counts; a colour without a line has few or none.

    Raises:
        FrameError: `frame` is not a picture.
    """
    height = checked(frame).shape[0]
    rows = slice(*(round(row * height / 240) for row in ROWS))
    hsv = cv2.cvtColor(frame, cv2.COLOR_RGB2HSV)
    return Lines(
        black=_view("black", np.asarray(cv2.inRange(hsv[rows], *BLACK), np.uint8), frame),
        red=_view("red", _coloured(hsv, RED)[rows], frame),
        blue=_view("blue", _coloured(hsv, BLUE)[rows], frame),
    )


def _coloured(hsv: cv2.typing.MatLike, ranges: Sequence[tuple[Triple, Triple]]) -> Frame:
    """A mask, 255 if a pixel is within one of the ranges, dilated."""
    mask = cv2.inRange(hsv, *ranges[0])
    for low, high in ranges[1:]:
        mask = cv2.bitwise_or(mask, cv2.inRange(hsv, low, high))
    times = max(1, round(DILATION * hsv.shape[0] / 240))
    return np.asarray(cv2.dilate(mask, np.ones((3, 3), np.uint8), iterations=times), np.uint8)


def _view(colour: str, mask: Frame, frame: Frame) -> LineView:
    height, width = frame.shape[:2]
    borders = [round(column * width / 320) for column in COLUMNS]
    left, center, right = (
        int(np.count_nonzero(mask[:, begin:end])) for begin, end in pairwise(borders)
    )
    return LineView(colour, left, center, right, width, height)
