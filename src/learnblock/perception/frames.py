"""The pictures that detectors look at."""

import numpy as np
from numpy.typing import NDArray

from learnblock.errors import LearnBlockError

Frame = NDArray[np.uint8]
#: Pixels; no camera's picture has a longer side, and a single row of millions of them OpenCV would
#: search for hours.
LONGEST_SIDE = 8192


class FrameError(LearnBlockError, ValueError):
    """What was given to a detector is no picture."""


def checked(frame: object) -> Frame:
    """`frame` itself, if it is a picture.

    Raises:
        FrameError: it is no uint8 array of shape (height, width, 3) with pixels in it, or a side is
            longer than `LONGEST_SIDE`.
    """
    expected = "expected an RGB picture: a numpy array of uint8 and shape (height, width, 3)"
    if not isinstance(frame, np.ndarray):
        raise FrameError(f"the frame is of type {type(frame).__name__}; {expected}")
    if frame.dtype != np.uint8:
        raise FrameError(f"the frame's values are {frame.dtype}; {expected}")
    if frame.ndim != 3 or frame.shape[2] != 3:
        raise FrameError(f"the frame's shape is {frame.shape}; {expected}")
    if frame.size == 0:
        raise FrameError(f"the frame is empty, its shape is {frame.shape}; {expected}")
    if max(frame.shape) > LONGEST_SIDE:
        raise FrameError(
            f"the frame's shape is {frame.shape}; a side has {LONGEST_SIDE} pixels at most"
        )
    return frame
