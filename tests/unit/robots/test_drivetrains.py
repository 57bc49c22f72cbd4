"""What the wheels of real robots can do, as their drivers say."""

import pytest

from learnblock import robots
from learnblock.robots.ev3 import Settings
from learnblock.robots.wheel_counts import motor_speeds
from learnblock.wheels import wheel_speeds


@pytest.fixture(autouse=True)
def home(tmp_path, monkeypatch):
    monkeypatch.setenv("LEARNBLOCK_HOME", str(tmp_path))


@pytest.mark.parametrize(
    "name", ["cozmo", "create3", "ebo", "ev3", "legoed", "root", "spike", "thymio"]
)
def test_a_robot_can_do_about_what_its_twin_can(name):
    real, twin = (robots.find(one).load().drivetrain() for one in (name, f"sim-{name}"))

    assert real is not None
    assert twin is not None
    assert real.track == pytest.approx(twin.track, rel=0.02)
    assert real.maximum_speed == pytest.approx(twin.maximum_speed, rel=0.02)


def test_a_robot_whose_pose_is_reckoned_speeds_up_like_its_twin():
    assert robots.find("ebo").load().drivetrain() == robots.find("sim-ebo").load().drivetrain()


def test_a_robot_of_other_sizes_has_other_limits():
    kind = robots.find("ev3").load()
    small = kind.drivetrain_for(Settings(wheel_radius=15.0))

    assert small.maximum_speed == pytest.approx(kind.drivetrain().maximum_speed / 2)


def test_a_curve_that_an_ev3_is_too_slow_for_stays_the_same_curve():
    settings = Settings()
    drivetrain = robots.find("ev3").load().drivetrain_for(settings)
    sent = motor_speeds(*drivetrain.reachable(900, 90), settings.wheel_radius, settings.track)
    left, right = wheel_speeds(900, 90, settings.track)

    assert max(sent) <= settings.full_speed + 1e-6
    assert sent[0] / sent[1] == pytest.approx(left / right)
