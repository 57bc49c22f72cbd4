"""A recorded video as a camera."""

import math
import threading
from collections.abc import Callable
from pathlib import Path

import cv2

from learnblock.closing import Closing
from learnblock.errors import RobotConnectionError
from learnblock.perception.frames import Frame
from learnblock.vision.frames import frame_of

#: Pictures a second of a file that does not say how many it has.
USUAL_RATE = 30.0


class Recording(Closing):
    """A video file: it shows the picture of the robot's time, and begins again behind its end.

    So a run sees the same each time, however fast it goes.

    Args:
        path: of the file.
        time: answers the robot's time, s.
    """

    def __init__(self, path: Path, time: Callable[[], float]) -> None:
        self._path = path
        self._time = time
        self._turn = threading.Lock()
        self._capture: cv2.VideoCapture | None = None
        self._rate = USUAL_RATE
        #: How many pictures of this round have been passed, and the last of them.
        self._passed = 0
        self._frame: Frame | None = None
        #: How many there are, once its end was seen.
        self._length = 0

    def read(self) -> Frame:
        """The picture of now; the same object as long as it is the same picture.

        Raises:
            RobotConnectionError: there is no such file, or it holds no pictures.
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
        """Let go of the file; the second time it does nothing."""
        with self._turn:
            if self._capture:
                self._capture.release()
                self._capture = None

    def _opened(self) -> cv2.VideoCapture:
        if self._capture is None:
            # OpenCV would take other texts for addresses, or for the names of many pictures.
            if not self._path.is_file():
                raise self._told("there is no such file")
            self._capture = cv2.VideoCapture(str(self._path))
            rate = self._capture.get(cv2.CAP_PROP_FPS)
            self._rate = rate if math.isfinite(rate) and 0 < rate <= 1000 else USUAL_RATE
            self._passed = 0
        return self._capture

    def _pass_one(self, capture: cv2.VideoCapture, wanted: int) -> int:
        """Go on by one picture, and look at it if it is the wanted one; answer which one is."""
        if not capture.grab():
            if not self._passed:
                raise self._told("it holds no pictures that could be read")
            self._length = self._passed
            self._rewind(capture)
            return wanted % self._length
        self._passed += 1
        if self._passed > wanted:
            is_read, picture = capture.retrieve()
            # A picture that is damaged leaves the one before.
            self._frame = frame_of(picture) if is_read else self._frame
        return wanted

    def _rewind(self, capture: cv2.VideoCapture) -> None:
        # Not by its position, which is found only in a file that is whole.
        capture.open(str(self._path))
        self._passed = 0

    def _told(self, trouble: str) -> RobotConnectionError:
        return RobotConnectionError(
            f"the video {self._path} cannot be seen: {trouble};"
            " `learnblock perception set video --default` does without it"
        )
