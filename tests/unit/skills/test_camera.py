from dataclasses import replace

import numpy as np
import pytest

from learnblock.devices import Camera
from learnblock.errors import UnknownNameError
from learnblock.perception import Lines, LineView, Tag, TagPose

NOTHING = {"left": 0, "center": 0, "right": 0}


def lines(**seen: dict[str, int]) -> Lines:
    views = {colour: LineView(colour, **NOTHING | seen.get(colour, {})) for colour in COLOURS}
    return Lines(**views)


def tag(number: int, column: float, width: int = 320) -> Tag:
    return Tag(number, (column, 120), ((0, 0),) * 4, frame_width=width, frame_height=width * 3 // 4)


COLOURS = ("black", "red", "blue")
SIDES = ("left", "center", "right")


@pytest.mark.parametrize("colour", COLOURS)
@pytest.mark.parametrize("side", SIDES)
def test_a_line_is_where_most_of_its_colour_is(robot, colour, side):
    robot.set_detections("lines", lines(**{colour: {"left": 30, "right": 30, side: 50}}))

    seen = [
        (one, where)
        for one in COLOURS
        for where in (*SIDES, "there")
        if getattr(robot, f"is_{where}_{one}_line")()
    ]
    assert [(colour, side), (colour, "there")] == seen


def test_a_few_pixels_are_not_a_line(robot):
    robot.set_detections("lines", lines(red={"center": 20}))

    assert not robot.is_there_red_line()
    assert not robot.is_center_red_line()


def test_a_crossing_is_red_and_black_in_the_center(robot):
    robot.set_detections("lines", lines(red={"center": 41}, black={"center": 41}))
    assert robot.is_line_crossing()

    robot.set_detections("lines", lines(red={"center": 41}, black={"center": 40}))
    assert not robot.is_line_crossing()


def test_a_tag_number_may_be_a_number_or_a_string(robot):
    robot.set_detections("tags", (tag(8, 160),))

    assert [True] * 4 == [robot.is_tag(), robot.is_tag(8), robot.is_tag(8.0), robot.is_tag("8")]
    assert robot.is_image(8)
    assert not robot.is_image()
    assert not robot.is_tag(1)


def test_a_tag_can_be_given_by_its_name(robot, tmp_path, monkeypatch):
    monkeypatch.setenv("LEARNBLOCK_HOME", str(tmp_path))
    (tmp_path / "tags.toml").write_text("ball = 3\n")
    robot.set_detections("tags", (tag(3, 160),))

    assert robot.is_tag("ball")
    assert robot.is_image("ball")
    assert robot.tag_on_the_center("ball")


def test_an_unknown_tag_name_is_refused(robot, tmp_path, monkeypatch):
    monkeypatch.setenv("LEARNBLOCK_HOME", str(tmp_path))

    with pytest.raises(UnknownNameError, match="There is no tag 'ball'"):
        robot.is_tag("ball")


@pytest.mark.parametrize(
    ("column", "width", "where"),
    [
        (100, 320, "left"),
        (130, 320, "center"),
        (190, 320, "center"),
        (220, 320, "right"),
        (250, 640, "center"),
        (400, 640, "right"),
    ],
)
def test_a_tag_is_left_or_right_beyond_forty_pixels_from_the_middle(robot, column, width, where):
    robot.set_detections("tags", (tag(1, column, width),))

    assert [where] == [one for one in SIDES if getattr(robot, f"tag_on_the_{one}")()]
    assert [where] == [one for one in SIDES if getattr(robot, f"tag_on_the_{one}")(idTag=1)]
    assert [] == [one for one in SIDES if getattr(robot, f"tag_on_the_{one}")(2)]


def test_without_a_number_the_first_tag_seen_is_used(robot):
    robot.set_detections("tags", (tag(1, 10), tag(2, 300)))

    assert robot.tag_on_the_left()
    assert not robot.tag_on_the_right()
    assert robot.tag_on_the_right(2)


def test_a_tag_is_as_far_away_as_its_pose_says(robot):
    placed = replace(tag(3, 160), pose=TagPose(30, 0, 400, 0, 0, 0))
    robot.set_detections("tags", (tag(1, 10), placed))

    assert pytest.approx(401, abs=1) == robot.get_tag_distance(3)
    assert [None, None] == [robot.get_tag_distance(), robot.get_tag_distance(7)]


def test_any_tag_is_enough(robot):
    assert not robot.is_any_tag()
    robot.set_detections("tags", (tag(99, 10),))

    assert robot.is_any_tag()


@pytest.mark.parametrize("detector", ["lines", "tags", "objects", "faces", "emotions"])
def test_a_detector_that_is_not_installed_sees_nothing(robot, detector):
    robot.set_detections(detector, None)
    questions = (
        robot.is_there_red_line,
        robot.is_line_crossing,
        robot.is_any_tag,
        robot.tag_on_the_left,
        robot.is_there_object,
        robot.is_there_face,
        robot.is_any_face_sad,
    )

    assert [False] * len(questions) == [question() for question in questions]


def test_the_image_is_the_camera_s_frame(robot):
    frame = np.zeros((240, 320, 3), np.uint8)
    robot.set_reading(Camera, frame)

    assert frame is robot.get_image()
