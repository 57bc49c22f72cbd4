"""A recorded video as a camera: the picture at the robot's time, the same in every run."""

import numpy as np
import pytest

from learnblock.errors import RobotConnectionError
from learnblock.i18n import Phrase
from learnblock.perception.sources.recording import Recording
from learnblock.testing import VirtualClock
from videos import number_of, record, shades


@pytest.fixture
def clock():
    return VirtualClock()


@pytest.fixture
def recording(tmp_path, clock):
    """Five pictures, ten a second."""
    with Recording(record(tmp_path / "shades.avi", shades(5)), clock.time) as recording:
        yield recording


def seen_at(recording, clock, *times):
    """Return the numbers of the pictures at these times in s, which never decrease."""
    numbers = []
    for time in times:
        clock.sleep(time - clock.time())
        numbers.append(number_of(recording.read()))
    return numbers


def test_it_shows_the_picture_of_the_robots_time(recording, clock):
    assert seen_at(recording, clock, 0, 0.05, 0.11, 0.31, 0.42) == [0, 0, 1, 3, 4]


def test_it_repeats_after_its_end(recording, clock):
    assert seen_at(recording, clock, 0.42, 0.51, 0.75, 1.01, 7.31) == [4, 0, 2, 0, 3]


def test_a_late_start_shows_the_same_pictures(recording, clock):
    assert seen_at(recording, clock, 12.31) == [3]


def test_it_shows_the_same_picture_as_the_same_object(recording, clock):
    first = recording.read()
    clock.sleep(0.05)
    assert recording.read() is first
    clock.sleep(0.1)
    assert recording.read() is not first


def test_its_pictures_are_rgb_and_cannot_be_written_to(tmp_path, clock):
    red = np.zeros((48, 64, 3), np.uint8)
    red[:, :, 0] = 200
    with Recording(record(tmp_path / "red.avi", [red]), clock.time) as recording:
        frame = recording.read()
    assert (frame.dtype, frame.shape) == (np.uint8, (48, 64, 3))
    assert frame.mean(axis=(0, 1)) == pytest.approx([200, 0, 0], abs=5)
    assert not frame.flags.writeable


def test_large_pictures_are_scaled_down(tmp_path, clock):
    path = record(tmp_path / "large.avi", shades(1, height=720, width=1280))
    with Recording(path, clock.time) as recording:
        assert recording.read().shape == (360, 640, 3)


def test_it_is_opened_again_after_it_was_closed(recording, clock):
    assert seen_at(recording, clock, 0.11) == [1]
    recording.close()
    recording.close()
    assert seen_at(recording, clock, 0.21) == [2]


@pytest.mark.parametrize(
    ("name", "content", "code"),
    [
        ("none.avi", None, "perception-video-missing"),
        ("img_%02d.png", None, "perception-video-missing"),
        ("text.avi", b"these are no pictures", "perception-video-unreadable"),
        ("empty.avi", b"", "perception-video-unreadable"),
    ],
)
def test_a_file_without_pictures_is_reported(tmp_path, clock, name, content, code):
    if content is not None:
        (tmp_path / name).write_bytes(content)
    with Recording(tmp_path / name, clock.time) as recording:
        # At every attempt.
        for _ in range(2):
            with pytest.raises(RobotConnectionError) as refused:
                recording.read()
            assert refused.value.phrase == Phrase(code, path=str(tmp_path / name))


def test_a_truncated_file_is_shown_up_to_the_truncation(tmp_path, clock):
    # With noise, so that each picture needs some space in the file.
    noise = np.random.default_rng(1).integers(0, 10, (240, 320, 3), np.uint8)
    frames = [frame + noise for frame in shades(5, height=240, width=320)]
    path = record(tmp_path / "cut.avi", frames)
    path.write_bytes(path.read_bytes()[: path.stat().st_size * 4 // 5])
    with Recording(path, clock.time) as recording:
        numbers = seen_at(recording, clock, *np.arange(0.01, 2, 0.1))
    length = max(numbers) + 1
    assert 1 < length < 5
    assert numbers == [number % length for number in range(20)]
