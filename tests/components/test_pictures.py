"""Frames as the pictures of components: there and back, and what is no picture is refused."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from learnblock.components.pictures import LONGEST_SIDE, Order, PictureError, packed, unpacked
from learnblock.ice.robocomp.recognition import Picture

SIDES = st.integers(1, 12)
FRAMES = st.tuples(SIDES, SIDES, st.just(3)).flatmap(lambda shape: arrays(np.uint8, shape))


@given(FRAMES, st.sampled_from(Order))
def test_a_frame_comes_back_from_its_picture(frame, order):
    assert np.array_equal(frame, unpacked(packed(frame, order), order))


def test_width_carries_the_rows_as_in_robocomps_components():
    picture = packed(np.zeros((240, 320, 3), np.uint8), Order.ROWS)
    assert (picture.width, picture.height, picture.depth) == (240, 320, 3)


@pytest.mark.parametrize("shape", [(240, 320, 3), (320, 240, 3), (48, 64, 3)])
@pytest.mark.parametrize("order", Order)
def test_the_order_is_found_out_by_how_the_pixels_fit(shape, order):
    rows, columns = np.indices(shape[:2])
    shade = ((rows - 20) ** 2 + (columns - 30) ** 2 < 300) * 150 + columns // 4
    frame = np.repeat(shade.astype(np.uint8)[:, :, None], 3, axis=2)
    assert unpacked(packed(frame, order)).shape == shape


def test_where_every_order_fits_it_is_robocomps():
    plain = np.full((240, 320, 3), 9, np.uint8)
    assert unpacked(packed(plain, Order.ROWS)).shape == (240, 320, 3)


@pytest.mark.parametrize(
    ("width", "height", "depth", "size", "sentence"),
    [
        (240, 320, 3, 0, "has 230400 bytes, not the 0 sent"),
        (240, 320, 3, 230_399, "has 230400 bytes, not the 230399 sent"),
        (240, 320, 3, 230_401, "has 230400 bytes, not the 230401 sent"),
        (0, 320, 3, 0, "cannot be looked at"),
        (240, 0, 3, 0, "cannot be looked at"),
        (-1, -1, 3, 3, "cannot be looked at"),
        (-240, 320, -3, 230_400, "cannot be looked at"),
        (1, 1, 0, 0, "cannot be looked at"),
        (240, 320, 1, 76_800, "3 bytes a pixel"),
        (240, 320, 4, 307_200, "3 bytes a pixel"),
        (2**31 - 1, 2**31 - 1, 3, 10, "is too large"),
        (2**31 - 1, 1, 3, 10, "is too large"),
        (65536, 65536, 3, 0, "is too large"),
        (1, LONGEST_SIDE + 1, 3, 5763, "is too large"),
        (LONGEST_SIDE, LONGEST_SIDE, 3, 10, "is too large"),
    ],
)
def test_what_is_no_picture_is_refused(width, height, depth, size, sentence):
    for order in (None, *Order):
        with pytest.raises(PictureError, match=sentence):
            unpacked(Picture(width, height, depth, bytes(size)), order)


@given(*[st.integers(-(2**31), 2**31 - 1)] * 2, st.integers(-4, 4), st.binary(max_size=100))
def test_whatever_is_sent_becomes_a_frame_of_its_bytes_or_is_refused(width, height, depth, image):
    try:
        frame = unpacked(Picture(width, height, depth, image))
    except PictureError:
        return
    assert frame.tobytes() == image
    assert sorted(frame.shape[:2]) == sorted((width, height))


@pytest.mark.parametrize("shape", [(1, 7, 3), (7, 1, 3), (1, 1, 3)])
def test_pictures_of_one_row_or_column_are_read(shape):
    frame = np.arange(np.prod(shape), dtype=np.uint8).reshape(shape)
    assert unpacked(packed(frame, Order.ROWS)).size == frame.size
