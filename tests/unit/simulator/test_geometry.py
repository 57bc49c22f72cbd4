import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from learnblock.simulator.geometry import Polyline, Pose, arc, forward, wrapped

angles = st.floats(-1000, 1000)
lengths = st.floats(-2000, 2000)
points = st.tuples(lengths, lengths)


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


def test_an_arc_is_as_long_as_its_curve() -> None:
    curve = Polyline.through([(0, 0), *arc(Pose(0, 0, 0), 180, 300)])

    assert curve.length == pytest.approx(math.pi * 300, rel=1e-3)


@given(st.lists(points, min_size=2, max_size=8), points)
def test_no_point_of_a_polyline_is_nearer_than_the_nearest(
    corners: list[tuple[float, float]], point: tuple[float, float]
) -> None:
    line = Polyline.through(corners)
    if len(line.points) < 2:
        return
    distance, along = line.nearest(*point)
    parts = np.linspace(0, 1, 11)[:, None]
    samples = np.concatenate(
        [a + parts * (b - a) for a, b in zip(line.points, line.points[1:], strict=False)]
    )

    assert distance <= np.hypot(*(samples - point).T).min() + 1e-6
    assert -1e-6 <= along <= line.length + 1e-6


def test_a_polyline_gives_the_distance_along_it_to_a_point() -> None:
    line = Polyline.through([(0, 0), (100, 0), (100, 100)])

    assert line.nearest(90, 50) == pytest.approx((10, 150))


def measured(line: Polyline, x: float, y: float) -> tuple[float, float]:
    """The distance of (x, y) from the line and of its nearest point along it, piece by piece."""
    sides = np.diff(line.points, axis=0)
    lengths = np.hypot(sides[:, 0], sides[:, 1])
    offsets = np.array([x, y]) - line.points[:-1]
    parts = np.clip((offsets * sides).sum(axis=1) / lengths**2, 0.0, 1.0)
    gaps = offsets - parts[:, None] * sides
    distances = np.hypot(gaps[:, 0], gaps[:, 1])
    piece = int(distances.argmin())
    along = float(lengths[:piece].sum()) + parts[piece] * lengths[piece]
    return float(distances[piece]), float(along)


@given(st.lists(points, min_size=2, max_size=40), st.lists(points, min_size=1, max_size=20))
def test_the_nearest_point_is_that_of_all_pieces_to_the_last_bit(
    corners: list[tuple[float, float]], places: list[tuple[float, float]]
) -> None:
    line = Polyline.through(corners)
    if len(line.points) < 2:
        return

    assert [line.nearest(x, y) for x, y in places] == [measured(line, x, y) for x, y in places]


@given(st.lists(st.floats(0, 360), min_size=1, max_size=20), st.floats(300, 500))
def test_the_nearest_point_of_a_curve_is_exact_all_around_it(
    directions: list[float], radius: float
) -> None:
    curve = Polyline.through([(400, 0), *arc(Pose(400, 0, 90), 360, 400)])
    places = [(radius * math.cos(way), radius * math.sin(way)) for way in directions]

    assert [curve.nearest(x, y) for x, y in places] == [measured(curve, x, y) for x, y in places]
