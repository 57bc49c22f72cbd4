"""A recorded video as a camera."""

import math
import threading
from collections.abc import Callable
from pathlib import Path

import cv2

from learnblock.closing import Closing
from learnblock.errors import RobotConnectionError
from learnblock.perception.frames import Frame
from learnblock.perception.sources.frames import frame_of

#: Pictures per second of a file that does not give its rate.
USUAL_RATE = 30.0


class Recording(Closing):
    """A video file as a camera: it shows the picture at the robot's time, and repeats.

    Every run thus sees the same pictures, at any speed.

    Args:
        path: the path of the file.
        time: returns the robot's time in seconds.
    """

    def __init__(self, path: Path, time: Callable[[], float]) -> None:
        self._path = path
        self._time = time
        self._turn = threading.Lock()
        self._capture: cv2.VideoCapture | None = None
        self._rate = USUAL_RATE
        #: The number of pictures read in this repetition, and the last one.
        self._passed = 0
        self._frame: Frame | None = None
        #: The number of pictures in the file, once its end has been reached.
        self._length = 0

    def read(self) -> Frame:
        """The current picture; the same object while the picture is the same.

        Raises:
            RobotConnectionError: there is no such file, or it contains no pictures.
        """
        with self._turn:
            capture = self._opened()
            wanted = int(self._time() * self._rate)
            if self._length:
                wanted %= self._length
            if wanted + 1 < self._passed:
                self._rewind(capture)
            while self._passed <= wanted or self._frame is None:
                wanted = self._pass_one(capture, wanted)
            return self._frame

    def close(self) -> None:
        """Close the file; calling it twice is harmless."""
        with self._turn:
            if self._capture:
                self._capture.release()
                self._capture = None

    def _opened(self) -> cv2.VideoCapture:
        if self._capture is None:
            # OpenCV would interpret other strings as addresses, or as patterns of file names.
            if not self._path.is_file():
                raise RobotConnectionError("perception-video-missing", path=str(self._path))
            self._capture = cv2.VideoCapture(str(self._path))
            rate = self._capture.get(cv2.CAP_PROP_FPS)
            self._rate = rate if math.isfinite(rate) and 0 < rate <= 1000 else USUAL_RATE
            self._passed = 0
        return self._capture

    def _pass_one(self, capture: cv2.VideoCapture, wanted: int) -> int:
        """Skip one picture, or decode it if it is requested; return the requested number."""
        if not capture.grab():
            if not self._passed:
                raise RobotConnectionError("perception-video-unreadable", path=str(self._path))
            self._length = self._passed
            self._rewind(capture)
            return wanted % self._length
        self._passed += 1
        if self._passed > wanted:
            is_read, picture = capture.retrieve()
            # A damaged picture leaves the previous one in place.
            self._frame = frame_of(picture) if is_read else self._frame
        return wanted

    def _rewind(self, capture: cv2.VideoCapture) -> None:
        # Not by seeking, which works only in intact files.
        capture.open(str(self._path))
        self._passed = 0
