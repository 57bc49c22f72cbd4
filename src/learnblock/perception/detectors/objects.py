"""Objects of one strong colour: red, orange, yellow, green, blue or purple."""

from collections.abc import Iterator
from typing import TYPE_CHECKING

import cv2
import numpy as np
from numpy.typing import NDArray

from learnblock.perception.detections import ColouredObject
from learnblock.perception.frames import Frame, checked

if TYPE_CHECKING:
    from learnblock.perception.sight import Sight

COLOURS = ("red", "orange", "yellow", "green", "blue", "purple")
# Where each colour's hues end, in OpenCV's units (0 to 180); beyond purple is red again.
HUES = (8, 21, 34, 85, 130, 165)
# Below these, a colour is grey or too dark to be recognised, like skin, wood and paper.
SATURATION, VALUE = 110, 60
# The smallest object, in pixels of a frame of 320 by 240: smaller ones may be noise.
SMALLEST = 60


def look(sight: "Sight") -> tuple[ColouredObject, ...]:
    return detect_objects(sight.frame)


def detect_objects(frame: Frame) -> tuple[ColouredObject, ...]:
    """The coloured objects in a frame, the largest first.

    Objects of the same colour that touch in the frame count as one.

    Args:
        frame: RGB, uint8, shape (height, width, 3).

    Raises:
        FrameError: `frame` is not a picture.
    """
    height, width = checked(frame).shape[:2]
    smallest = max(1, round(SMALLEST * width * height / (320 * 240)))
    classes = _classes(frame)
    counts = np.bincount(classes.ravel(), minlength=len(COLOURS) + 1)
    blobs = [
        blob
        for number, colour in enumerate(COLOURS, 1)
        if counts[number] >= smallest
        for blob in _blobs(classes == number, colour)
        if blob.area >= smallest
    ]
    return tuple(sorted(blobs, key=lambda blob: (-blob.area, blob.x, blob.y)))


def _classes(frame: Frame) -> NDArray[np.uint8]:
    """For each pixel the number of its colour, from 1, or 0."""
    hsv = cv2.cvtColor(frame, cv2.COLOR_RGB2HSV)
    strong = cv2.inRange(hsv, (0, SATURATION, VALUE), (180, 255, 255))
    numbers = cv2.LUT(cv2.extractChannel(hsv, 0), _BY_HUE)
    return np.asarray(cv2.bitwise_and(numbers, strong), np.uint8)


def _by_hue() -> NDArray[np.uint8]:
    numbers = np.searchsorted(HUES, np.arange(256), side="left") + 1
    return np.where(numbers > len(COLOURS), 1, numbers).astype(np.uint8)


_BY_HUE = _by_hue()


def _blobs(mask: NDArray[np.bool_], colour: str) -> Iterator[ColouredObject]:
    height, width = mask.shape
    # Single pixels are noise, and a row of them does not connect two objects.
    opened = cv2.morphologyEx(mask.astype(np.uint8), cv2.MORPH_OPEN, np.ones((3, 3), np.uint8))
    _, _, measures, centers = cv2.connectedComponentsWithStats(opened)
    # The first component is the rest of the frame.
    for (x, y, w, h, area), (column, row) in zip(
        measures[1:].tolist(), centers[1:].tolist(), strict=True
    ):
        yield ColouredObject(colour, (column, row), area, x, y, w, h, width, height)
