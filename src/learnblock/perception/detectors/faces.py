"""Faces seen from the front, by OpenCV's Haar cascade (Viola and Jones 2001)."""

import threading
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING

import cv2

from learnblock.perception.detections import Face
from learnblock.perception.frames import Frame, checked

if TYPE_CHECKING:
    from learnblock.perception.sight import Sight

CASCADE = "haarcascade_frontalface_default.xml"
# Each pass of the cascade looks for faces larger by this factor.
SCALE_STEP = 1.1
# The number of overlapping finds that make a face; with fewer, walls and lines pass for one.
NEIGHBOURS = 4
# The smallest face, in pixels of a frame 240 high.
SMALLEST = 30
# OpenCV's classifier has its own working memory, so one frame at a time.
_TURN = threading.Lock()


def look(sight: "Sight") -> tuple[Face, ...]:
    return detect_faces(sight.frame)


def detect_faces(frame: Frame) -> tuple[Face, ...]:
    """The faces in a frame, from left to right, then from top to bottom.

    Args:
        frame: RGB, uint8, shape (height, width, 3).

    Raises:
        FrameError: `frame` is not a picture.
    """
    height, width = checked(frame).shape[:2]
    grey = cv2.cvtColor(frame, cv2.COLOR_RGB2GRAY)
    smallest = max(20, round(SMALLEST * height / 240))
    with _TURN:
        boxes = _cascade().detectMultiScale(
            grey, SCALE_STEP, NEIGHBOURS, minSize=(smallest, smallest)
        )
    faces = [Face(int(x), int(y), int(w), int(h), width, height) for x, y, w, h in boxes]
    return tuple(sorted(faces, key=lambda face: (face.x, face.y)))


@cache
def _cascade() -> cv2.CascadeClassifier:
    folder = Path(cv2.__file__).parent / "data"
    return cv2.CascadeClassifier(str(folder / CASCADE))
