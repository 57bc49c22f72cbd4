import subprocess
import sys

import numpy as np
import pytest

from learnblock import perception
from learnblock.errors import FrameError, UnknownNameError
from learnblock.perception import DETECTORS, detect
from learnblock.perception.detectors.lines import detect_lines
from learnblock.simulator.textures import face, tag


def frame_with_everything():
    frame = np.full((240, 320, 3), 200, np.uint8)
    frame[40:120, 20:100] = tag(8)
    frame[40:160, 150:270] = face("joy", 120)
    frame[200:215] = (200, 20, 20)
    return frame


def test_importing_perception_loads_neither_opencv_nor_numpy():
    program = (
        "import sys, learnblock.perception, learnblock.perception.detections;"
        "print(sorted({'cv2', 'numpy'} & set(sys.modules)))"
    )
    done = subprocess.run(
        [sys.executable, "-c", program], capture_output=True, text=True, check=True
    )
    assert done.stdout.strip() == "[]"


def test_the_detectors_are_known_by_name():
    assert sorted(DETECTORS) == ["emotions", "faces", "lines", "objects", "tags"]


def test_detect_runs_the_detector_with_that_name():
    frame = frame_with_everything()
    assert [found.id for found in detect("tags", frame)] == [8]
    assert len(detect("faces", frame)) == 1
    assert detect_lines(frame).black.is_there
    # The tag and the face are no lines.
    assert not detect("lines", frame).black.is_there


def test_a_misspelt_detector_gets_a_suggestion():
    with pytest.raises(UnknownNameError, match="Did you mean 'faces'"):
        detect("face", frame_with_everything())


@pytest.mark.parametrize("name", DETECTORS)
def test_every_detector_refuses_anything_but_a_picture(name):
    with pytest.raises(FrameError, match="uint8"):
        detect(name, np.zeros((240, 320, 3)))


@pytest.mark.parametrize("name", DETECTORS)
@pytest.mark.parametrize("size", [(1, 1), (2, 400), (400, 1), (30, 31)])
def test_every_detector_accepts_frames_of_any_size(name, size):
    noise = np.random.default_rng(1).integers(0, 256, (*size, 3)).astype(np.uint8)
    assert detect(name, noise) == detect(name, noise[::-1][::-1])


@pytest.mark.parametrize("name", DETECTORS)
def test_the_same_frame_gives_the_same_detections(name):
    frame = frame_with_everything()
    assert detect(name, frame) == detect(name, frame.copy())


def test_all_public_names_exist_and_are_sorted():
    assert sorted(perception.__all__) == sorted(set(perception.__all__))
    assert all(hasattr(perception, name) for name in perception.__all__)
