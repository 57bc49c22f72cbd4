"""Detection in camera pictures: once per picture, on demand, and emotions only if allowed."""

import numpy as np
import pytest

from learnblock.devices import Camera
from learnblock.errors import SettingsError
from learnblock.perception import sight
from learnblock.perception.sources import TABLE, Vision
from learnblock.simulator.textures import face
from learnblock.storage.settings import file

PLAIN = np.full((240, 320, 3), 200, np.uint8)
SMILING = PLAIN.copy()
SMILING[40:200, 80:240] = face("joy", 160)[:, :, :3]


@pytest.fixture
def searched(monkeypatch):
    """The names of the detectors that were used."""
    names = []
    detect = sight._BuiltIn.detect

    def noted(detector, frame):
        names.append(detector.name)
        return detect(detector, frame)

    monkeypatch.setattr(sight._BuiltIn, "detect", noted)
    return names


def test_a_picture_is_searched_once_for_each_kind_of_object(searched):
    # The same object, or another one with the same picture.
    frames = [PLAIN, PLAIN, PLAIN.copy(), SMILING]
    vision = Vision(lambda: frames.pop(0), drawn=True)
    for name in ("tags", "tags", "lines", "tags"):
        vision.detect(name)
    assert searched == ["tags", "lines", "tags"]


@pytest.mark.parametrize("place", [(0, 0, 0), (0, 0, 1), (120, 7, 2), (239, 319, 2)])
def test_a_picture_that_differs_in_one_value_is_searched_again(searched, place):
    other = PLAIN.copy()
    other[place] += 1
    frames = [PLAIN, other]
    vision = Vision(lambda: frames.pop(0), drawn=True)

    assert vision.detect("tags") == vision.detect("tags")
    assert searched == ["tags", "tags"]


def test_detectors_run_only_on_request(searched):
    Vision(lambda: PLAIN, drawn=True)
    assert searched == []


def test_faces_are_found_once_for_faces_and_emotions(searched):
    vision = Vision(lambda: SMILING, drawn=True)
    (seen,) = vision.detect("faces")
    (felt,) = vision.detect("emotions")
    assert felt.face == seen
    assert sorted(searched) == ["emotions", "faces"]


def test_without_a_picture_nothing_is_detected():
    assert Vision(lambda: None, drawn=True).detect("tags") is None


def test_there_are_no_other_detectors_than_ours():
    assert Vision(lambda: PLAIN, drawn=True).detect("unicorns") is None


def test_emotions_are_recognised_if_faces_are_drawn():
    assert Camera(lambda: SMILING, drawn=True).detect("emotions")


def test_emotions_are_not_recognised_on_a_real_camera_but_faces_are():
    assert Camera(lambda: SMILING).detect("emotions") is None
    assert Camera(lambda: SMILING).detect("faces")


def test_emotions_are_recognised_on_a_real_camera_if_turned_on():
    TABLE.change("emotions_on_cameras", "true")
    assert Camera(lambda: SMILING).detect("emotions")


def test_no_picture_is_taken_if_the_settings_forbid_it():
    taken = []
    assert Camera(lambda: taken.append(1)).detect("emotions") is None
    assert taken == []


def test_invalid_settings_are_reported_with_their_line():
    file().write_text("[perception]\nemotions_on_cameras = 1\n")
    with pytest.raises(SettingsError, match=r"'perception\.emotions_on_cameras' is 1") as caught:
        Camera(lambda: SMILING).detect("emotions")
    assert caught.value.diagnostics[0].line == 2
