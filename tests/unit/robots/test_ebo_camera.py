"""The limit of EBO's camera."""

import pytest

from learnblock.errors import RobotConnectionError
from learnblock.testing import ManualClock

pytest.importorskip("paho.mqtt.client", reason="pip install 'learnblock[ebo]'")


def test_a_camera_counts_as_silent_only_when_its_silence_is_too_long():
    from learnblock.robots.ebo.camera import StreamedCamera

    clock = ManualClock()
    camera = StreamedCamera("127.0.0.1", 1, 2.0, clock)
    clock.advance(2.0)
    camera.check()
    clock.advance(0.001)
    with pytest.raises(RobotConnectionError) as error:
        camera.check()
    assert error.value.phrase.code == "ebo-camera-silent"
