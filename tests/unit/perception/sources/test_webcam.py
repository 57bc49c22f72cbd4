"""The computer's webcam, replaced by a video file or by a camera that a test controls."""

import queue
import threading

import cv2
import numpy as np
import pytest

from learnblock.errors import RobotConnectionError
from learnblock.i18n import Phrase
from learnblock.perception.sources.webcam import Webcam
from videos import record, shades
from waiting import SECONDS

pytestmark = pytest.mark.realtime


class Held:
    """A camera whose pictures arrive when a test delivers them."""

    def __init__(self):
        self.chosen = {}
        self.released = False
        self._pictures = queue.Queue()
        self._reads = 0
        self._shown = 0
        self._read_again = threading.Condition()

    def show(self, picture):
        """Deliver a picture."""
        self._shown += 1
        self._pictures.put(picture)

    def wait(self):
        """Wait until all pictures are taken and the next one is awaited."""
        with self._read_again:
            assert self._read_again.wait_for(lambda: self._reads > self._shown, timeout=SECONDS)

    def isOpened(self):  # noqa: N802 - OpenCV's name
        return True

    def set(self, name, value):
        self.chosen[name] = value
        return False

    def read(self):
        with self._read_again:
            self._reads += 1
            self._read_again.notify_all()
        picture = self._pictures.get()
        return picture is not None, picture

    def release(self):
        self.released = True


@pytest.fixture
def held(monkeypatch):
    camera = Held()
    monkeypatch.setattr(cv2, "VideoCapture", lambda source: camera)
    yield camera
    # A thread that still waits for a picture gets none.
    camera.show(None)


def bgr(blue, green, red):
    return np.full((480, 640, 3), (blue, green, red), np.uint8)


def test_a_webcam_is_off_until_its_first_picture_is_read(held):
    with Webcam(0):
        assert held.chosen == {}


def test_the_newest_picture_is_seen_once_it_has_arrived(held):
    with Webcam(0) as webcam:
        held.show(bgr(1, 2, 3))
        first = webcam.read()
        assert first[0, 0].tolist() == [3, 2, 1]
        assert webcam.read() is first
        held.show(bgr(4, 5, 6))
        held.show(bgr(7, 8, 9))
        held.wait()
        assert webcam.read()[0, 0].tolist() == [9, 8, 7]
        held.show(None)
    assert held.chosen[cv2.CAP_PROP_FRAME_WIDTH] == 640


def refusal(webcam):
    with pytest.raises(RobotConnectionError) as refused:
        webcam.read()
    return refused.value.phrase


def test_a_webcam_that_sends_nothing_is_reported(held):
    with Webcam(0, timeout=0.05) as webcam:
        assert refusal(webcam) == Phrase("perception-webcam-silent", webcam="0")
        # The thread that waits for a picture ends.
        held.show(None)


def test_a_webcam_that_was_unplugged_is_reported(held):
    with Webcam(0) as webcam:
        held.show(bgr(1, 2, 3))
        webcam.read()
        held.show(None)
        webcam._thread.join(5)
        for _ in range(2):
            assert refusal(webcam) == Phrase("perception-webcam-lost", webcam="0")


def test_a_webcam_that_never_sent_a_picture_is_reported(held):
    held.show(None)
    with Webcam(0) as webcam:
        assert refusal(webcam) == Phrase("perception-webcam-without-pictures", webcam="0")


def test_pictures_come_through_opencv_itself(tmp_path):
    path = record(tmp_path / "long.avi", shades(2, height=240, width=320) * 300)
    with Webcam(str(path)) as webcam:
        assert webcam.read().shape == (240, 320, 3)


def test_a_missing_webcam_is_reported(held):
    held.isOpened = lambda: False
    with Webcam(7) as webcam:
        assert refusal(webcam) == Phrase("perception-webcam-closed", webcam="7")


def test_it_is_switched_off_with_its_robot(held):
    webcam = Webcam(0)
    held.show(bgr(1, 2, 3))
    webcam.read()
    held.show(bgr(4, 5, 6))
    webcam.close()
    webcam.close()
    held.show(None)
    webcam._thread.join(5)
    assert held.released
