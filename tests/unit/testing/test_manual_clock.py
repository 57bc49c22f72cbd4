"""A clock on which the threads of a driver wait until a test lets time pass."""

import threading
from contextlib import contextmanager

import pytest

from learnblock.testing import ManualClock

CLOSED = "closed"


class Beat:
    """A thread that notes the time of each of its beats."""

    def __init__(self, clock, period):
        self.times = []
        self._clock, self._period = clock, period
        self._over = threading.Event()
        self.thread = threading.Thread(target=self._run, daemon=True)
        self.thread.start()

    def close(self):
        self._over.set()
        self.thread.join()

    def _run(self):
        while not self._clock.wait(self._over, self._period):
            self.times.append(self._clock.now())


@contextmanager
def beating(clock, *periods):
    beats = [Beat(clock, period) for period in periods]
    clock.block_until(len(beats))
    try:
        yield beats
    finally:
        for beat in beats:
            beat.close()


def test_a_thread_is_woken_at_exactly_its_times():
    clock = ManualClock()
    with beating(clock, 0.1) as [beat]:
        clock.advance(0.35)
        assert beat.times == [0.1, 0.2, 0.3]
        clock.advance(0.05)
    assert beat.times == [0.1, 0.2, 0.3, 0.4]


def test_no_time_passes_by_itself():
    clock = ManualClock()
    with beating(clock, 0.001) as [beat]:
        assert (clock.now(), beat.times) == (0, [])


def test_several_threads_are_woken_in_the_order_of_their_times():
    clock = ManualClock()
    with beating(clock, 0.2, 0.3) as [two, three]:
        clock.advance(0.6)
    assert (two.times, three.times) == ([0.2, 0.4, 0.6], [0.3, 0.6])


def test_an_event_ends_a_wait_without_time_passing():
    clock, event, waited = ManualClock(), threading.Event(), []
    thread = threading.Thread(target=lambda: waited.append(clock.wait(event, 60)))
    thread.start()
    clock.block_until(1)
    event.set()
    thread.join()
    assert (waited, clock.now()) == ([True], 0)


@pytest.mark.parametrize("holds", [True, False])
def test_waiting_for_a_condition_ends_when_it_holds_or_its_time_has_come(holds):
    clock, condition, states, waited = ManualClock(), threading.Condition(), [], []

    def wait():
        with condition:
            waited.append(clock.wait_for(condition, lambda: CLOSED in states, 2))

    thread = threading.Thread(target=wait)
    thread.start()
    clock.block_until(1)
    if holds:
        with condition:
            states.append(CLOSED)
            condition.notify_all()
    else:
        clock.advance(2)
    thread.join()
    assert waited == [holds]


def test_a_call_that_waits_is_run_to_its_end_at_once():
    clock = ManualClock()

    def count():
        for _ in range(1000):
            clock.sleep(3.6)
        return "done"

    assert clock.run(count) == "done"
    assert clock.now() == 3600


def test_the_error_of_a_call_is_raised():
    clock = ManualClock()

    def fail():
        clock.sleep(1)
        raise ZeroDivisionError

    with pytest.raises(ZeroDivisionError):
        clock.run(fail)
    assert clock.now() == 1


def test_other_threads_have_their_time_while_a_call_runs():
    clock = ManualClock()
    with beating(clock, 0.25) as [beat]:
        clock.run(lambda: clock.sleep(1))
        assert beat.times[:3] == [0.25, 0.5, 0.75]


def test_waiting_for_no_time_returns_at_once():
    clock = ManualClock()
    clock.sleep(0)
    clock.sleep(-1)
    assert not clock.wait(threading.Event(), 0)
