from pathlib import Path

import cv2
import numpy as np
import pytest

from learnblock.perception import Sight, detect, emotions
from learnblock.perception.emotions import WeightsMissingError, detect_emotions, emotions_of
from learnblock.simulator.textures import EMOTIONS, face

# Nothing was tuned on the people from 1000 on.
HELD_OUT = range(1000, 1060)


@pytest.mark.parametrize("focal", [290, 480])
def test_17_of_20_faces_of_people_never_seen_before_are_read_rightly(photograph, focal):
    generator = np.random.default_rng(focal)
    nearest = max(250, 200 * focal / 230)
    found = right = 0
    for view in range(70):
        emotion = EMOTIONS[view % len(EMOTIONS)]
        frame = photograph(
            face(emotion, 400, HELD_OUT[view // 7]),
            200,
            distance=generator.uniform(nearest, 700),
            angle=generator.uniform(-20, 20),
            focal=focal,
            generator=generator,
        )
        told = [one.emotion for one in detect_emotions(frame)]
        found += len(told) == 1
        right += told == [emotion]
    assert found >= 0.95 * 70
    assert right >= 0.85 * found


def test_a_photograph_of_a_smiling_woman_is_happy():
    data = pytest.importorskip("skimage.data")
    (told,) = detect_emotions(data.astronaut())
    assert told.emotion == "joy"
    assert told.confidence > 0.9


def frame_with(emotion):
    frame = np.full((240, 320, 3), 190, np.uint8)
    frame[40:200, 80:240] = face(emotion, 160)
    return frame


@pytest.mark.parametrize("emotion", EMOTIONS)
def test_the_usual_posters_are_read_rightly(emotion):
    (told,) = detect("emotions", frame_with(emotion))
    assert told.emotion == emotion
    assert 0.3 < told.confidence <= 1


def test_an_emotion_tells_whose_face_it_is():
    frame = frame_with("joy")
    assert detect("faces", frame) == tuple(one.face for one in detect("emotions", frame))


def test_faces_that_were_found_already_are_not_looked_for_again(monkeypatch):
    looked = []
    monkeypatch.setattr(
        "learnblock.perception.faces.detect_faces", lambda frame: looked.append(frame) or ()
    )
    sight = Sight(frame_with("joy"))
    assert (sight.detect("emotions"), sight.detect("faces"), len(looked)) == ((), (), 1)


def test_without_a_face_nothing_is_told():
    assert detect_emotions(np.full((240, 320, 3), 190, np.uint8)) == ()


def test_missing_weights_are_told_in_one_sentence_with_what_to_do(monkeypatch):
    emotions._net.cache_clear()
    monkeypatch.setattr(emotions, "WEIGHTS", Path("nowhere") / "emotions.onnx")
    with pytest.raises(WeightsMissingError, match=r"install LearnBlock again"):
        detect_emotions(frame_with("joy"))
    emotions._net.cache_clear()


def test_missing_weights_concern_nobody_where_there_is_no_face(monkeypatch):
    emotions._net.cache_clear()
    monkeypatch.setattr(emotions, "WEIGHTS", Path("nowhere") / "emotions.onnx")
    assert emotions_of(np.zeros((240, 320, 3), np.uint8), ()) == ()


def test_the_same_face_is_read_alike_in_a_larger_frame():
    frame = cv2.resize(frame_with("surprise"), (640, 480))
    (told,) = detect_emotions(frame)
    assert (told.emotion, told.face.frame_width) == ("surprise", 640)
