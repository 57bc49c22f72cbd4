"""Turns of a loop that are alike are counted, and nothing else is lost."""

import json
from random import Random

import pytest

from learnblock.runtime.turns import LONGEST_COUNT, CountedSteps


class Written:
    """What has been written, and what it says."""

    def __init__(self):
        self.lines = []
        self.steps = CountedSteps(lambda time, text: self.lines.append((time, text)))

    def take(self, steps, period=0.001):
        for number, step in enumerate(steps):
            self.steps.step(number * period, f'"line":{step}')
        self.steps.end()
        return self

    @property
    def expanded(self):
        return [step for line in self._expanded(len(self.lines)) for step in line]

    def _expanded(self, count):
        """For each line, the steps that it says."""
        said = []
        for _, text in self.lines[:count]:
            line = json.loads(f"{{{text}}}")
            if "line" in line:
                said.append([line["line"]])
            else:
                turn = [step for one in said[-line["repeated"] :] for step in one]
                said.append(turn * line["times"])
        return said


@pytest.fixture
def written():
    return Written()


def test_turns_that_are_alike_are_counted(written):
    written.take([1, 2, 3] * 100)
    assert [text for _, text in written.lines[-1:]] == ['"repeated":3,"times":98']
    assert len(written.lines) == 7


def test_the_time_of_a_count_is_that_of_its_last_step(written):
    written.take([1, 2] * 10)
    assert written.lines[-1][0] == pytest.approx(0.019)


def test_a_loop_in_a_loop_is_counted_as_well(written):
    written.take(([0] + [1, 2] * 5 + [3]) * 50)
    assert len(written.lines) < 30
    assert written.expanded == ([0] + [1, 2] * 5 + [3]) * 50


def test_a_turn_that_becomes_another_one_is_written_in_full(written):
    steps = [1, 2, 3, 4] * 5 + [1, 2, 9]
    assert written.take(steps).expanded == steps


def test_after_something_else_has_happened_no_count_reaches_behind_it(written):
    for _ in range(3):
        written.take([1, 2] * 3)
    assert [text for _, text in written.lines].count('"repeated":2,"times":1') == 3


def test_a_count_is_written_once_a_second(written):
    written.take([1, 2] * 2000, period=0.001)
    counts = [time for time, text in written.lines if "repeated" in text]
    assert counts == pytest.approx([1, 2, 3, 4], abs=2 * LONGEST_COUNT / 100)


@pytest.mark.parametrize("seed", range(200))
def test_whatever_a_program_does_can_be_read_again(seed):
    random = Random(seed)  # noqa: S311 - the same programs each time

    def block(depth):
        steps = []
        for _ in range(random.randint(1, 5)):
            if depth and random.random() < 0.5:
                steps += block(depth - 1) * random.randint(1, 6)
            else:
                steps.append(random.randint(1, 4))
        return steps

    steps = block(4)
    assert Written().take(steps).expanded == steps
