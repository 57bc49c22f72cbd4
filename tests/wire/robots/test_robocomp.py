"""The shared parts of RoboComp robots: units, signs, layouts and messages."""

import math
from contextlib import ExitStack, contextmanager

import pytest

from ice_runtime import components
from learnblock.ice.endpoint import Endpoint
from learnblock.ice.robocomp import BaseState, Layout
from learnblock.robots.robocomp import by_side, in_range, pose_of
from learnblock.robots.robocomp.layouts import layouts_of

ROBOT, TOOL, SINCE_2020 = Layout


@pytest.mark.parametrize(
    ("state", "pose"),
    [
        (BaseState(), (0, 0, 0)),
        # Forward is z there, and x here.
        (BaseState(z=100.0), (100, 0, 0)),
        # To the right is x there, and -y here.
        (BaseState(x=100.0), (0, -100, 0)),
        # Clockwise is positive in both.
        (BaseState(alpha=math.pi / 2), (0, 0, 90)),
        (BaseState(x=-1.0, z=-2.0, alpha=-math.pi), (-2, 1, -180)),
    ],
)
def test_a_bases_state_is_a_pose_of_ours(state, pose):
    assert pose_of(state) == pytest.approx(pose)


def test_half_a_circle_to_the_right_ends_to_the_right_of_the_start():
    # RoboComp's own odometry, a quarter of a circle with a radius of 100 mm.
    x = z = alpha = 0.0
    for _ in range(1000):
        alpha += math.pi / 2000
        x += math.pi / 20 * math.sin(alpha)
        z += math.pi / 20 * math.cos(alpha)
    assert pose_of(BaseState(x=x, z=z, alpha=alpha)) == pytest.approx((100, -100, 90), abs=0.2)


@pytest.mark.parametrize(
    ("mm", "expected"),
    [(300.5, 300.5), (1999.0, 1999.0), (2000.0, 2000), (8190.0, 2000), (0.0, 2000), (-1.0, 2000),
     (math.inf, 2000), (math.nan, 2000)],
)  # fmt: skip
def test_a_ranger_that_sees_nothing_reads_2000(mm, expected):
    assert in_range(mm) == expected


def test_five_distances_cover_three_sides():
    assert by_side([1, 2, 3, 4, 5]) == {"left": [1, 2], "front": [2, 3, 4], "right": [4, 5]}


MOVING = {"isMoving": True, "x": 100.0, "z": -35.5, "alpha": 0.25, "rotV": 0.5}


NAMES = ("differentialrobot", "laser", "jointmotor")


@contextmanager
def endpoints_of(running):
    """The endpoints of the three components."""
    with ExitStack() as stack:
        yield {
            name: stack.enter_context(Endpoint("127.0.0.1", port, 5))
            for name, port in zip(NAMES, running.ports, strict=True)
        }


#: Answers of zeros and empty strings, like those of EBO's components.
SILENT = {"silent": True}


def found(folder, layout, base=None, laser=SILENT, joints=SILENT):
    """The layouts that fit components of the real Ice."""
    options = {"state": base or {}}, laser, joints
    with (
        components(folder, layout, *zip(NAMES, options, strict=True)) as running,
        endpoints_of(running) as endpoints,
    ):
        return layouts_of(endpoints)


@pytest.mark.parametrize("layout", Layout)
def test_components_with_answers_show_their_layout(tmp_path, layout):
    laser = {"driver": "HokuyoURG", "device": "/dev/laser"}
    assert found(tmp_path, layout, MOVING, laser, {"handler": "CAN"}) == (layout,)


def test_goals_alone_distinguish_ebos_components_from_others(tmp_path):
    assert found(tmp_path, ROBOT) == (ROBOT,)


@pytest.mark.parametrize("layout", [TOOL, SINCE_2020])
def test_a_moving_base_distinguishes_the_other_two_layouts(tmp_path, layout):
    assert found(tmp_path, layout, MOVING) == (layout,)


@pytest.mark.parametrize("turned", [1e-7, 1e-17, -1e-30])
@pytest.mark.parametrize("layout", [TOOL, SINCE_2020])
def test_a_base_that_has_driven_straight_does_too(tmp_path, layout, turned):
    assert found(tmp_path, layout, {**MOVING, "alpha": turned}) == (layout,)


@pytest.mark.parametrize("layout", [TOOL, SINCE_2020])
def test_a_laser_with_a_name_distinguishes_the_other_two_layouts(tmp_path, layout):
    assert found(tmp_path, layout, laser={"driver": "Gazebo"}) == (layout,)


@pytest.mark.parametrize("layout", [TOOL, SINCE_2020])
def test_components_with_empty_answers_may_have_either_layout(tmp_path, layout):
    assert found(tmp_path, layout) == (TOOL, SINCE_2020)


def test_detecting_the_layout_moves_nothing(tmp_path):
    with components(tmp_path, ROBOT, *NAMES) as running, endpoints_of(running) as endpoints:
        layouts_of(endpoints)
        assert running.has_told_nothing()
