from typing import get_args

import numpy as np
import pytest

from learnblock.simulator.description_types import Emotion
from learnblock.simulator.picture import icons
from learnblock.simulator.picture.palette import WHITE
from learnblock.simulator.picture.svg import Circle, Polygon
from learnblock.simulator.picture.view import fitted
from learnblock.simulator.robot_description import Body, load_robot

VIEW = fitted((2000, 2000), np.empty((0, 2)), bar=True)
EMOTIONS = get_args(Emotion)


def test_every_emotion_has_a_distinct_colour_and_face():
    faces = {str(list(icons.face((0, 0), 14, emotion))) for emotion in EMOTIONS}
    colours = {icons.emotion_colour(emotion) for emotion in EMOTIONS}
    assert len(EMOTIONS) == len(faces) == len(colours)


def test_an_unknown_emotion_is_a_blank_face():
    assert icons.emotion_colour("none") == icons.emotion_colour("hunger")
    assert list(icons.face((0, 0), 14, "none"))


def test_joy_smiles_and_sadness_does_not():
    def middle_below_corners(emotion: str) -> float:
        mouth = list(icons.face((0, 0), 10, emotion))[-1].points
        return mouth[6][1] - mouth[0][1]

    assert middle_below_corners("joy") > 0
    assert middle_below_corners("sadness") < 0


def test_a_round_robot_is_drawn_as_a_disc_at_its_scale():
    body = Body(shape="disc", radius=75, height=80, mass=1, colour="black")
    _, hull, arrow = icons.robot(body, VIEW, (10, 20, 0))
    assert isinstance(hull, Circle)
    assert VIEW.at(10, 20) == pytest.approx(hull.center)
    assert 75 * VIEW.scale == pytest.approx(hull.radius)
    assert WHITE == arrow.paint.fill


@pytest.mark.parametrize("heading", [0, 90, 200])
def test_a_robot_faces_along_its_heading(heading):
    _, hull, arrow = icons.robot(load_robot("thymio").body, VIEW, (0, 0, heading))
    assert isinstance(hull, Polygon)
    ahead = np.subtract(VIEW.placed([(1, 0)], 0, 0, heading)[0], VIEW.at(0, 0))
    along = [float(np.dot(point, ahead)) for point in arrow.points]
    assert along.index(max(along)) == 0
