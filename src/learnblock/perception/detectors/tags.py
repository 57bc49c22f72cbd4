"""AprilTags of family 36h11, by OpenCV's detector."""

from collections.abc import Sequence
from functools import cache
from typing import TYPE_CHECKING

import cv2
import numpy as np
from numpy.typing import NDArray

from learnblock.errors import TagSizeError
from learnblock.perception.detections import Point, Tag
from learnblock.perception.detectors.tag_pose import pose_of
from learnblock.perception.frames import Frame, checked

if TYPE_CHECKING:
    from learnblock.perception.sight import Sight

Triple = tuple[float, float, float]


def look(sight: "Sight") -> tuple[Tag, ...]:
    return detect_tags(sight.frame, sight.focal, sight.tag_size)


def detect_tags(
    frame: Frame, focal: float | None = None, size: float | None = None
) -> tuple[Tag, ...]:
    """Find the tags in a frame, sorted by number, then from left to right, then from top to bottom.

    Args:
        frame: RGB, uint8, shape (height, width, 3).
        focal: the lens's focal length in pixels.
        size: the side of the tags' black square in mm; with `focal` it gives their poses.

    Raises:
        FrameError: `frame` is not a picture.
        TagSizeError: `focal` or `size` is not above zero.
    """
    for name, value in (("focal", focal), ("size", size)):
        if value is not None and not value > 0:
            raise TagSizeError("perception-tag-size", name=name, value=value)
    grey = cv2.cvtColor(checked(frame), cv2.COLOR_RGB2GRAY)
    squares, numbers, _ = _detector().detectMarkers(grey)
    tags = [
        _tag(int(number), corners.reshape(4, 2).astype(np.float64), frame, focal, size)
        for number, corners in zip(() if numbers is None else numbers.ravel(), squares, strict=True)
    ]
    return tuple(sorted(tags, key=lambda tag: (tag.id, tag.center)))


def _detector() -> cv2.aruco.ArucoDetector:
    return cv2.aruco.ArucoDetector(
        cv2.aruco.getPredefinedDictionary(cv2.aruco.DICT_APRILTAG_36h11), _parameters()
    )


@cache
def _parameters() -> cv2.aruco.DetectorParameters:
    parameters = cv2.aruco.DetectorParameters()
    parameters.cornerRefinementMethod = cv2.aruco.CORNER_REFINE_SUBPIX
    return parameters


def _tag(
    number: int,
    corners: NDArray[np.float64],
    frame: Frame,
    focal: float | None,
    size: float | None,
) -> Tag:
    height, width = frame.shape[:2]
    a, b, c, d = ((x, y) for x, y in corners.tolist())
    square = (a, b, c, d)
    pose = None
    if focal is not None and size is not None:
        pose = pose_of(corners, (width, height), focal, size)
    return Tag(
        number,
        crossing(square),
        square,
        pose,
        width,
        height,
    )


def crossing(corners: Sequence[Point]) -> Point:
    """The point where the diagonals meet: the image of the square's centre at any rotation."""
    # In homogeneous coordinates both a line through two points and the point where two lines meet
    # are products. Numpy's takes longer than the search for the tag's bits.
    a, b, c, d = ((x, y, 1.0) for x, y in corners)
    x, y, scale = _cross(_cross(a, c), _cross(b, d))
    return x / scale, y / scale


def _cross(a: Triple, b: Triple) -> Triple:
    return a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]
