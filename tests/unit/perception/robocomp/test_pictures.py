"""Frames as the pictures of components, in both directions; invalid pictures are refused."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from learnblock.errors import PictureError
from learnblock.ice.robocomp.recognition import Picture
from learnblock.perception.robocomp.pictures import (
    LONGEST_SIDE,
    PixelOrder,
    packed,
    unpacked,
)

SIDES = st.integers(1, 12)
FRAMES = st.tuples(SIDES, SIDES, st.just(3)).flatmap(lambda shape: arrays(np.uint8, shape))


@given(FRAMES, st.sampled_from(PixelOrder))
def test_a_frame_comes_back_from_its_picture(frame, order):
    assert np.array_equal(frame, unpacked(packed(frame, order), order))


def test_width_is_the_number_of_rows_as_in_robocomps_components():
    picture = packed(np.zeros((240, 320, 3), np.uint8), PixelOrder.ROWS)
    assert (picture.width, picture.height, picture.depth) == (240, 320, 3)


@pytest.mark.parametrize("shape", [(240, 320, 3), (320, 240, 3), (48, 64, 3)])
@pytest.mark.parametrize("order", PixelOrder)
def test_the_order_is_detected_by_comparing_neighbouring_rows(shape, order):
    rows, columns = np.indices(shape[:2])
    shade = ((rows - 20) ** 2 + (columns - 30) ** 2 < 300) * 150 + columns // 4
    frame = np.repeat(shade.astype(np.uint8)[:, :, None], 3, axis=2)
    assert unpacked(packed(frame, order)).shape == shape


def test_robocomps_order_is_used_if_every_order_fits():
    plain = np.full((240, 320, 3), 9, np.uint8)
    assert unpacked(packed(plain, PixelOrder.ROWS)).shape == (240, 320, 3)


@pytest.mark.parametrize(
    ("width", "height", "depth", "size", "code"),
    [
        (240, 320, 3, 0, "perception-picture-wrong-size"),
        (240, 320, 3, 230_399, "perception-picture-wrong-size"),
        (240, 320, 3, 230_401, "perception-picture-wrong-size"),
        (0, 320, 3, 0, "perception-picture-not-rgb"),
        (240, 0, 3, 0, "perception-picture-not-rgb"),
        (-1, -1, 3, 3, "perception-picture-not-rgb"),
        (-240, 320, -3, 230_400, "perception-picture-not-rgb"),
        (1, 1, 0, 0, "perception-picture-not-rgb"),
        (240, 320, 1, 76_800, "perception-picture-not-rgb"),
        (240, 320, 4, 307_200, "perception-picture-not-rgb"),
        (2**31 - 1, 2**31 - 1, 3, 10, "perception-picture-too-large"),
        (2**31 - 1, 1, 3, 10, "perception-picture-too-large"),
        (65536, 65536, 3, 0, "perception-picture-too-large"),
        (1, LONGEST_SIDE + 1, 3, 5763, "perception-picture-too-large"),
        (LONGEST_SIDE, LONGEST_SIDE, 3, 10, "perception-picture-too-large"),
    ],
)
def test_anything_but_a_picture_is_refused(width, height, depth, size, code):
    for order in (None, *PixelOrder):
        with pytest.raises(PictureError) as refused:
            unpacked(Picture(width, height, depth, bytes(size)), order)
        assert refused.value.phrase.code == code
        assert (width, height) == tuple(
            refused.value.phrase.values[one] for one in ("width", "height")
        )


@given(*[st.integers(-(2**31), 2**31 - 1)] * 2, st.integers(-4, 4), st.binary(max_size=100))
def test_any_picture_becomes_a_frame_with_its_bytes_or_is_refused(width, height, depth, image):
    try:
        frame = unpacked(Picture(width, height, depth, image))
    except PictureError:
        return
    assert frame.tobytes() == image
    assert sorted(frame.shape[:2]) == sorted((width, height))


@pytest.mark.parametrize("shape", [(1, 7, 3), (7, 1, 3), (1, 1, 3)])
def test_pictures_of_one_row_or_column_are_read(shape):
    frame = np.arange(np.prod(shape), dtype=np.uint8).reshape(shape)
    assert unpacked(packed(frame, PixelOrder.ROWS)).size == frame.size
