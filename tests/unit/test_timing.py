"""The clock of a driver's threads, and deadlines."""

import re
import threading

import pytest

from learnblock.testing import ManualClock
from learnblock.timing import MONOTONIC, Deadline
from places import ROOT


def test_a_deadline_is_over_when_its_time_has_come_and_not_before():
    clock = ManualClock()
    deadline = Deadline.after(2, clock)
    clock.advance(1.999)
    assert not deadline.is_over
    clock.advance(0.001)
    assert deadline.is_over


def test_a_deadline_has_less_and_less_time_left_and_then_none():
    clock = ManualClock()
    deadline = Deadline.after(2, clock)
    left = []
    for _ in range(3):
        clock.advance(1.5)
        left.append(deadline.left)
    assert left == [0.5, 0, 0]


def test_a_deadline_is_a_value():
    clock = ManualClock()
    assert Deadline.after(1, clock) == Deadline(clock, 1.0)


def test_the_computers_clock_waits_for_an_event_and_for_a_condition():
    event, condition = threading.Event(), threading.Condition()
    assert not MONOTONIC.wait(event, 0)
    event.set()
    assert MONOTONIC.wait(event, 60)
    with condition:
        assert MONOTONIC.wait_for(condition, event.is_set, 60)
        assert not MONOTONIC.wait_for(condition, lambda: False, 0)


def test_the_computers_clock_runs_by_itself():
    before = MONOTONIC.now()
    MONOTONIC.sleep(0.001)
    MONOTONIC.sleep(-1)
    assert before + 0.001 <= MONOTONIC.now()


@pytest.mark.parametrize("folder", ["robots", "ice", "perception"])
def test_no_driver_takes_the_time_from_anywhere_but_its_clock(folder):
    files = (ROOT / "src" / "learnblock" / folder).rglob("*.py")
    taken = re.compile(r"\b(?:import time|from time import|perf_counter|Event\(\)\.wait)\b")
    found = {str(file.relative_to(ROOT)) for file in files if taken.search(file.read_text())}
    # It runs on the brick, where nothing else of LearnBlock is, and has the same clock.
    assert found <= {"src/learnblock/robots/ev3/agent.py"}
