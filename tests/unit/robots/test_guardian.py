"""A guardian acts when its driver has ended, or half a second after its last sign of life."""

import signal
import subprocess
import sys
import threading

import pytest

from learnblock.errors import RobotConnectionError
from learnblock.robots.guardian import (
    PATIENCE,
    PAUSE,
    PERIOD,
    STEP,
    TRIES_FOR,
    SignsOfLife,
    insist_on,
    is_busy,
    wait_for_silence,
)
from learnblock.testing import ManualClock
from waiting import wait_for


class Driver:
    """A driver in virtual time, which is silent after its last sign of life.

    Args:
        signs: when it gives signs of life, in steps of the guardian.
        ends: when it ends, in steps; None if it freezes.
    """

    def __init__(self, *signs, ends=None):
        self.steps = 0
        self._signs = signs
        self._ends = ends

    def hear(self, seconds):
        assert seconds == STEP
        if self._ends is not None and self.steps >= self._ends:
            return b""
        if self._signs and self._signs[0] <= self.steps:
            self._signs = self._signs[1:]
            return b"."
        self.steps += 1
        return None


def stopped_after(driver, *, busy_until=0.0):
    """Return when a guardian stops the motors, in seconds."""
    wait_for_silence(driver.hear, lambda: driver.steps * STEP < busy_until)
    return driver.steps * STEP


@pytest.mark.parametrize("last", [0, 2, 40])
def test_the_motors_stop_half_a_second_after_the_last_sign_of_life(last):
    assert stopped_after(Driver(*range(0, last + 1, 2))) == pytest.approx(last * STEP + 0.5)


def test_a_driver_that_starts_without_a_sign_of_life_is_waited_for_half_a_second():
    assert stopped_after(Driver()) == pytest.approx(0.5)


@pytest.mark.parametrize("gap", [1, 5, 9])
def test_a_driver_that_is_late_but_not_silent_for_half_a_second_drives_on(gap):
    signs = range(0, 100, gap)
    assert stopped_after(Driver(*signs)) == pytest.approx(signs[-1] * STEP + 0.5)


def test_a_driver_that_computes_drives_on_and_may_freeze_later():
    assert stopped_after(Driver(0, 38), busy_until=2.0) == pytest.approx(1.9 + 0.5)


@pytest.mark.parametrize("busy", [0.6, 1.3, 1.9])
def test_a_driver_that_freezes_while_it_computes_is_stopped_at_once(busy):
    assert stopped_after(Driver(), busy_until=busy) == pytest.approx(busy)


def test_a_driver_that_computes_for_ever_is_stopped_after_two_seconds():
    assert stopped_after(Driver(), busy_until=60) == pytest.approx(2)


@pytest.mark.skipif(sys.platform != "linux", reason="reads the states of threads")
def test_a_process_that_computes_is_busy_until_it_is_stopped():
    computing = subprocess.Popen([sys.executable, "-c", "while True: pass"])
    try:
        wait_for(lambda: is_busy(computing.pid), "it computes")
        computing.send_signal(signal.SIGSTOP)
        wait_for(lambda: not is_busy(computing.pid), "it is stopped")
    finally:
        computing.kill()
        computing.wait()
    assert not is_busy(computing.pid)


def test_a_driver_that_ends_is_not_waited_for():
    assert stopped_after(Driver(0, 2, ends=3)) == pytest.approx(3 * STEP)


# A guardian that has to stop the motors.


class Motors:
    """Motors that can be reached at some time, and the times at which it was tried."""

    def __init__(self, clock, *, from_then=None, takes=0.0):
        self.tried = []
        self._clock, self._from_then, self._takes = clock, from_then, takes

    def halt(self):
        self.tried.append(self._clock.now())
        self._clock.sleep(self._takes)
        if self._from_then is None or self._clock.now() < self._from_then:
            raise RobotConnectionError("ev3-closed", place="here")


def test_it_tries_again_until_its_time_is_over_and_then_gives_up():
    clock = ManualClock()
    motors = Motors(clock)
    assert not clock.run(lambda: insist_on(motors.halt, clock))
    assert clock.now() == TRIES_FOR
    assert motors.tried == pytest.approx([PAUSE * count for count in range(50)])


def test_it_begins_no_attempt_after_its_time_however_long_one_takes():
    clock = ManualClock()
    motors = Motors(clock, takes=0.5)
    assert not clock.run(lambda: insist_on(motors.halt, clock))
    assert motors.tried == pytest.approx([0.6 * count for count in range(9)])


def test_it_ends_once_the_motors_have_stopped():
    clock = ManualClock()
    motors = Motors(clock, from_then=1.0)
    assert clock.run(lambda: insist_on(motors.halt, clock))
    assert clock.now() == pytest.approx(1.0)


# The driver's signs of life.


class Pipe:
    """A pipe to a guardian that reads until it freezes."""

    def __init__(self, clock):
        self.written = []
        self.is_closed = False
        self.is_frozen = False
        self.thawed = threading.Event()
        self._clock = clock

    def write(self, data):
        if self.is_frozen:
            self._clock.wait(self.thawed, 1000)
        self.written.append(self._clock.now())

    def close(self):
        self.is_closed = True


@pytest.fixture
def clock():
    return ManualClock()


@pytest.fixture
def pipe(clock):
    pipe = Pipe(clock)
    yield pipe
    pipe.thawed.set()


def test_a_driver_gives_signs_of_life_at_exactly_their_period(clock, pipe):
    signs = SignsOfLife(pipe, clock)
    clock.block_until(1)
    clock.advance(0.55)
    signs.end()
    assert pipe.written == pytest.approx([PERIOD * count for count in range(1, 6)])


def test_a_driver_that_ends_gives_no_more_signs_and_waits_for_nothing(clock, pipe):
    signs = SignsOfLife(pipe, clock)
    clock.block_until(1)
    signs.end()
    signs.end()
    clock.advance(1)
    assert (pipe.written, pipe.is_closed, signs.are_over) == ([], True, True)


def test_a_driver_waits_for_a_frozen_guardian_as_long_as_its_patience(clock, pipe):
    signs = SignsOfLife(pipe, clock)
    clock.block_until(1)
    pipe.is_frozen = True
    clock.advance(PERIOD)
    clock.run(signs.end)
    assert clock.now() == pytest.approx(PERIOD + PATIENCE)
    assert pipe.is_closed
