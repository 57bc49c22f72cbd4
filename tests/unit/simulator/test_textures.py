from itertools import combinations

import numpy as np
import pytest

from learnblock.errors import TagNumberError, UnknownNameError
from learnblock.i18n import Phrase
from learnblock.perception.detectors.faces import detect_faces
from learnblock.perception.detectors.tags import detect_tags
from learnblock.simulator.textures import EMOTIONS, FloorLine, face, floor, tag

WHITE = (255, 255, 255)


def on_grey(picture, height=240, width=320):
    frame = np.full((height, width, 3), 180, np.uint8)
    frame[20 : 20 + picture.shape[0], 60 : 60 + picture.shape[1]] = picture
    return frame


@pytest.mark.parametrize("number", [0, 1, 8, 99, 300, 586])
def test_a_tag_is_read_as_its_number(number):
    assert [number] == [found.id for found in detect_tags(on_grey(tag(number)))]


def test_a_tag_is_upright_by_its_named_corners():
    top_left, top_right, _, bottom_left = detect_tags(on_grey(tag(5, 100)))[0].corners
    assert pytest.approx(top_left, abs=1.5) == (70, 30)
    assert pytest.approx(top_right, abs=1.5) == (150, 30)
    assert pytest.approx(bottom_left, abs=1.5) == (70, 110)


