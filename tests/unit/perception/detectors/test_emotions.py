from pathlib import Path

import cv2
import numpy as np
import pytest

from gate import examples
from learnblock.errors import WeightsMissingError
from learnblock.perception import Sight, detect
from learnblock.perception.detectors import emotions
from learnblock.perception.detectors.emotions import detect_emotions, emotions_of
from learnblock.simulator.textures import EMOTIONS, face

# Nothing was tuned on the people from 1000 on.
HELD_OUT = range(1000, 1060)
#: Photographs, as many of each emotion.
VIEWS = examples(70, gate=28)


@pytest.mark.slow
@pytest.mark.parametrize("focal", [290, 480])
def test_17_of_20_unknown_faces_are_read_correctly(photograph, focal):
    generator = np.random.default_rng(focal)
    nearest = max(250, 200 * focal / 230)
    found = right = 0
    for view in range(VIEWS):
        emotion = EMOTIONS[view % len(EMOTIONS)]
        frame = photograph(
            face(emotion, 400, HELD_OUT[view // 7]),
            200,
            distance=generator.uniform(nearest, 700),
            angle=generator.uniform(-20, 20),
            focal=focal,
            generator=generator,
        )
        emotions_found = [one.emotion for one in detect_emotions(frame)]
        found += len(emotions_found) == 1
        right += emotions_found == [emotion]
    assert found >= 0.95 * VIEWS
    assert right >= 0.85 * found


def test_a_photograph_of_a_smiling_woman_is_happy():
    data = pytest.importorskip("skimage.data")
    (seen,) = detect_emotions(data.astronaut())
    assert seen.emotion == "joy"
    assert seen.confidence > 0.9


def frame_with(emotion):
    frame = np.full((240, 320, 3), 190, np.uint8)
    frame[40:200, 80:240] = face(emotion, 160)
    return frame


@pytest.mark.parametrize("emotion", EMOTIONS)
def test_the_usual_posters_are_read_correctly(emotion):
    (seen,) = detect("emotions", frame_with(emotion))
    assert seen.emotion == emotion
    assert 0.3 < seen.confidence <= 1


def test_an_emotion_belongs_to_its_face():
    frame = frame_with("joy")
    assert detect("faces", frame) == tuple(one.face for one in detect("emotions", frame))


def test_faces_that_have_been_found_are_not_searched_again(monkeypatch):
    looked = []
    monkeypatch.setattr(
        "learnblock.perception.detectors.faces.detect_faces",
        lambda frame: looked.append(frame) or (),
    )
    sight = Sight(frame_with("joy"))
    assert (sight.detect("emotions"), sight.detect("faces"), len(looked)) == ((), (), 1)


def test_without_a_face_nothing_is_found():
    assert detect_emotions(np.full((240, 320, 3), 190, np.uint8)) == ()


def test_missing_weights_are_reported_with_their_path(monkeypatch):
    emotions._net.cache_clear()
    monkeypatch.setattr(emotions, "WEIGHTS", Path("nowhere") / "emotions.onnx")
    with pytest.raises(WeightsMissingError) as refused:
        detect_emotions(frame_with("joy"))
    path = str(Path("nowhere") / "emotions.onnx")
    phrase = refused.value.phrase
    assert (phrase.code, phrase.values["path"]) == ("perception-no-weights", path)
    emotions._net.cache_clear()


def test_missing_weights_do_not_matter_without_a_face(monkeypatch):
    emotions._net.cache_clear()
    monkeypatch.setattr(emotions, "WEIGHTS", Path("nowhere") / "emotions.onnx")
    assert emotions_of(np.zeros((240, 320, 3), np.uint8), ()) == ()


def test_the_same_face_has_the_same_emotion_in_a_larger_frame():
    frame = cv2.resize(frame_with("surprise"), (640, 480))
    (seen,) = detect_emotions(frame)
    assert (seen.emotion, seen.face.frame_width) == ("surprise", 640)
