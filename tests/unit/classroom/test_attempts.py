"""How often somebody may be wrong."""

import pytest

from clocks import Clock
from learnblock.classroom.attempts import Attempts, TooManyAttemptsError


@pytest.fixture
def clock():
    return Clock(100.0)


@pytest.fixture
def attempts(clock):
    return Attempts(free=2, pause=10.0, longest=60.0, now=clock)


def fail(attempts, times, key="ana"):
    for _ in range(times):
        attempts.failed(key)


def test_the_first_mistakes_are_free(attempts):
    fail(attempts, 2)
    attempts.require("ana")


def test_one_more_has_to_wait(attempts, clock):
    fail(attempts, 3)
    with pytest.raises(TooManyAttemptsError) as refused:
        attempts.require("ana")
    assert refused.value.phrase.values == {"seconds": 11}
    clock.time += 10
    attempts.require("ana")


def test_each_further_mistake_doubles_the_wait_up_to_a_limit(attempts, clock):
    fail(attempts, 4)
    clock.time += 19
    with pytest.raises(TooManyAttemptsError):
        attempts.require("ana")
    clock.time += 1
    attempts.require("ana")
    fail(attempts, 20)
    clock.time += 60
    attempts.require("ana")


def test_others_do_not_wait(attempts):
    fail(attempts, 5)
    attempts.require("leo")


def test_success_forgets_mistakes(attempts):
    fail(attempts, 2)
    attempts.succeeded("ana")
    fail(attempts, 2)
    attempts.require("ana")


def test_time_forgets_mistakes(attempts, clock):
    fail(attempts, 3)
    clock.time += 10 + 61
    attempts.require("ana")
    fail(attempts, 2)
    attempts.require("ana")


def test_memory_for_names_is_bounded(attempts):
    for number in range(5000):
        attempts.failed(str(number))
    assert len(attempts._mistakes) == 1000
