from itertools import pairwise

import cv2
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from learnblock.errors import FrameError
from learnblock.perception.detectors import lines
from learnblock.perception.detectors.lines import detect_lines
from learnblock.perception.sight import DETECTORS, Sight
from learnblock.simulator.camera import CameraModel, CameraPose, Surface, render
from learnblock.simulator.textures import FloorLine, face, floor, tag

BLACK, RED, BLUE = (0, 0, 0), (200, 20, 20), (20, 40, 200)
GROUND = (235, 235, 225)


def frame_with(colour, columns, rows=slice(None), width=320, height=240):
    frame = np.full((height, width, 3), GROUND, np.uint8)
    frame[rows, columns] = colour
    return frame


def seen(lines, heading=0.0, y=0.0, *, scale=1, things=(), tilt=-30):
    """Photograph a floor of 2 by 2 m with a camera 100 mm above it, tilted down by 30 degrees."""
    texture = floor((2000, 2000), GROUND, lines)
    corners = [(-1000, 1000, 0), (1000, 1000, 0), (1000, -1000, 0), (-1000, -1000, 0)]
    ground = Surface(np.array(corners, float), texture)
    noise = (np.random.default_rng(1), 2.0)
    pose = CameraPose(-300, y, 100, heading, tilt)
    return render(
        [*things, ground], CameraModel(320 * scale, 240 * scale, 290 * scale), pose, noise=noise
    )


def standing(texture, size, x, y, bottom=0.0):
    """A picture that stands on the floor at (x, y) and faces the camera in the west."""
    left, right, top = y + size / 2, y - size / 2, bottom + size
    corners = [(x, left, top), (x, right, top), (x, right, bottom), (x, left, bottom)]
    return Surface(np.array(corners, float), texture)


def lying(texture, size, x, y):
    """A picture that lies on the floor around (x, y)."""
    west, east, left, right = x - size / 2, x + size / 2, y + size / 2, y - size / 2
    corners = [(east, left, 1), (east, right, 1), (west, right, 1), (west, left, 1)]
    return Surface(np.array(corners, float), texture)


def sides(view):
    return {side for side in ("left", "center", "right") if getattr(view, f"is_{side}")}


def test_an_empty_floor_has_no_line():
    lines = detect_lines(seen([]))
    assert not any(view.is_there for view in (lines.black, lines.red, lines.blue))


@pytest.mark.parametrize("scale", [0.5, 1, 2])
@pytest.mark.parametrize(
    ("columns", "expected"),
    [
        (slice(0, 120), (120 * 210, 0, 0)),
        (slice(120, 200), (0, 80 * 210, 0)),
        (slice(200, 320), (0, 0, 120 * 210)),
    ],
)
def test_black_is_counted_in_rows_15_to_225_and_in_three_parts(columns, expected, scale):
    scaled = slice(round(columns.start * scale), round(columns.stop * scale))
    frame = frame_with(BLACK, scaled, width=round(320 * scale), height=round(240 * scale))
    view = detect_lines(frame).black
    area = (round(225 * scale) - round(15 * scale)) / 210 * scale
    assert tuple(area * count for count in expected) == (view.left, view.center, view.right)


@pytest.mark.parametrize("rows", [slice(0, 15), slice(225, 240)])
def test_black_above_row_15_and_from_row_225_on_is_ignored(rows):
    assert not detect_lines(frame_with(BLACK, slice(None), rows)).black.is_there


@pytest.mark.parametrize(("grey", "expected"), [(50, True), (51, False)])
def test_grey_up_to_fifty_is_black(grey, expected):
    frame = frame_with((grey, grey, grey), slice(140, 180))
    assert expected == detect_lines(frame).black.is_center


@pytest.mark.parametrize("rgb", [(0, 0, 255), (100, 0, 0), (0, 51, 0)])
def test_a_dark_colour_is_not_black(rgb):
    assert not detect_lines(frame_with(rgb, slice(140, 180))).black.is_there


@pytest.mark.parametrize(
    ("width", "height", "reach"), [(160, 120, 2), (320, 240, 3), (640, 480, 6)]
)
@pytest.mark.parametrize("colour", ["red", "blue"])
def test_a_colour_is_dilated_by_three_pixels_of_a_frame_240_high(colour, width, height, reach):
    middle = width // 2
    rgb = RED if colour == "red" else BLUE
    frame = frame_with(rgb, slice(middle, middle + 4), width=width, height=height)
    rows = round(225 * height / 240) - round(15 * height / 240)
    assert (4 + 2 * reach) * rows == getattr(detect_lines(frame), colour).center


@pytest.mark.parametrize("rgb", [(200, 20, 20), (200, 20, 40), (200, 40, 20), (100, 10, 10)])
def test_reds_at_both_ends_of_the_hue_scale_are_red(rgb):
    lines = detect_lines(frame_with(rgb, slice(140, 180)))
    assert [lines.red.is_center, lines.blue.is_there] == [True, False]


