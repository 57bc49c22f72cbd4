"""A recorded video as a camera: the picture of the robot's time, the same in every run."""

import numpy as np
import pytest

from learnblock.errors import RobotConnectionError
from learnblock.testing import VirtualClock
from learnblock.vision.recording import Recording
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
    """The numbers of the pictures at those times, s, which never go back."""
    numbers = []
    for time in times:
        clock.sleep(time - clock.time())
        numbers.append(number_of(recording.read()))
    return numbers


def test_it_shows_the_picture_of_the_robots_time(recording, clock):
    assert seen_at(recording, clock, 0, 0.05, 0.11, 0.31, 0.42) == [0, 0, 1, 3, 4]


def test_behind_its_end_it_begins_again(recording, clock):
    assert seen_at(recording, clock, 0.42, 0.51, 0.75, 1.01, 7.31) == [4, 0, 2, 0, 3]


def test_who_begins_late_sees_what_all_others_see(recording, clock):
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


def test_large_pictures_are_made_smaller(tmp_path, clock):
    path = record(tmp_path / "large.avi", shades(1, height=720, width=1280))
    with Recording(path, clock.time) as recording:
        assert recording.read().shape == (360, 640, 3)


def test_it_is_opened_again_after_it_was_closed(recording, clock):
    assert seen_at(recording, clock, 0.11) == [1]
    recording.close()
    recording.close()
    assert seen_at(recording, clock, 0.21) == [2]


@pytest.mark.parametrize(
    ("name", "content", "trouble"),
    [
        ("none.avi", None, "there is no such file"),
        ("img_%02d.png", None, "there is no such file"),
        ("text.avi", b"these are no pictures", "it holds no pictures"),
        ("empty.avi", b"", "it holds no pictures"),
    ],
)
def test_a_file_that_shows_nothing_is_told(tmp_path, clock, name, content, trouble):
    if content is not None:
        (tmp_path / name).write_bytes(content)
    sentence = rf"the video .*{name} cannot be seen: {trouble}.*; `learnblock perception set video"
    with Recording(tmp_path / name, clock.time) as recording:
        with pytest.raises(RobotConnectionError, match=sentence):
            recording.read()
        # As often as it is asked.
        with pytest.raises(RobotConnectionError, match=sentence):
            recording.read()


def test_a_file_that_was_cut_short_is_seen_as_far_as_it_goes(tmp_path, clock):
    # With noise, so that each picture takes some room in the file.
    noise = np.random.default_rng(1).integers(0, 10, (240, 320, 3), np.uint8)
    frames = [frame + noise for frame in shades(5, height=240, width=320)]
    path = record(tmp_path / "cut.avi", frames)
    path.write_bytes(path.read_bytes()[: path.stat().st_size * 4 // 5])
    with Recording(path, clock.time) as recording:
        numbers = seen_at(recording, clock, *np.arange(0.01, 2, 0.1))
    length = max(numbers) + 1
    assert 1 < length < 5
    assert numbers == [number % length for number in range(20)]
