"""The pictures that detectors search."""

import numpy as np
from numpy.typing import NDArray

from learnblock.errors import FrameError

Frame = NDArray[np.uint8]
#: The limit in pixels; no camera exceeds it, and OpenCV would search one row of millions of
#: pixels for hours.
LONGEST_SIDE = 8192


def checked(frame: object) -> Frame:
    """Return `frame` itself if it is a picture.

    Raises:
        FrameError: it is not a uint8 array of shape (height, width, 3), it is empty, or a side is
            longer than `LONGEST_SIDE`.
    """
    if not isinstance(frame, np.ndarray):
        raise FrameError("perception-frame-not-array", type=type(frame).__name__)
    if frame.dtype != np.uint8:
        raise FrameError("perception-frame-not-uint8", type=str(frame.dtype))
    if frame.ndim != 3 or frame.shape[2] != 3:
        raise FrameError("perception-frame-wrong-shape", shape=str(frame.shape))
    if frame.size == 0:
        raise FrameError("perception-frame-empty", shape=str(frame.shape))
    if max(frame.shape) > LONGEST_SIDE:
        shape = str(frame.shape)
        raise FrameError("perception-frame-too-large", shape=shape, limit=LONGEST_SIDE)
    return frame
