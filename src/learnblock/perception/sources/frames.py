"""Frames from OpenCV's pictures."""

import cv2
import numpy as np

from learnblock.perception.frames import Frame

#: Larger pictures are scaled down: detectors would take longer and find little more.
MOST_COLUMNS = 640


def frame_of(picture: cv2.typing.MatLike) -> Frame:
    """Convert one of OpenCV's pictures to a frame, read-only uint8 RGB (height, width, 3)."""
    rows, columns = picture.shape[:2]
    if columns > MOST_COLUMNS:
        size = MOST_COLUMNS, max(1, round(rows * MOST_COLUMNS / columns))
        picture = cv2.resize(picture, size, interpolation=cv2.INTER_AREA)
    frame = np.asarray(cv2.cvtColor(picture, cv2.COLOR_BGR2RGB), np.uint8)
    frame.flags.writeable = False
    return frame
