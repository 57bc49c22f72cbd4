import os
import threading
import time
from itertools import count
from pathlib import Path

import pytest

from learnblock.runtime.activity import (
    LONGEST_LOOK,
    Activity,
    Allowance,
    Silence,
    of_process,
    of_thread,
)


@pytest.fixture
def silence():
    silence = Silence()
    silence.begin(Activity(10.0, waits=False))
    return silence


def test_computing_counts_in_processor_time(silence):
    silence.look(0.1, Activity(10.03, waits=False))
    assert silence.computing == pytest.approx(0.03)
    assert silence.waiting == 0


def test_waiting_counts_in_time_of_the_wall(silence):
    silence.look(0.05, Activity(10.0, waits=True))
    assert (silence.computing, silence.waiting) == (0, 0.05)


def test_a_program_that_waits_for_a_processor_is_not_silent(silence):
    for _ in range(10_000):
        silence.look(LONGEST_LOOK, Activity(10.0, waits=False))
    assert (silence.computing, silence.waiting) == (0, 0)


def test_a_host_that_could_not_look_counts_no_more_than_a_look(silence):
    silence.look(60, Activity(10.0, waits=True))
    assert silence.waiting == LONGEST_LOOK


def test_a_call_begins_anew(silence):
    silence.look(0.1, Activity(14.0, waits=False))
    silence.begin(Activity(15.0, waits=False))
    silence.look(0.1, Activity(15.5, waits=False))
    assert silence.computing == 0.5


def test_where_the_system_does_not_say_all_time_counts_as_computing():
    silence = Silence()
    silence.begin(None)
    silence.look(0.05, None)
    assert (silence.computing, silence.waiting) == (0.05, 0)


@pytest.mark.skipif(not Path("/proc/self/stat").exists(), reason="needs Linux")
def test_a_process_tells_its_processor_time():
    before = of_process(os.getpid())
    while time.process_time() < before.processor + 0.05:
        pass
    after = of_process(os.getpid())
    assert after.processor > before.processor
    assert not after.waits


def test_a_process_that_has_ended_tells_nothing():
    assert of_process(0) is None


@pytest.mark.skipif(not hasattr(time, "pthread_getcpuclockid"), reason="needs POSIX clocks")
def test_a_thread_tells_its_processor_time():
    before = of_thread(threading.get_ident())
    sum(range(10_000))
    assert of_thread(threading.get_ident()).processor > before.processor


def looked_at(activities, seconds, longest=1000.0):
    """An allowance after a look every 0.1 s at what a process does."""
    given, times = iter(activities), (look / 10 for look in count())
    allowance = Allowance(seconds, longest, lambda: next(given), lambda: next(times))
    for _ in activities[1:]:
        allowance.look()
    return allowance


def test_an_allowance_passes_while_a_process_computes_and_while_it_waits():
    activities = [Activity(0.0, False), Activity(0.1, False), Activity(0.1, True)]
    assert looked_at(activities, 0.15).is_spent
    assert not looked_at(activities, 0.25).is_over


def test_an_allowance_does_not_pass_while_a_process_waits_for_a_processor():
    assert not looked_at([Activity(0.0, False)] * 5000, 0.1).is_over


def test_an_allowance_on_a_machine_that_is_too_busy_is_over_and_not_spent():
    allowance = looked_at([Activity(0.0, False)] * 50, 0.1, longest=4.0)
    assert (allowance.is_over, allowance.is_spent) == (True, False)
