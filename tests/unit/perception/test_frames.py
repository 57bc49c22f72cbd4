import numpy as np
import pytest

from learnblock.errors import FrameError, LearnBlockError
from learnblock.i18n import Phrase
from learnblock.perception.frames import checked


def test_a_picture_passes_unchanged():
    frame = np.zeros((3, 4, 3), np.uint8)
    assert frame is checked(frame)


@pytest.mark.parametrize(
    ("frame", "message"),
    [
        (None, Phrase("perception-frame-not-array", type="NoneType")),
        ([[0, 0, 0]], Phrase("perception-frame-not-array", type="list")),
        (np.zeros((3, 4, 3)), Phrase("perception-frame-not-uint8", type="float64")),
        (np.zeros((3, 4), np.uint8), Phrase("perception-frame-wrong-shape", shape="(3, 4)")),
        (np.zeros((3, 4, 4), np.uint8), Phrase("perception-frame-wrong-shape", shape="(3, 4, 4)")),
        (np.zeros((0, 4, 3), np.uint8), Phrase("perception-frame-empty", shape="(0, 4, 3)")),
        (
            np.zeros((1, 8193, 3), np.uint8),
            Phrase("perception-frame-too-large", shape="(1, 8193, 3)", limit=8192),
        ),
    ],
    ids=["none", "list", "float", "grey", "rgba", "empty", "long"],
)
def test_anything_but_a_picture_is_refused(frame, message):
    with pytest.raises(FrameError) as refused:
        checked(frame)
    assert refused.value.phrase == message


def test_a_frame_error_is_ours_and_a_value_error():
    assert issubclass(FrameError, LearnBlockError)
    assert issubclass(FrameError, ValueError)
