import msgspec
import pytest
from hypothesis import given
from hypothesis import strategies as st

from learnblock.perception.detections import (
    KINDS,
    ColouredObject,
    Face,
    FaceEmotion,
    Lines,
    LineView,
    Tag,
    TagPose,
)

counts = st.integers(0, 30_000)
sizes = st.sampled_from([(160, 120), (320, 240), (640, 480), (1280, 720)])
numbers = st.floats(-1e4, 1e4)
points = st.tuples(numbers, numbers)


def tag_at(column, width=320, height=240):
    corner = (column, height / 2)
    return Tag(8, corner, (corner, corner, corner, corner), None, width, height)


@st.composite
def line_views(draw, colour="black"):
    return LineView(colour, draw(counts), draw(counts), draw(counts), *draw(sizes))


@st.composite
def tags(draw):
    corners = draw(st.tuples(points, points, points, points))
    pose = draw(st.none() | st.builds(TagPose, *[numbers] * 6))
    return Tag(draw(st.integers(0, 586)), draw(points), corners, pose, *draw(sizes))


@st.composite
def faces(draw):
    return Face(*(draw(st.integers(0, 1280)) for _ in range(4)), *draw(sizes))


@st.composite
def objects(draw):
    measures = (draw(counts) for _ in range(5))
    return ColouredObject("green", draw(points), *measures, *draw(sizes))


def emotions():
    return st.builds(FaceEmotion, faces(), st.just("joy"), st.floats(0, 1))


@given(st.lists(objects()).map(tuple), st.lists(emotions()).map(tuple))
def test_objects_and_emotions_survive_a_journey_between_processes(seen, felt):
    for name, found in (("objects", seen), ("emotions", felt)):
        encoded = msgspec.msgpack.encode(found)
        assert found == msgspec.convert(msgspec.msgpack.decode(encoded), KINDS[name])


@given(st.lists(tags()).map(tuple))
def test_tags_survive_a_journey_between_processes(found):
    assert found == msgspec.msgpack.decode(msgspec.msgpack.encode(found), type=tuple[Tag, ...])


@given(st.lists(faces()).map(tuple))
def test_faces_survive_a_journey_between_processes(found):
    assert found == msgspec.json.decode(msgspec.json.encode(found), type=tuple[Face, ...])


@given(st.builds(Lines, line_views(), line_views("red"), line_views("blue")))
def test_lines_survive_a_journey_between_processes(found):
    assert found == msgspec.msgpack.decode(msgspec.msgpack.encode(found), type=Lines)


@given(line_views())
def test_a_line_is_on_exactly_one_side(view):
    assert view.is_there == ([view.is_left, view.is_center, view.is_right].count(True) == 1)


@given(counts, counts, counts)
def test_a_frame_twice_as_wide_and_high_gives_the_same_answers(left, center, right):
    small = LineView("red", left, center, right, 320, 240)
    large = LineView("red", 4 * left, 4 * center, 4 * right, 640, 480)
    for question in ("is_left", "is_center", "is_right", "is_there"):
        assert getattr(small, question) == getattr(large, question)


@pytest.mark.parametrize(("pixels", "expected"), [(20, False), (21, True)])
def test_a_line_needs_more_than_twenty_pixels(pixels, expected):
    assert expected == LineView("black", 0, pixels, 0).is_center
    assert expected == LineView("black", 0, pixels, 0).is_there


def test_the_side_with_the_most_pixels_has_the_line():
    view = LineView("blue", 500, 400, 600)
    assert [view.is_left, view.is_center, view.is_right] == [False, False, True]


def test_if_sides_are_equal_the_line_is_in_the_center():
    assert LineView("black", 500, 500, 500).is_center


@pytest.mark.parametrize("scale", [1, 2])
@pytest.mark.parametrize(
    ("red", "black", "expected"), [(41, 41, True), (40, 41, False), (41, 40, False)]
)
def test_a_crossing_is_more_than_forty_red_and_forty_black_pixels_in_the_center(
    red, black, expected, scale
):
    size = 320 * scale, 240 * scale
    lines = Lines(
        black=LineView("black", 9, black * scale**2, 9, *size),
        red=LineView("red", 9, red * scale**2, 9, *size),
        blue=LineView("blue", 0, 0, 0),
    )
    assert expected == lines.is_crossing


@pytest.mark.parametrize(
    ("column", "expected"),
    [
        (118, ["left"]),
        (120, ["center"]),
        (159.5, ["center"]),
        (199, ["center"]),
        (201, ["right"]),
    ],
)
@pytest.mark.parametrize("scale", [0.5, 1, 2])
def test_a_tag_is_in_the_center_within_forty_pixels_of_the_middle(column, expected, scale):
    middle = 0.5 * (320 * scale - 1)
    tag = tag_at(middle + (column - 159.5) * scale, round(320 * scale), round(240 * scale))
    sides = {"left": tag.is_left, "center": tag.is_center, "right": tag.is_right}
    assert expected == [side for side, is_there in sides.items() if is_there]


@pytest.mark.parametrize("scale", [1, 2])
@pytest.mark.parametrize(
    ("column", "row", "expected"),
    [
        (0, 0, {"is_left", "is_up"}),
        (1, 0, {"is_up"}),
        (2, 0, {"is_right", "is_up"}),
        (0, 1, {"is_left"}),
        (1, 1, {"is_center"}),
        (2, 2, {"is_right", "is_down"}),
    ],
)
def test_a_face_is_in_the_cell_of_three_by_three_that_its_center_is_in(
    column, row, expected, scale
):
    x, y = round(320 * (column + 0.5) / 3), 240 * (row + 0.5) / 3
    face = Face(scale * (x - 20), int(scale * (y - 20)), 40 * scale, 40 * scale, 320 * scale,
                240 * scale)  # fmt: skip
    questions = {"is_left", "is_right", "is_up", "is_down", "is_center"}
    assert expected == {question for question in questions if getattr(face, question)}


def test_a_face_that_reaches_over_the_frame_s_edge_is_still_in_a_cell():
    face = Face(300, 220, 60, 60)
    assert face.is_right
    assert face.is_down
