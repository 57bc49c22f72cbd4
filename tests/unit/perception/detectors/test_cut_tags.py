import numpy as np
import pytest

from learnblock.perception.detectors.cut_tags import cut_tags
from learnblock.perception.detectors.lines import BLACK as DARKEST
from learnblock.perception.detectors.lines import detect_lines
from learnblock.perception.sight import Sight
from learnblock.simulator.camera import Surface
from learnblock.simulator.textures import FloorLine, tag
from photographs import STEPS, photograph, upright

BLACK = (0, 0, 0)


def standing(number, size, x, y, bottom):
    """An upright tag at (x, y)."""
    return upright(tag(number), size, x, y, bottom)


def lying(number, size, x, y):
    west, east, left, right = x - size / 2, x + size / 2, y + size / 2, y - size / 2
    corners = [(east, left, 1), (east, right, 1), (west, right, 1), (west, left, 1)]
    return Surface(np.array(corners, float), tag(number))


#: By pose: the tag at a step, the tilt of the camera, in how many of the 21 pictures plain counting
#: of dark pixels sees a line, and in how many it may still be seen.
POSES = {
    "level": (lambda y: standing(8, 100, 0, y, 50), 0, 19, 0),
    "level and near": (lambda y: standing(3, 100, -120, 0.8 * y, 50), 0, 15, 0),
    "from above": (lambda y: standing(8, 100, 0, 0.9 * y, 0), -30, 21, 2),
    "lying": (lambda y: lying(5, 80, -120, 0.75 * y), -30, 19, 2),
}


@pytest.mark.parametrize("scale", [1, 2])
@pytest.mark.parametrize("pose", POSES)
def test_a_tag_is_no_line_wherever_the_edge_of_the_picture_cuts_it(pose, scale):
    thing, tilt, plain, left = POSES[pose]
    frames = [photograph([thing(y)], tilt=tilt, scale=scale) for y in STEPS]
    assert sum(detect_lines(frame).black.is_there for frame in frames) == plain
    assert sum(Sight(frame).detect("lines").black.is_there for frame in frames) <= left


@pytest.mark.parametrize(
    "points",
    [
        [(-900, 0), (900, 0)],
        [(-120, -900), (-120, 900)],
        [(-900, -100), (-100, 0), (400, 300)],
        [(-300, 0), (-100, 0)],
        [(-300, 0), (-150, 0), (-150, 900)],
        [(-300, -300), (300, 300)],
        [(-140, 900), (-140, 40)],
        [(-300, 60), (-120, 60), (0, -40), (400, -40)],
    ],
)
@pytest.mark.parametrize("width", [10, 25, 40])
@pytest.mark.parametrize("tilt", [-15, -30])
def test_a_line_is_no_cut_tag(points, width, tilt):
    frame = photograph(lines=[FloorLine(points, width, BLACK)], tilt=tilt)
    assert detect_lines(frame).black.is_there
    assert Sight(frame).detect("lines") == detect_lines(frame)


def test_two_lines_that_cross_are_no_cut_tag():
    ahead, across = FloorLine([(-900, 0), (900, 0)], 25), FloorLine([(-150, -900), (-150, 900)], 25)
    assert not list(cut_tags(photograph(lines=[ahead, across], tilt=-30).max(axis=2), DARKEST))


def test_a_line_beside_a_cut_tag_is_seen():
    line = FloorLine([(-900, -60), (900, -60)], 15, BLACK)
    frame = photograph([standing(8, 100, 0, 150, 0)], [line], tilt=-30)
    alone = photograph(lines=[line], tilt=-30)
    assert list(cut_tags(frame.max(axis=2), DARKEST))
    assert Sight(frame).detect("lines").black.right == detect_lines(alone).black.right
    assert Sight(frame).detect("lines").black.left == detect_lines(alone).black.left
