"""What twins drive and reckon at any commanded speed, also beyond what their wheels can do."""

import math

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from learnblock.robots import sim_cozmo, sim_ebo, sim_ev3, sim_thymio

TWINS = {
    one.__name__.rpartition(".")[2]: one.Robot for one in (sim_cozmo, sim_ebo, sim_ev3, sim_thymio)
}
SPEEDS = (150, 400, 1e308)
#: The usual floor's slip and the differences between wheels.
FLOOR = 0.015

twins = pytest.mark.parametrize("twin", TWINS.values(), ids=TWINS)
speeds = pytest.mark.parametrize("speed", SPEEDS)


@pytest.fixture
def on_floor():
    """A twin on an empty floor, which is disconnected at the end."""
    connected = []

    def make(twin):
        connected.append(twin(world="empty"))
        return connected[-1]

    yield make
    for robot in connected:
        robot.stop()


@twins
@pytest.mark.parametrize("speed", [80, 200, *SPEEDS])
@pytest.mark.parametrize("distance", [300, -300])
def test_a_distance_is_the_same_at_every_speed(on_floor, twin, distance, speed):
    robot = on_floor(twin)
    start = robot.where()
    robot.drive_distance(distance, speed)
    robot.sleep(0.5)

    assert robot.get_pose()[0] == pytest.approx(distance, abs=1.5)
    assert math.dist(start[:2], robot.where()[:2]) == pytest.approx(300, rel=FLOOR, abs=1)


@twins
@speeds
@pytest.mark.parametrize("angle", [90, -90])
def test_a_turn_is_the_same_at_every_speed(on_floor, twin, angle, speed):
    robot = on_floor(twin)
    robot.turn(angle, speed)
    robot.sleep(0.5)

    assert robot.get_pose()[2] == pytest.approx(angle, abs=1.5)


@twins
@speeds
@pytest.mark.parametrize("angle", [120, -120])
def test_an_arc_is_the_same_at_every_speed(on_floor, twin, angle, speed):
    robot = on_floor(twin)
    robot.drive_arc(150, angle, speed)
    robot.sleep(0.5)

    x, y = 150 * math.sin(math.radians(120)), 150 * (1 - math.cos(math.radians(120)))
    assert robot.get_pose()[:2] == pytest.approx((x, -math.copysign(y, angle)), abs=5)


@twins
@speeds
def test_a_place_is_reached_at_every_speed(on_floor, twin, speed):
    robot = on_floor(twin)
    robot.go_to(200, 150, speed)
    robot.sleep(0.5)

    assert robot.get_pose()[:2] == pytest.approx((200, 150), abs=3)


@settings(max_examples=40)
@given(
    st.lists(
        st.tuples(
            st.floats(-2000, 2000) | st.sampled_from([1e308, -1e308]),
            st.floats(-1000, 1000) | st.sampled_from([1e308]),
            st.integers(0, 60),
        ),
        max_size=6,
    )
)
def test_a_reckoned_pose_is_where_the_wheels_have_gone(commands):
    with sim_ebo.Robot(world="empty") as robot:
        for adv, rot, steps in commands:
            robot.set_move(adv, rot)
            robot.sleep(steps / 100)

        assert robot.get_pose() == pytest.approx(robot.body.odometry, abs=1e-3)
