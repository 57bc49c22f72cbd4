"""Measurements correct the size of a robot's wheels."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from learnblock.robots.calibration import ANGLE, DISTANCE, Calibration
from learnblock.robots.ev3 import Settings
from learnblock.robots.thymio import ThymioSettings

EV3 = Calibration(distance="wheel_radius", angle="track")

sizes = st.floats(0.8, 1.25)


def driven(believed, radius, track):
    """Return what a robot with these wheels drives and turns, which it believes to be others."""
    distance = DISTANCE / believed["wheel_radius"] * radius
    arc = math.radians(ANGLE) * believed["track"] / 2 / believed["wheel_radius"] * radius
    return distance, math.degrees(arc / (track / 2))


@given(sizes, sizes)
def test_the_corrected_robot_drives_and_turns_as_told(wheels, apart):
    believed = {"wheel_radius": 30.0, "track": 120.0}
    real = 30 * wheels, 120 * apart
    corrected = EV3.corrected(Settings(**believed), *driven(believed, *real))
    # Settings are rounded to thousandths.
    assert driven(corrected, *real) == pytest.approx((DISTANCE, ANGLE), rel=1e-4)


def test_a_robot_that_drives_and_turns_as_told_keeps_its_settings():
    assert EV3.corrected(Settings()) == {"wheel_radius": 30.0, "track": 120.0}


def test_only_the_turn_is_measured():
    assert EV3.corrected(Settings(), angle=300) == {"wheel_radius": 30.0, "track": 144.0}


def test_a_thymio_that_drives_too_far_has_a_larger_speed_unit():
    corrected = Calibration("speed_unit", "track").corrected(ThymioSettings(), distance=550)
    assert corrected == {"speed_unit": pytest.approx(0.365, abs=1e-3), "track": 103.4}
