import pytest
from hypothesis import given
from hypothesis import strategies as st

from learnblock.wheels import Drivetrain, accelerated, body_speeds, limited, wheel_speeds

speeds = st.floats(-1000, 1000)


def test_turning_right_runs_the_left_wheel_forward() -> None:
    left, right = wheel_speeds(0, 90, track=100)

    assert right < 0 < left


@given(speeds, speeds)
def test_wheel_speeds_have_their_inverse(adv: float, rot: float) -> None:
    assert body_speeds(wheel_speeds(adv, rot, 95), 95) == pytest.approx((adv, rot), abs=1e-9)


@given(speeds, speeds)
def test_limiting_keeps_the_curve_and_the_limit(left: float, right: float) -> None:
    slower = limited((left, right), 167)

    assert max(map(abs, slower)) <= 167 + 1e-9
    assert slower[0] * right == pytest.approx(slower[1] * left, abs=1e-6)


@given(st.floats(allow_nan=False, allow_infinity=False), speeds)
def test_every_command_is_reached_as_far_as_the_wheels_can(adv: float, rot: float) -> None:
    drivetrain = Drivetrain(track=95, maximum_speed=167)

    assert max(map(abs, drivetrain.wheels(adv, rot))) <= 167
    assert max(map(abs, drivetrain.wheels(rot, adv))) <= 167


@given(speeds, speeds)
def test_a_command_beyond_the_wheels_keeps_its_curve(adv: float, rot: float) -> None:
    slower = Drivetrain(track=95, maximum_speed=167).reachable(adv, rot)

    assert slower[0] * rot == pytest.approx(slower[1] * adv, abs=1e-6)


@given(st.tuples(speeds, speeds), st.tuples(speeds, speeds), st.floats(1, 100))
def test_acceleration_is_bounded_and_arrives(
    now: tuple[float, float], target: tuple[float, float], change: float
) -> None:
    steps = 0
    while now != target:
        after = accelerated(now, target, change)
        assert max(abs(a - b) for a, b in zip(now, after, strict=True)) <= change + 1e-9
        now, steps = after, steps + 1
        assert steps <= 2002
