"""Frames from OpenCV's pictures."""

import cv2
import numpy as np

from learnblock.perception.frames import Frame

#: Larger pictures are made smaller: detectors would take too long, and see hardly more.
MOST_COLUMNS = 640


def frame_of(picture: cv2.typing.MatLike) -> Frame:
    """A frame, uint8 RGB (height, width, 3), not to be written to, of one of OpenCV's pictures."""
    rows, columns = picture.shape[:2]
    if columns > MOST_COLUMNS:
        size = MOST_COLUMNS, max(1, round(rows * MOST_COLUMNS / columns))
        picture = cv2.resize(picture, size, interpolation=cv2.INTER_AREA)
    frame = np.asarray(cv2.cvtColor(picture, cv2.COLOR_BGR2RGB), np.uint8)
    frame.flags.writeable = False
    return frame
