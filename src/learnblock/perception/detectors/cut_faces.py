"""Faces that the edge of the frame cuts: not recognised as faces, but not taken for a line either.

What is left of a face is a patch of skin at the edge, with eyes, a mouth or an ear in it. Without
any of these it may be another thing of this colour, but no red line is as pale as skin.
"""

from collections.abc import Iterator
from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from learnblock.perception.frames import Frame

Mask = cv2.typing.MatLike

# The frame is searched with about this many rows, in whose pixels all lengths here are.
ROWS = 120
# Hue (0 to 180), saturation and value in OpenCV's units.
SKIN = ((6, 45, 80), (14, 170, 255))
# The rim of a red line is as pale as skin. With more than this share of so much colour beside it, a
# patch is such a rim.
VIVID, BESIDE = 190, 0.05
# The distance of something cut from the edge.
EDGE = 2
# The shortest side of a patch, and the largest share of the frame that it takes.
SHORTEST, LARGEST = 6, 0.5
# The shares of its outline that are skin, and that are neither skin nor at its rim.
FILLED, FEATURES = 0.45, 0.02
# A head is larger than the patch by these shares of the patch's longer side: left and right, above
# and below, with hair, ears, neck and shoulders.
HEAD = (0.45, 0.6, 0.9)

_AROUND = np.ones((3, 3), np.uint8)


@dataclass(frozen=True, slots=True)
class _Box:
    x: int
    y: int
    width: int
    height: int


@dataclass(frozen=True, slots=True)
class CutSkin:
    """A patch of skin at an edge of the frame.

    Args:
        outline: of the patch, or of the head if it is a face; in pixels of the frame.
        is_face: whether it is one.
    """

    outline: NDArray[np.float64]
    is_face: bool


def cut_skin(frame: Frame) -> Iterator[CutSkin]:
    """Find skin that is cut by an edge of the frame.

    Args:
        frame: RGB, uint8, shape (height, width, 3).
    """
    step = max(1, round(frame.shape[0] / ROWS))
    # Without the camera's noise, which gives every wall some pixels of each colour.
    smooth = cv2.blur(np.ascontiguousarray(frame[::step, ::step]), (3, 3))
    hsv = cv2.cvtColor(smooth, cv2.COLOR_RGB2HSV)
    skin = cv2.inRange(hsv, *SKIN)
    if not cv2.hasNonZero(skin):
        return
    for contour in cv2.findContours(skin, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_SIMPLE)[0]:
        box = _Box(*cv2.boundingRect(contour))
        if not _is_at_edge(box, skin.shape) or _is_rim(hsv, box):
            continue
        if _is_face(skin, contour, box):
            yield CutSkin(step * _head(box), is_face=True)
        else:
            yield CutSkin(step * (cv2.convexHull(contour).reshape(-1, 2) + 0.5), is_face=False)


def _is_at_edge(box: _Box, shape: tuple[int, ...]) -> bool:
    """Whether a patch is cut, and neither a dot nor most of the frame."""
    height, width = shape
    is_cut = (
        min(box.x, box.y) <= EDGE
        or box.x + box.width >= width - EDGE
        or box.y + box.height >= height - EDGE
    )
    is_small = box.width * box.height <= LARGEST * width * height
    return is_cut and is_small and min(box.width, box.height) >= SHORTEST


def _is_rim(hsv: Mask, box: _Box) -> bool:
    """Whether a patch is beside something as colourful as a line."""
    around = hsv[
        max(0, box.y - EDGE) : box.y + box.height + EDGE,
        max(0, box.x - EDGE) : box.x + box.width + EDGE,
    ]
    hue, saturation, value = cv2.split(around)
    vivid = (saturation > VIVID) & (value >= SKIN[0][2]) & ((hue < SKIN[0][0]) | (hue > 165))
    return bool(np.count_nonzero(vivid) > BESIDE * box.width * box.height)


def _is_face(skin: Mask, contour: Mask, box: _Box) -> bool:
    """Whether a patch is full of skin, and something else is in it."""
    patch = skin[box.y : box.y + box.height, box.x : box.x + box.width]
    outline = cv2.convexHull(contour - np.array((box.x, box.y)))
    inside = cv2.fillConvexPoly(np.zeros_like(patch), outline, 255)
    area = cv2.countNonZero(inside)
    inner = cv2.erode(inside, _AROUND, iterations=2)
    features = cv2.countNonZero(cv2.subtract(inner, patch))
    filled = cv2.countNonZero(cv2.bitwise_and(inside, patch))
    return filled >= FILLED * area and features >= max(4, FEATURES * area)


def _head(box: _Box) -> NDArray[np.float64]:
    beside, above, below = (share * max(box.width, box.height) for share in HEAD)
    left, right = box.x - beside, box.x + box.width + beside
    top, bottom = box.y - above, box.y + box.height + below
    return np.array([(left, top), (right, top), (right, bottom), (left, bottom)])
