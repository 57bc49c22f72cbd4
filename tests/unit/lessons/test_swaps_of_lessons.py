"""The checks of our lessons notice programs that do the right things at the wrong time or side."""

import random
from fnmatch import fnmatchcase
from functools import cache

import pytest

from gate import IS_GATE
from learnblock.lessons.reading import shipped
from learnblock.lessons.swaps import swaps
from learnblock.running.batch import WarmProcess
from lesson_tries import read_once as opened
from lesson_tries import unnoticed
from right_programs import is_right, known

#: The gate tries so many programs of a step, the same each time.
FEW = 3
#: With `--all`, so many are drawn at random; a run of this file alone tries all, for half an hour.
DRAWN = 6

STEPS = [
    (name, number)
    for name in shipped()
    for number, step in enumerate(opened(name).lesson.step, 1)
    if step.check and opened(name).solution(number) is not None
]


@pytest.fixture(scope="module")
def runs():
    """The process that makes all runs: it starts once."""
    kept = WarmProcess()
    yield kept
    kept.end()


@cache
def swapped(name, step):
    """The programs of a step with two parts swapped."""
    return [mutant for _, mutant in swaps(opened(name).solution(step))]


def made(name, step):
    """The programs of a step that have to fail."""
    return [one for one in swapped(name, step) if not is_right("swaps", name, step, one.what)]


@pytest.mark.sample(3)
@pytest.mark.slow
@pytest.mark.spread
@pytest.mark.timeout(900)  # all programs of a step are up to a hundred runs of a minute each
@pytest.mark.parametrize(("name", "step"), STEPS)
def test_a_program_with_two_parts_swapped_fails_a_check_or_is_listed_as_right(
    runs, request, name, step
):
    programs = _some(made(name, step), request.config)
    found = [one.what for one in unnoticed(opened(name), step, programs, runs)]
    assert found == []


def _some(programs, config):
    """Return those of the programs that this tier of the tests tries."""
    if config.stash[IS_GATE]:
        return programs[:: max(1, len(programs) // FEW)]
    if config.option.all:
        return random.sample(programs, min(DRAWN, len(programs)))
    return programs


@pytest.mark.parametrize("right", known("swaps"), ids=lambda right: right["lesson"])
def test_each_difference_that_is_listed_as_right_is_one_that_is_made(right):
    steps = (
        [right["step"]] if "step" in right else [n for name, n in STEPS if name == right["lesson"]]
    )
    found = [one.what for step in steps for one in swapped(right["lesson"], step)]
    for pattern in right["what"]:
        assert any(fnmatchcase(what, pattern) for what in found), pattern
