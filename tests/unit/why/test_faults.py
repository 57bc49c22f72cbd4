"""Programs with a planted fault: the answer names its line among the first three.

Of 98, written before anyone looked at their answers, 81 were found at first (36 of 42, then 17 of
20, 15 of 20 and 13 of 16); after each set the rules were mended. Then came 14 with loops whose
count is wrong, for a rule that was missing.
"""

import tomllib

import pytest

from learnblock.i18n import languages
from learnblock.why.answers import answer
from learnblock.why.parser import parse
from learnblock.why.sentences import FIRST
from logged_runs import logged_text
from places import ROOT

FAULTS = tomllib.loads((ROOT / "tests/cases/why/faults.toml").read_text("utf-8"))["fault"]


def names_of_twins():
    return {fault["robot"] for fault in FAULTS}


def test_there_are_enough_faults_on_all_twins():
    assert len(FAULTS) >= 40
    assert len({fault["name"] for fault in FAULTS}) == len(FAULTS)
    assert names_of_twins() == {"sim-ebo", "sim-cozmo", "sim-thymio", "sim-ev3"}


@pytest.mark.sample(25)
@pytest.mark.parametrize("fault", FAULTS, ids=lambda fault: fault["name"].replace(" ", "-"))
def test_the_line_of_a_fault_is_named_among_the_first_three(fault, tmp_path):
    options = {"world": fault.get("world", "empty"), "seconds": fault.get("seconds", 15)}
    run = logged_text(tmp_path, fault["program"], fault["robot"], seed=0, **options)
    given = answer(run.history, parse(fault["question"], run.history))
    assert len(given.sentences) <= FIRST
    assert all(all(given.words(language)) for language in languages())
    assert fault["line"] in given.lines[:3]
