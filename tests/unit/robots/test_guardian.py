"""A guardian acts when its driver has ended, or half a second after its last sign of life."""

import pytest

from learnblock.robots.guardian import STEP, wait_for_silence


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


def stopped_after(driver):
    """Return when a guardian stops the motors, in seconds."""
    wait_for_silence(driver.hear)
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


def test_a_driver_that_ends_is_not_waited_for():
    assert stopped_after(Driver(0, 2, ends=3)) == pytest.approx(3 * STEP)