@pytest.mark.parametrize("rgb", [(99, 10, 10), (200, 170, 170), (20, 200, 20)])
def test_dark_pale_and_other_colours_are_not_red(rgb):
    assert not detect_lines(frame_with(rgb, slice(140, 180))).red.is_there


@pytest.mark.parametrize("colour", ["black", "red", "blue"])
@pytest.mark.parametrize("scale", [1, 2])
@pytest.mark.parametrize(("y", "expected"), [(120, {"right"}), (0, {"center"}), (-120, {"left"})])
def test_a_line_on_the_floor_is_seen_on_its_side(colour, scale, y, expected):
    rgb = {"black": BLACK, "red": RED, "blue": BLUE}[colour]
    lines = detect_lines(seen([FloorLine([(-900, 0), (900, 0)], 25, rgb)], y=y, scale=scale))
    others = {"black", "red", "blue"} - {colour}
    assert expected == sides(getattr(lines, colour))
    assert not any(getattr(lines, other).is_there for other in others)


@pytest.mark.parametrize(("heading", "expected"), [(25, {"left"}), (-25, {"right"})])
def test_turning_right_moves_the_line_to_the_left(heading, expected):
    line = FloorLine([(-900, 0), (900, 0)], 25, BLACK)
    assert expected == sides(detect_lines(seen([line], heading=heading)).black)


def test_a_red_line_across_a_black_one_is_a_crossing():
    black = FloorLine([(-900, 0), (900, 0)], 25, BLACK)
    red = FloorLine([(-100, -900), (-100, 900)], 25, RED)
    assert detect_lines(seen([black, red])).is_crossing


def test_a_black_line_alone_is_not_a_crossing():
    assert not detect_lines(seen([FloorLine([(-900, 0), (900, 0)], 25, BLACK)])).is_crossing


def test_a_search_does_not_change_the_frame():
    frame = seen([FloorLine([(-900, 0), (900, 0)], 25, RED)])
    before = frame.copy()
    detect_lines(frame)
    assert np.array_equal(before, frame)


@pytest.mark.parametrize("shape", [(1, 1), (2, 3), (5, 320)])
def test_a_tiny_frame_is_searched_like_any_other(shape):
    lines = detect_lines(np.full((*shape, 3), 255, np.uint8))
    assert shape == (lines.red.frame_height, lines.red.frame_width)


def test_anything_but_a_picture_is_refused():
    with pytest.raises(FrameError):
        detect_lines(np.zeros((240, 320, 3)))


def as_defined(frame):
    """The counts of red and blue as defined: by hue, saturation and value of the whole frame."""
    height, width = frame.shape[:2]
    hsv = cv2.cvtColor(frame, cv2.COLOR_RGB2HSV)
    red = cv2.inRange(hsv, (0, 50, 100), (10, 255, 255)) | cv2.inRange(
        hsv, (170, 50, 100), (180, 255, 255)
    )
    blue = cv2.inRange(hsv, (100, 50, 50), (130, 255, 255))
    times = max(1, round(3 * height / 240))
    dilated = [
        cv2.dilate(mask, np.ones((3, 3), np.uint8), iterations=times) for mask in (red, blue)
    ]
    black = cv2.inRange(hsv, (0, 0, 0), (180, 255, 50))
    rows = slice(round(15 * height / 240), round(225 * height / 240))
    borders = [round(column * width / 320) for column in (0, 120, 200, 320)]
    return [
        [int(np.count_nonzero(mask[rows, a:b])) for a, b in pairwise(borders)]
        for mask in (black, *dilated)
    ]


@given(st.integers(0, 2**32 - 1), st.integers(0, 60))
def test_the_counts_are_those_of_hue_saturation_and_value(seed, variety):
    generator = np.random.default_rng(seed)
    height, width = generator.integers(4, 200, 2)
    base = generator.integers(0, 256, (height, width, 1))
    colours = generator.integers(-variety, variety + 1, (height, width, 3))
    frame = np.clip(base + colours, 0, 255).astype(np.uint8)
    lines = detect_lines(frame)

    found = [[view.left, view.center, view.right] for view in (lines.black, lines.red, lines.blue)]
    assert found == as_defined(frame)


