import math
import subprocess
import sys

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from learnblock.simulator.geometry import Pose, arc
from learnblock.simulator.polyline import Polyline

lengths = st.floats(-2000, 2000)
points = st.tuples(lengths, lengths)


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


def test_a_world_without_a_line_or_a_camera_does_not_need_numpy() -> None:
    program = (
        "import sys\n"
        "from learnblock.robots.sim_ebo import Robot\n"
        "robot = Robot(world='arena')\n"
        "robot.move_straight(100)\n"
        "robot.sleep(0.1)\n"
        "robot.is_front_obstacle(150)\n"
        "print('numpy' in sys.modules)\n"
    )
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, check=True)

    assert done.stdout.split() == [b"False"]
