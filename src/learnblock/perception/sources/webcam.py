"""The computer's webcam as a camera."""

import threading
from contextlib import ExitStack

import cv2

from learnblock.closing import Closing
from learnblock.errors import RobotConnectionError
from learnblock.perception.frames import Frame
from learnblock.perception.sources.frames import frame_of
from learnblock.timing import MONOTONIC, SteadyClock

#: The size we request; a webcam may send a different one.
SIZE = (640, 480)
#: Seconds to wait for the first picture: some webcams are slow to start.
TIMEOUT = 10.0


class Webcam(Closing):
    """The newest picture of a webcam, which is turned on when the first picture is read.

    Args:
        source: its number, 0 for the first webcam, or another source that OpenCV can open.
        timeout: how long to wait for the first picture, in seconds.
        clock: the clock of this limit.
    """

    def __init__(
        self, source: int | str, timeout: float = TIMEOUT, clock: SteadyClock = MONOTONIC
    ) -> None:
        self._source = source
        self._clock = clock
        self._timeout = timeout
        self._turn = threading.Lock()
        self._thread: threading.Thread | None = None
        self._closed = threading.Event()
        #: Set once there is a picture, or once it is clear that there will be none.
        self._settled = threading.Event()
        self._newest: cv2.typing.MatLike | None = None
        self._shown: cv2.typing.MatLike | None = None
        self._frame: Frame | None = None
        #: The code of the phrase about why there are no pictures.
        self._trouble = ""

    def read(self) -> Frame | None:
        """The newest picture; the same object as long as there is no newer one.

        Raises:
            RobotConnectionError: there is no such webcam, or it sends no pictures.
        """
        with self._turn:
            self._switch_on()
            if not self._clock.wait(self._settled, self._timeout):
                raise RobotConnectionError("perception-webcam-silent", webcam=str(self._source))
            if self._trouble:
                raise RobotConnectionError(self._trouble, webcam=str(self._source))
            newest = self._newest
            if newest is not None and newest is not self._shown:
                self._frame, self._shown = frame_of(newest), newest
            return self._frame

    def close(self) -> None:
        """Turn it off; calling it twice is harmless."""
        self._closed.set()
        self._settled.set()
        if self._thread:
            # A hanging driver must not prevent the robot from being stopped.
            self._thread.join(timeout=1)

    def _switch_on(self) -> None:
        if self._thread is None and not self._closed.is_set():
            self._thread = threading.Thread(target=self._watch, name="webcam", daemon=True)
            self._thread.start()

    def _watch(self) -> None:
        with ExitStack() as ending:
            ending.callback(self._settled.set)
            capture = cv2.VideoCapture(self._source)
            ending.callback(capture.release)
            if not capture.isOpened():
                self._trouble = "perception-webcam-closed"
                return
            for name, value in zip(
                (cv2.CAP_PROP_FRAME_WIDTH, cv2.CAP_PROP_FRAME_HEIGHT, cv2.CAP_PROP_BUFFERSIZE),
                (*SIZE, 1),
                strict=True,
            ):
                # A webcam without this setting keeps its own.
                capture.set(name, value)
            self._watch_pictures(capture)

    def _watch_pictures(self, capture: cv2.VideoCapture) -> None:
        while not self._closed.is_set():
            is_read, picture = capture.read()
            if not is_read:
                never = self._newest is None
                lost = "perception-webcam-lost"
                self._trouble = "perception-webcam-without-pictures" if never else lost
                return
            self._newest = picture
            self._settled.set()
