import numpy as np
import pytest

from learnblock.errors import LearnBlockError
from learnblock.perception.frames import FrameError, checked


def test_a_picture_passes_unchanged():
    frame = np.zeros((3, 4, 3), np.uint8)
    assert frame is checked(frame)


@pytest.mark.parametrize(
    ("frame", "message"),
    [
        (None, "of type NoneType; expected an RGB picture"),
        ([[0, 0, 0]], "of type list"),
        (np.zeros((3, 4, 3)), "values are float64"),
        (np.zeros((3, 4), np.uint8), r"shape is \(3, 4\)"),
        (np.zeros((3, 4, 4), np.uint8), r"shape is \(3, 4, 4\)"),
        (np.zeros((0, 4, 3), np.uint8), r"is empty, its shape is \(0, 4, 3\)"),
        (np.zeros((1, 8193, 3), np.uint8), "a side has 8192 pixels at most"),
    ],
    ids=["none", "list", "float", "grey", "rgba", "empty", "long"],
)
def test_what_is_no_picture_is_refused_with_what_was_expected(frame, message):
    with pytest.raises(FrameError, match=message):
        checked(frame)


def test_a_frame_error_is_ours_and_a_value_error():
    assert issubclass(FrameError, LearnBlockError)
    assert issubclass(FrameError, ValueError)
