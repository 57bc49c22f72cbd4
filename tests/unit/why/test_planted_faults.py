"""Faults planted into examples and lessons: answers name the line among their first four sentences.

The plain questions were written before anyone looked at how questions are understood. Then the
short ones found 32 of 46, English ones 19 and Spanish ones 12; `scripts/bench why` counts them all.
"""

import pytest

from planted_faults import WAYS, planted_faults, tries

FAULTS = planted_faults()


def test_there_are_enough_faults_of_examples_and_lessons_on_all_twins():
    assert len(FAULTS) >= 40
    assert len({fault.name for fault in FAULTS}) == len(FAULTS)
    assert {fault.robot for fault in FAULTS} == {"sim-ebo", "sim-cozmo", "sim-thymio", "sim-ev3"}
    assert {fault.source.split("/")[0] for fault in FAULTS} == {"examples", "lessons"}


@pytest.mark.sample(5)
@pytest.mark.parametrize("fault", FAULTS, ids=[one.name.replace(" ", "-") for one in FAULTS])
def test_the_line_of_a_fault_is_named_however_it_is_asked(fault, tmp_path):
    found = {one.way: one.lines for one in tries(fault, tmp_path) if one.is_found}
    assert {*found} == {*WAYS}
