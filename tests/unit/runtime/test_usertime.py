import threading
import time

import pytest

from learnblock.runtime.usertime import use_robot_time
from learnblock.testing import VirtualClock

NAMES = ("sleep", "time", "monotonic", "perf_counter", "time_ns", "monotonic_ns", "perf_counter_ns")


@pytest.fixture(autouse=True)
def originals():
    before = [getattr(time, name) for name in NAMES]
    yield
    assert before == [getattr(time, name) for name in NAMES]


@pytest.fixture
def clock():
    return VirtualClock()


def test_a_programs_sleep_uses_the_robots_time(clock):
    restore = use_robot_time(clock)
    time.sleep(3600)
    restore()
    assert clock.time() == 3600


def test_all_clocks_of_a_program_show_the_robots_time(clock):
    restore = use_robot_time(clock)
    clock.sleep(1.5)
    seconds = [time.time(), time.monotonic(), time.perf_counter()]
    nanoseconds = [time.time_ns(), time.monotonic_ns(), time.perf_counter_ns()]
    restore()
    assert seconds == [1.5] * 3
    assert nanoseconds == [1_500_000_000] * 3


def test_reading_the_time_takes_time():
    class Priced(VirtualClock):
        charges = 0

        def charge(self):
            self.charges += 1

    clock = Priced()
    restore = use_robot_time(clock)
    time.time()
    restore()
    assert clock.charges == 1


def test_a_negative_sleep_is_still_an_error(clock):
    restore = use_robot_time(clock)
    with pytest.raises(ValueError, match="sleep length must be non-negative"):
        time.sleep(-1)
    restore()


def in_a_thread(function):
    results = []
    thread = threading.Thread(target=lambda: results.append(function()))
    thread.start()
    thread.join(5)
    return results[0]


def test_other_threads_keep_the_wall_clock(clock):
    restore = use_robot_time(clock)
    other = in_a_thread(time.time)
    restore()
    assert other > 10**9


def test_two_threads_have_separate_clocks_whichever_ends_first():
    first, second = VirtualClock(), VirtualClock()
    first.sleep(1)
    second.sleep(2)
    restore_first = use_robot_time(first)

    def other():
        restore_second = use_robot_time(second)
        inside = time.time()
        restore_first()
        still = time.time()
        restore_second()
        return inside, still

    assert in_a_thread(other) == (2.0, 2.0)
    assert time.time() > 10**9


def test_undoing_twice_is_harmless(clock):
    restore = use_robot_time(clock)
    restore()
    restore()
    assert time.time() > 10**9


def test_of_two_clocks_in_one_thread_the_newer_one_is_used(clock):
    newer = VirtualClock()
    newer.sleep(5)
    restore_older, restore_newer = use_robot_time(clock), use_robot_time(newer)
    assert time.time() == 5.0
    restore_newer()
    assert time.time() == 0.0
    restore_older()