@pytest.mark.parametrize("pixels", [10, 80, 95, 200])
def test_a_tag_has_the_requested_size_and_a_white_quiet_zone_of_a_tenth(pixels):
    picture = tag(3, pixels)
    zone = pixels // 10
    assert (pixels, pixels, 3) == picture.shape
    assert (picture[:zone] == 255).all()
    assert (picture[:, -zone:] == 255).all()
    assert tuple(picture[zone + 1 if pixels > 10 else 1, pixels // 2].tolist()) == (0, 0, 0)


@pytest.mark.parametrize("number", [-1, 587])
def test_a_tag_number_beyond_the_family_is_refused(number):
    with pytest.raises(TagNumberError) as refused:
        tag(number)
    assert refused.value.phrase == Phrase("world-no-tag", number=str(number), last="586")


def test_a_tag_too_small_to_read_is_refused():
    with pytest.raises(ValueError, match="at least 10"):
        tag(1, 9)


@pytest.mark.parametrize("emotion", EMOTIONS)
def test_a_face_of_each_emotion_is_found_as_one_face(emotion):
    assert len(detect_faces(on_grey(face(emotion)))) == 1


def test_the_faces_of_any_two_emotions_differ():
    pictures = [face(emotion).astype(int) for emotion in EMOTIONS]
    assert min(np.abs(a - b).max() for a, b in combinations(pictures, 2)) > 60


def test_the_seven_emotions_are_those_of_a_display():
    expected = {"fear", "surprise", "anger", "sadness", "disgust", "joy", "neutral"}
    assert expected == set(EMOTIONS)


@pytest.mark.parametrize("pixels", [1, 50, 600])
def test_a_face_has_the_requested_size(pixels):
    assert ((pixels, pixels, 3), np.uint8) == (face("joy", pixels).shape, face("joy").dtype)


def test_a_misspelt_emotion_gets_a_suggestion():
    with pytest.raises(UnknownNameError, match="Did you mean 'sadness'"):
        face("sadnes")


def test_a_face_without_pixels_is_refused():
    with pytest.raises(ValueError, match="at least 1"):
        face("joy", 0)


def darkness(picture):
    return (255 - picture[..., 0].astype(float)) / 255


def test_a_floor_has_north_in_row_zero_and_east_on_the_right():
    picture = floor((200, 100), WHITE, [FloorLine([(80, 30), (80, 40)], 10)], 2.0)
    rows, columns = np.nonzero(picture[..., 0] < 128)
    assert picture.shape == (200, 400, 3)
    assert (rows.mean(), columns.mean()) == (99.5 - 70, 199.5 + 160)


@pytest.mark.parametrize("width", [2.0, 3.5, 10.0, 20.5])
@pytest.mark.parametrize("angle", [0, 30, 90, 161])
def test_a_line_covers_its_length_times_its_width_and_two_half_discs(width, angle):
    x, y = 80 * np.cos(np.radians(angle)), 80 * np.sin(np.radians(angle))
    picture = floor((200, 200), WHITE, [FloorLine([(-x, -y), (x, y)], width)])
    covered = darkness(picture).sum()
    assert 160 * width + np.pi * (width / 2) ** 2 == pytest.approx(covered, rel=0.02)


def test_an_edge_of_a_line_that_falls_within_a_pixel_is_grey():
    column = floor((20, 20), WHITE, [FloorLine([(-50, 0), (50, 0)], 5)])[:, 10, 0]
    assert column[6:14].tolist() == [255, 128, 0, 0, 0, 0, 128, 255]


def test_joints_of_a_thick_line_are_neither_gapped_nor_painted_twice():
    corner = FloorLine([(-30, -30), (0, 0), (-30, 30)], 8, (100, 100, 100))
    picture = floor((100, 100), WHITE, [corner])
    assert picture.min() == 100
    assert (picture[47:53, 46:51] == 100).all()


def test_a_later_line_is_on_top():
    across = FloorLine([(-50, 0), (50, 0)], 10, (255, 0, 0))
    along = FloorLine([(0, -50), (0, 50)], 10, (0, 0, 255))
    assert tuple(floor((100, 100), WHITE, [across, along])[50, 50].tolist()) == (0, 0, 255)


def test_a_line_beyond_the_floor_is_not_drawn():
    away = [FloorLine([(900, 0), (900, 50)], 10), FloorLine([(-900, 0), (-900, -950)], 10)]
    assert (floor((100, 100), WHITE, away) == 255).all()


def test_a_picture_is_stretched_below_the_lines():
    halves = np.zeros((10, 2, 3), np.uint8)
    halves[:, 1] = 200
    line = FloorLine([(-50, 30), (50, 30)], 10, (255, 0, 0))
    picture = floor((100, 100), WHITE, [line], picture=halves)
    assert picture[80, [5, 95], 0].tolist() == [0, 200]
    assert tuple(picture[20, 50].tolist()) == (255, 0, 0)


def test_drawing_on_a_floor_does_not_change_the_given_picture():
    picture = np.full((100, 100, 3), 200, np.uint8)
    floor((100, 100), WHITE, [FloorLine([(-50, 0), (50, 0)], 10)], picture=picture)
    assert (picture == 200).all()


def test_a_floor_without_pixels_is_refused():
    with pytest.raises(ValueError, match="has no pixels"):
        floor((100, 0.1), WHITE)


@pytest.mark.parametrize(
    ("points", "width", "message"), [([(0, 0)], 10, "two or more"), ([(0, 0), (1, 1)], 0, "above")]
)
def test_a_line_of_one_point_or_no_width_is_refused(points, width, message):
    with pytest.raises(ValueError, match=message):
        FloorLine(points, width)


def test_another_number_is_another_person():
    faces = [face("joy", 100, person) for person in (0, 1, 2, 1000)]
    assert np.array_equal(face("joy", 100), faces[0])
    assert np.array_equal(face("joy", 100, 2), faces[2])
    assert 4 == len({one.tobytes() for one in faces})


def test_a_person_below_zero_is_refused():
    with pytest.raises(ValueError, match="count from 0"):
        face("joy", 100, -1)


def test_lines_change_the_pixels_that_they_touch_as_if_all_were_mixed():
    colour, ground = (20, 90, 200), (240, 239, 9)
    points = [(-50, 3), (60, -20)]
    picture = floor((200, 100), ground, [FloorLine(points, 17, colour)])
    # The same line in black on white shows how much of each pixel it covers, in 255 steps.
    parts = 1 - floor((200, 100), (255,) * 3, [FloorLine(points, 17)])[..., :1] / 255
    mixed = ground + parts * (np.array(colour) - ground)
    assert np.abs(picture - mixed).max() <= 1
    assert (picture[parts[..., 0] == 0] == ground).all()
    assert (picture[parts[..., 0] == 1] == colour).all()
