import numpy as np
import pytest

from learnblock.perception.detectors.cut_faces import cut_skin
from learnblock.perception.detectors.lines import detect_lines
from learnblock.perception.sight import Sight
from learnblock.simulator.camera import Surface
from learnblock.simulator.textures import EMOTIONS, FloorLine, face
from photographs import STEPS, photograph, upright

RED, WALL = (200, 20, 20), (190, 170, 140)
COLOURS = ("black", "red", "blue")


def flat(colour, west, east, bottom=0.0, top=0.0):
    """A floor, or a wall in the east, of one colour."""
    corners = [(west, 3000, top), (west, -3000, top), (east, -3000, bottom), (east, 3000, bottom)]
    return Surface(np.array(corners, float), np.full((4, 4, 3), colour, np.uint8))


def in_a_room(things=(), lines=(), *, tilt):
    """A picture with a wall behind the floor."""
    return photograph([*things, flat(WALL, 500, 500, 0, 1500)], lines, tilt=tilt)


def portrait(step, size, x, y, bottom):
    """A face at (x, y); the person and the emotion change with each step."""
    return upright(face(EMOTIONS[step % len(EMOTIONS)], 400, 1000 + step), size, x, y, bottom)


#: By pose: the face at a step, the tilt of the camera, in how many of 21 pictures plain counting
#: sees a line, and in how many it may still be seen.
POSES = {
    "level": (lambda n, y: portrait(n, 200, 0, y, 20), 0, 21, 2),
    "level and near": (lambda n, y: portrait(n, 150, -100, y, 30), 0, 15, 2),
    "from above": (lambda n, y: portrait(n, 200, 0, 0.9 * y, 0), -25, 21, 2),
    "high": (lambda n, y: portrait(n, 200, 0, y, 120), 0, 21, 3),
}


def has_line(lines):
    return any(getattr(lines, colour).is_there for colour in COLOURS)


@pytest.mark.parametrize("pose", POSES)
def test_a_face_is_no_line_wherever_the_edge_of_the_picture_cuts_it(pose):
    thing, tilt, plain, left = POSES[pose]
    frames = [in_a_room([thing(n, y)], tilt=tilt) for n, y in enumerate(STEPS)]
    assert sum(has_line(detect_lines(frame)) for frame in frames) == plain
    assert sum(has_line(Sight(frame).detect("lines")) for frame in frames) <= left


@pytest.mark.parametrize(
    "points",
    [
        [(-900, 0), (900, 0)],
        [(-120, -900), (-120, 900)],
        [(-300, 0), (-150, 0), (-150, 900)],
        [(-300, -300), (300, 300)],
    ],
)
@pytest.mark.parametrize("width", [10, 25, 40])
@pytest.mark.parametrize("tilt", [-15, -30])
def test_a_red_line_is_no_cut_face(points, width, tilt):
    frame = in_a_room(lines=[FloorLine(points, width, RED)], tilt=tilt)
    assert detect_lines(frame).red.is_there
    assert Sight(frame).detect("lines") == detect_lines(frame)


def test_a_thing_of_the_colour_of_skin_hides_no_black_line():
    box = flat((228, 184, 152), -60, -60, 0, 60)
    box.corners[:, 1] = [-40, -900, -900, -40]
    line = FloorLine([(-900, 40), (900, 40)], 15, (0, 0, 0))
    frame = in_a_room([box], [line], tilt=-30)
    assert [skin.is_face for skin in cut_skin(frame)] == [False]
    assert Sight(frame).detect("lines").black == detect_lines(frame).black
