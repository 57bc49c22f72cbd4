import pytest
from hypothesis import given
from hypothesis import strategies as st

from learnblock.runtime.lockstep import ACCESSES_PER_STEP, LockStepClock


class World:
    def __init__(self, steps=0):
        self.steps, self.waits = steps, []

    def wait(self, steps):
        self.waits.append(steps)
        self.steps += steps
        return self.steps


def clock_of(world, dt=0.01):
    return LockStepClock(world.wait, world.steps, dt)


@pytest.mark.parametrize(
    ("seconds", "steps"),
    [(0.01, 1), (0.02, 2), (0.025, 3), (0.001, 1), (1e-12, 1), (0.07, 7), (0.29, 29), (5, 500)],
)
def test_a_sleep_ends_with_the_step_that_contains_its_end(seconds, steps):
    world = World()
    clock_of(world).sleep(seconds)
    assert world.waits == [steps]


@pytest.mark.parametrize("seconds", [0, -1, -0.0])
def test_a_sleep_that_is_not_positive_does_not_wait(seconds):
    world = World()
    clock_of(world).sleep(seconds)
    assert world.waits == []


@given(st.integers(1, 10**6))
def test_a_whole_number_of_steps_is_exact(steps):
    world = World()
    clock_of(world).sleep(steps * 0.01)
    assert world.waits == [steps]


def test_the_time_starts_with_the_program_and_has_no_rounding_errors():
    world = World(steps=250)
    clock = clock_of(world)
    assert clock.time() == 0
    times = []
    for _ in range(7):
        clock.sleep(0.01)
        times.append(clock.time())
    assert times == [0.01, 0.02, 0.03, 0.04, 0.05, 0.06, 0.07]


def test_a_number_of_accesses_take_one_step():
    world = World()
    clock = clock_of(world)
    for _ in range(3 * ACCESSES_PER_STEP):
        clock.charge()
    assert world.waits == [1, 1, 1]


def test_a_sleep_includes_the_time_of_earlier_accesses():
    world = World()
    clock = clock_of(world)
    for _ in range(5):
        for _ in range(ACCESSES_PER_STEP - 1):
            clock.charge()
        clock.sleep(0.05)
    assert world.waits == [5] * 5


def test_the_instant_is_the_step_at_which_the_program_woke():
    world = World(steps=4)
    clock = clock_of(world)
    assert clock.instant == 4
    clock.sleep(0.03)
    assert clock.instant == 7
