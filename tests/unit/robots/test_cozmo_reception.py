"""The share of Cozmo's reports that arrive."""

import pytest

from learnblock.robots.cozmo.reception import PERIOD, Reception


def received(numbers):
    """The reception after the reports of these numbers."""
    reception = Reception()
    for number in numbers:
        reception.note(number * PERIOD)
    return reception


def test_the_quality_is_unknown_at_first():
    assert received(range(5)).quality is None


def test_the_quality_is_1_while_every_report_arrives():
    assert received(range(100)).quality == pytest.approx(1)


def test_the_quality_is_the_share_of_the_reports_that_arrive():
    assert received(range(0, 100, 2)).quality == pytest.approx(0.5, abs=0.02)


def test_a_restarted_robot_is_counted_anew():
    reception = received(range(1000, 1100))
    reception.note(0)
    assert reception.quality is None
