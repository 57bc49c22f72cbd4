import numpy as np
import pytest

from learnblock.errors import FrameError
from learnblock.perception.detectors.objects import COLOURS, detect_objects
from learnblock.simulator.textures import face

RGB = {
    "red": (200, 30, 30),
    "orange": (240, 130, 20),
    "yellow": (240, 220, 30),
    "green": (40, 160, 60),
    "blue": (30, 70, 200),
    "purple": (130, 40, 170),
}


def sheet(*placed, height=240, width=320, noise=0.0):
    """Return a grey frame with rectangles (colour, left, top, width, height)."""
    frame = np.full((height, width, 3), 200, np.float64)
    for colour, left, top, wide, high in placed:
        frame[top : top + high, left : left + wide] = RGB[colour]
    frame += np.random.default_rng(1).normal(0, noise, frame.shape) if noise else 0
    return frame.clip(0, 255).astype(np.uint8)


@pytest.mark.parametrize("colour", COLOURS)
def test_each_colour_is_distinguished_in_noise(colour):
    (found,) = detect_objects(sheet((colour, 40, 60, 50, 30), noise=5))
    assert (found.colour, found.center) == (colour, pytest.approx((64.5, 74.5), abs=1))
    assert (found.x, found.y, found.width, found.height) == pytest.approx((40, 60, 50, 30), abs=2)
    assert found.area == pytest.approx(1500, rel=0.05)


def test_the_largest_comes_first():
    frame = sheet(("red", 10, 10, 20, 20), ("blue", 100, 10, 60, 60), ("red", 200, 100, 40, 40))
    found = [(one.colour, one.width) for one in detect_objects(frame)]
    assert found == [("blue", 60), ("red", 40), ("red", 20)]


def test_a_few_pixels_are_not_an_object():
    assert detect_objects(sheet(("green", 50, 50, 7, 7))) == ()


def test_in_a_larger_frame_an_object_must_be_larger():
    small = sheet(("green", 50, 50, 9, 9))
    large = sheet(("green", 50, 50, 9, 9), height=480, width=640)
    assert (len(detect_objects(small)), len(detect_objects(large))) == (1, 0)


@pytest.mark.parametrize(("left", "side"), [(20, "left"), (145, "center"), (270, "right")])
def test_an_object_is_on_one_side(left, side):
    (found,) = detect_objects(sheet(("purple", left, 50, 30, 30)))
    assert [side] == [one for one in ("left", "center", "right") if getattr(found, f"is_{one}")]


def test_the_share_is_relative_to_the_frame():
    (found,) = detect_objects(sheet(("red", 0, 0, 160, 120)))
    assert found.share == pytest.approx(0.25)


def test_skin_is_not_an_object():
    frame = np.full((240, 320, 3), 200, np.uint8)
    frame[20:220, 60:260] = face("neutral", 200)
    assert [one for one in detect_objects(frame) if one.share > 0.02 and one.colour != "blue"] == []


def test_anything_but_a_picture_is_refused():
    with pytest.raises(FrameError):
        detect_objects(np.zeros((240, 320), np.uint8))
