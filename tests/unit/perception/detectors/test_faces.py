import threading

import numpy as np
import pytest

from gate import examples
from learnblock.errors import FrameError
from learnblock.perception.detectors.faces import detect_faces
from learnblock.simulator.textures import EMOTIONS, face, tag

#: Photographs, as many of each emotion.
VIEWS = examples(70, gate=28)


@pytest.mark.slow
@pytest.mark.parametrize("focal", [290, 480])
def test_19_of_20_posters_of_200_mm_are_found_up_to_700_mm(photograph, focal):
    generator = np.random.default_rng(focal)
    posters = [face(emotion) for emotion in EMOTIONS]
    found = 0
    nearest = max(250, 200 * focal / 230)
    for view in range(VIEWS):
        frame = photograph(
            posters[view % len(posters)],
            200,
            distance=generator.uniform(nearest, 700),
            angle=generator.uniform(-20, 20),
            focal=focal,
            generator=generator,
        )
        found += len(detect_faces(frame)) == 1
    assert found >= 0.95 * VIEWS


@pytest.mark.parametrize(
    ("heading", "pitch", "expected"),
    [(0, 0, "is_center"), (18, 0, "is_left"), (-18, 0, "is_right"), (0, 14, "is_down"),
     (0, -14, "is_up")],
)  # fmt: skip
def test_a_face_is_found_where_it_is(photograph, heading, pitch, expected):
    generator = np.random.default_rng(5)
    frame = photograph(
        face("neutral"),
        200,
        distance=700,
        heading=heading,
        pitch=pitch,
        focal=290,
        generator=generator,
    )
    (found,) = detect_faces(frame)
    assert getattr(found, expected)


def test_a_detection_knows_the_size_of_a_larger_frame(photograph):
    generator = np.random.default_rng(5)
    frame = photograph(face("joy"), 200, distance=600, scale=2, focal=290, generator=generator)
    (found,) = detect_faces(frame)
    assert (found.frame_width, found.frame_height) == (640, 480)


def test_several_faces_come_from_left_to_right():
    frame = np.full((240, 320, 3), 180, np.uint8)
    for left, emotion in ((200, "joy"), (20, "anger")):
        frame[60:160, left : left + 100] = face(emotion, 100)
    first, second = detect_faces(frame)
    assert first.center == pytest.approx((70, 110), abs=15)
    assert second.center == pytest.approx((250, 110), abs=15)


@pytest.mark.parametrize("number", range(0, 500, 50))
def test_a_tag_is_not_a_face(photograph, number):
    generator = np.random.default_rng(number)
    assert detect_faces(photograph(tag(number), 150, distance=500, generator=generator)) == ()


def test_frames_may_be_searched_from_several_threads_at_once():
    frame = np.full((240, 320, 3), 180, np.uint8)
    frame[60:160, 100:200] = face("joy", 100)
    found = []
    threads = [threading.Thread(target=lambda: found.append(detect_faces(frame))) for _ in range(8)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert [detect_faces(frame)] * 8 == found


def test_a_frame_smaller_than_any_face_contains_none():
    assert detect_faces(np.zeros((8, 8, 3), np.uint8)) == ()


def test_anything_but_a_picture_is_refused():
    with pytest.raises(FrameError):
        detect_faces(np.zeros((240, 320), np.uint8))
