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
COLOURS = {"red": RED, "blue": BLUE}
# Black is judged by a pixel's brightest channel, which is at most this; by luminance, pure blue is
# as dark.
BLACK = 50
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
    height, width = checked(frame).shape[:2]
    top, bottom = (round(row * height / 240) for row in ROWS)
    # Colours are dilated into the searched region from at most this many rows around it.
    reach = _reach(height)
    above = max(0, top - reach)
    around = frame[above : bottom + reach]
    channels = cv2.split(around)
    brightest = cv2.max(cv2.max(channels[0], channels[1]), channels[2])
    searched = brightest[top - above :][: bottom - top]
    masks = {"black": cv2.threshold(searched, BLACK, 255, cv2.THRESH_BINARY_INV)[1]}
    if _may_have_colours(channels, brightest):
        hsv = cv2.cvtColor(around, cv2.COLOR_RGB2HSV)
        for colour, ranges in COLOURS.items():
            masks[colour] = _coloured(hsv, ranges, reach)[top - above :][: bottom - top]
    views = (_view(colour, masks.get(colour), width, height) for colour in ("black", *COLOURS))
    return Lines(*views)


def _reach(height: int) -> int:
    return max(1, round(DILATION * height / 240))


def _may_have_colours(
    channels: Sequence[cv2.typing.MatLike], brightest: cv2.typing.MatLike
) -> bool:
    """Whether any pixel may be red or blue: most floors are grey, and most lines black.

    A saturation of 50 means that the channels differ by almost a fifth of the brightest one.

    Args:
        channels: red, green and blue.
        brightest: the brightest channel of each pixel.
    """
    red, green, blue = channels
    difference = cv2.subtract(brightest, cv2.min(cv2.min(red, green), blue))
    if not cv2.hasNonZero(difference):
        return False
    return cv2.hasNonZero(cv2.subtract(difference, cv2.convertScaleAbs(brightest, alpha=0.18)))


def _coloured(
    hsv: cv2.typing.MatLike, ranges: Sequence[tuple[Triple, Triple]], reach: int
) -> cv2.typing.MatLike:
    """A mask, 255 if a pixel is within one of the ranges, dilated."""
    mask = cv2.inRange(hsv, *ranges[0])
    for low, high in ranges[1:]:
        mask = cv2.bitwise_or(mask, cv2.inRange(hsv, low, high))
    if not cv2.hasNonZero(mask):
        return mask
    return cv2.dilate(mask, np.ones((3, 3), np.uint8), iterations=reach)


def _view(colour: str, mask: cv2.typing.MatLike | None, width: int, height: int) -> LineView:
    if mask is None:
        return LineView(colour, 0, 0, 0, width, height)
    borders = [round(column * width / 320) for column in COLUMNS]
    left, center, right = (
        cv2.countNonZero(mask[:, begin:end]) if begin < end else 0
        for begin, end in pairwise(borders)
    )
    return LineView(colour, left, center, right, width, height)