def test_every_colour_is_judged_as_by_hue_saturation_and_value():
    levels = np.arange(0, 256, 5)
    colours = np.stack(np.meshgrid(levels, levels, levels), axis=-1).reshape(-1, 1, 3)
    for colour in colours[:: len(colours) // 3000].astype(np.uint8):
        frame = np.broadcast_to(colour, (16, 16, 3)).copy()
        lines = detect_lines(frame)
        found = [[x.left, x.center, x.right] for x in (lines.black, lines.red, lines.blue)]
        assert found == as_defined(frame), colour


def the_long_way(frame):
    """Count as the detector does, always by all colours of all pixels."""
    height, width = frame.shape[:2]
    top, bottom = (round(row * height / 240) for row in lines.ROWS)
    reach = max(1, round(lines.DILATION * height / 240))
    hsv = cv2.cvtColor(frame, cv2.COLOR_RGB2HSV)
    masks = {"black": cv2.inRange(frame, (0, 0, 0), (50, 50, 50))[top:bottom]}
    for colour, ranges in lines.COLOURS.items():
        found = np.zeros((height, width), np.uint8)
        for low, high in ranges:
            found |= cv2.inRange(hsv, low, high)
        above = max(0, top - reach)
        part = found[above : bottom + reach]
        part = cv2.dilate(part, np.ones((3, 3), np.uint8), iterations=reach)
        masks[colour] = part[top - above :][: bottom - top]
    borders = [round(column * width / 320) for column in lines.COLUMNS]
    return {
        colour: [int(np.count_nonzero(mask[:, a:b])) for a, b in pairwise(borders)]
        for colour, mask in masks.items()
    }


@given(st.integers(0, 2**32 - 1), st.sampled_from(["any", "grey", "nearly grey", "dark"]))
def test_the_short_ways_count_as_the_long_one(seed, kind):
    generator = np.random.default_rng(seed)
    height, width = generator.integers(12, 60, 2)
    frame = generator.integers(0, 256, (height, width, 3), dtype=np.uint8)
    if kind == "dark":
        frame //= 4
    if kind in ("grey", "nearly grey"):
        frame[:] = frame[..., :1]
    if kind == "nearly grey":
        frame[generator.integers(height), generator.integers(width)] = generator.integers(0, 256, 3)
    found = detect_lines(frame)
    counted = {
        colour: [view.left, view.center, view.right]
        for colour, view in (("black", found.black), ("red", found.red), ("blue", found.blue))
    }
    assert counted == the_long_way(frame)


ACROSS = FloorLine([(-180, -900), (-180, 900)], 25, BLACK)
AHEAD = FloorLine([(-900, 0), (900, 0)], 25, BLACK)
#: Tags and faces, and the tilt of the camera that sees them.
THINGS = {
    "a standing tag": ([standing(tag(3), 80, 0, 40)], 0),
    "a tag beside the way": ([standing(tag(8), 60, -100, 50)], -30),
    "a lying tag": ([lying(tag(5), 80, -120, -40)], -30),
    "two tags": ([standing(tag(3), 60, 0, 60), standing(tag(4), 60, 0, -60)], 0),
    "a face": ([standing(face("joy"), 200, 300, 0)], 0),
    "a near face": ([standing(face("sadness"), 150, 0, 0, 20)], 0),
}


def found(frame):
    return Sight(frame).detect("lines")


@pytest.mark.parametrize("name", THINGS)
def test_a_tag_or_a_face_is_no_line(name):
    things, tilt = THINGS[name]
    frame = seen([], things=things, tilt=tilt)
    seen_by_colour = detect_lines(frame)
    assert any(getattr(seen_by_colour, colour).is_there for colour in ("black", "red"))
    lines = found(frame)
    assert not any(view.is_there for view in (lines.black, lines.red, lines.blue))


def test_a_line_beside_a_tag_is_found_on_its_own_side():
    line = FloorLine([(-900, -60), (900, -60)], 5, BLACK)
    frame = seen([line], things=[standing(tag(3), 70, -60, 45)])
    assert {"left"} == sides(detect_lines(frame).black)
    assert {"right"} == sides(found(frame).black)


@pytest.mark.parametrize("x", [-150, -120])
def test_a_line_under_a_lying_tag_is_found_before_and_behind_it(x):
    bare = seen([AHEAD])
    frame = seen([AHEAD], things=[lying(tag(5), 60, x, 0)])
    assert {"center"} == sides(found(frame).black)
    # Only what the tag hides is missing.
    assert found(frame).black.center < found(bare).black.center


@pytest.mark.parametrize("lines", [[AHEAD], [ACROSS], [AHEAD, ACROSS], []])
@pytest.mark.parametrize("scale", [1, 2])
def test_lines_alone_are_found_without_looking_for_tags_or_faces(lines, scale):
    frame = seen(lines, scale=scale)
    alone = Sight(frame, detectors={"lines": DETECTORS["lines"]})
    assert alone.detect("lines") == detect_lines(frame)


def test_a_short_line_without_an_edge_of_the_picture_is_found_as_before():
    frame = seen([FloorLine([(-190, 0), (-120, 0)], 25, BLACK)])
    assert found(frame) == detect_lines(frame)
    assert {"center"} == sides(found(frame).black)


@given(seed=st.integers(0, 2**32 - 1))
def test_a_blob_is_a_component_that_is_not_cut(seed):
    generator = np.random.default_rng(seed)
    mask = np.zeros((120, 160), np.uint8)
    for _ in range(generator.integers(0, 6)):
        x, y, radius = generator.integers((0, 0, 1), (160, 120, 60)).tolist()
        # Also rings, with other components in them.
        cv2.circle(mask, (x, y), radius, 255, int(generator.choice([-1, 1, 4])))
    small = np.ascontiguousarray(mask[::2, ::2])
    boxes = cv2.connectedComponentsWithStats(small)[2][1:]
    is_whole = [x > 0 and x + w < 80 and y + h < 60 and min(w, h) >= 2.5 for x, y, w, h, _ in boxes]

    assert lines._is_blob(mask, 120) == any(is_whole)
