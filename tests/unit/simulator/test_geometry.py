import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from learnblock.simulator.geometry import Pose, arc, forward, wrapped

angles = st.floats(-1000, 1000)


def test_heading_90_faces_south() -> None:
    assert forward(90) == pytest.approx((0, -1))


@given(angles)
def test_a_wrapped_angle_is_the_same_direction(angle: float) -> None:
    assert -180 <= wrapped(angle) < 180
    assert forward(wrapped(angle)) == pytest.approx(forward(angle), abs=1e-9)


@given(angles, st.floats(1, 360), st.floats(10, 1000))
def test_an_arc_backwards_undoes_an_arc(heading: float, angle: float, radius: float) -> None:
    start = Pose(10, 20, heading)
    end = start.along_arc(angle, radius)
    back = Pose(end.x, end.y, end.heading + 180).along_arc(-angle, radius)

    assert (back.x, back.y) == pytest.approx((10, 20), abs=1e-6)


@given(st.floats(1, 360), st.floats(10, 1000))
def test_every_point_of_an_arc_is_one_radius_from_its_center(angle: float, radius: float) -> None:
    for x, y in arc(Pose(0, 0, 0), angle, radius):
        assert math.hypot(x, y + radius) == pytest.approx(radius)
