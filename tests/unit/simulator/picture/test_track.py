import math
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from learnblock.simulator.picture.palette import time_colour
from learnblock.simulator.picture.svg import Polygon, Polyline
from learnblock.simulator.picture.track import MOST_ARROWS, POINTS_A_STEP, STEPS, TOLERANCE, Track
from learnblock.simulator.picture.view import fitted

VIEW = fitted((2000, 2000), np.empty((0, 2)), bar=True)
STRAIGHT = [(0.0, -500.0, 0.0, 0.0), (10.0, 500.0, 0.0, 0.0)]


def circle(points: int) -> list[tuple[float, float, float, float]]:
    angles = np.linspace(0, 2 * math.pi, points).tolist()
    return [(a, 400 * math.cos(a), 400 * math.sin(a), 0.0) for a in angles]


def test_a_path_of_two_points_runs_through_all_colours():
    lines = [shape for shape in Track.of(STRAIGHT, VIEW).drawn() if isinstance(shape, Polyline)]
    assert STEPS + 1 == len(lines)
    assert time_colour(0.5 / STEPS) == lines[1].colour
    assert time_colour(1 - 0.5 / STEPS) == lines[-1].colour


def test_the_line_has_no_gap_between_two_colours():
    lines = [shape for shape in Track.of(circle(5000), VIEW).drawn() if isinstance(shape, Polyline)]
    for before, after in pairwise(lines[1:]):
        assert before.points[-1] == pytest.approx(after.points[0])


def test_a_hundred_thousand_points_are_thinned_without_leaving_the_path():
    track = Track.of(circle(100_000), VIEW)
    assert len(track.points) < 1000
    middle = np.array(VIEW.at(0, 0))
    radii = np.hypot(*(track.points - middle).T)
    np.testing.assert_allclose(radii, 400 * VIEW.scale, atol=TOLERANCE)


def test_even_a_path_that_jumps_around_is_thinned():
    places = np.random.default_rng(1).uniform(-900, 900, (100_000, 2)).tolist()
    track = Track.of([(k / 20, x, y, 0.0) for k, (x, y) in enumerate(places)], VIEW)
    assert len(track.points) <= STEPS * POINTS_A_STEP
    assert len([shape for shape in track.drawn() if isinstance(shape, Polygon)]) <= MOST_ARROWS


@given(st.lists(st.tuples(st.floats(-900, 900), st.floats(-900, 900)), min_size=1, max_size=20))
def test_a_track_begins_and_ends_with_the_path(places):
    track = Track.of([(k / 20, x, y, 0.0) for k, (x, y) in enumerate(places)], VIEW)
    assert VIEW.at(*places[0]) == pytest.approx(track.points[0])
    assert VIEW.at(*places[-1]) == pytest.approx(track.points[-1])


def test_arrowheads_point_in_the_direction_of_travel():
    arrows = [shape for shape in Track.of(STRAIGHT, VIEW).drawn() if isinstance(shape, Polygon)]
    assert arrows
    for arrow in arrows:
        tip, *others = arrow.points
        assert all(tip[0] > x for x, _ in others)


def test_a_robot_at_rest_leaves_no_arrowhead():
    track = Track.of([(k / 20, 5.0, 5.0, 0.0) for k in range(50)], VIEW)
    assert track.length == 0
    assert not [shape for shape in track.drawn() if isinstance(shape, Polygon)]


def test_points_are_spread_evenly_along_the_path():
    points = Track.of(STRAIGHT, VIEW).spread(10.0)
    gaps = np.hypot(*np.diff(points, axis=0).T)
    np.testing.assert_allclose(gaps[:-1], 10.0, rtol=1e-4)
