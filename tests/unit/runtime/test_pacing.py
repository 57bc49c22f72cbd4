import threading

import pytest

from learnblock.runtime.pacing import SLIP, Pacing

pytestmark = pytest.mark.realtime


class WallTime:
    """A wall clock set by the test; waiting advances it."""

    def __init__(self):
        self.now, self.waits = 100.0, []

    def __call__(self):
        return self.now

    def wait(self, timeout=None):
        self.waits.append(timeout)
        self.now += timeout
        return False


@pytest.fixture
def wall():
    return WallTime()


def paced(factor, wall):
    pacing = Pacing(factor, clock=wall)
    pacing._changed.wait = wall.wait
    return pacing


def drive(pacing, steps, dt=0.01):
    for step in range(steps):
        pacing.wait(step * dt)


def test_a_free_world_never_waits(wall):
    drive(paced(None, wall), 100)
    assert wall.waits == []


@pytest.mark.parametrize(("factor", "seconds"), [(1.0, 1.0), (5.0, 0.2), (0.5, 2.0)])
def test_a_world_takes_its_time_divided_by_the_factor(wall, factor, seconds):
    drive(paced(factor, wall), 101)
    assert wall.now - 100 == pytest.approx(seconds, abs=0.002)


def test_a_world_that_is_a_little_late_catches_up(wall):
    pacing = paced(1.0, wall)
    pacing.wait(0.0)
    wall.now += 0.05
    drive(pacing, 101)
    assert wall.now - 100 == pytest.approx(1.0, abs=0.002)
    assert not pacing.slipped


def test_a_late_world_runs_slower_and_continues_from_there(wall):
    pacing = paced(1.0, wall)
    pacing.wait(0.0)
    wall.now += SLIP + 0.5
    pacing.wait(0.01)
    assert pacing.slipped
    assert wall.waits == []
    pacing.wait(0.02)
    assert wall.waits == [pytest.approx(0.01)]


def test_a_new_factor_applies_from_when_it_is_set(wall):
    pacing = paced(1.0, wall)
    drive(pacing, 51)
    before = wall.now
    pacing.set_factor(10.0)
    for step in range(51, 152):
        pacing.wait(step * 0.01)
    assert wall.now - before == pytest.approx(0.1, abs=0.002)


class Stepping:
    """A world that steps in its own thread."""

    def __init__(self, pacing):
        self.pacing, self.steps = pacing, 0
        self.moved = threading.Condition()
        self.done = threading.Event()
        self.thread = threading.Thread(target=self.run)

    def run(self):
        while not self.done.is_set():
            self.pacing.wait(self.steps * 0.01)
            with self.moved:
                self.steps += 1
                self.moved.notify_all()
                if self.steps > 500:
                    return

    def await_steps(self, steps):
        with self.moved:
            return self.moved.wait_for(lambda: self.steps >= steps, timeout=5)


@pytest.fixture
def stepping():
    world = Stepping(Pacing())
    world.pacing.pause()
    world.thread.start()
    yield world
    world.done.set()
    world.pacing.end()
    world.thread.join(5)
    assert not world.thread.is_alive()


def test_a_paused_world_makes_exactly_the_allowed_steps(stepping):
    stepping.pacing.step(3)
    assert stepping.await_steps(3)
    with stepping.moved:
        assert not stepping.moved.wait_for(lambda: stepping.steps > 3, timeout=0.02)


def test_a_resumed_world_continues(stepping):
    stepping.pacing.resume()
    assert stepping.await_steps(500)


def test_steps_left_over_are_forgotten_at_the_next_pause(stepping):
    stepping.pacing.step(10**6)
    assert stepping.await_steps(1)
    stepping.pacing.pause()
    with stepping.moved:
        now = stepping.steps
        assert not stepping.moved.wait_for(lambda: stepping.steps > now + 1, timeout=0.02)


def test_a_pause_also_stops_a_world_that_is_already_waiting():
    pacing = Pacing(0.001)
    world = Stepping(pacing)
    pacing.wait(0.0)
    world.steps = 1
    world.thread.start()
    pacing.pause()
    pacing.set_factor(None)
    with world.moved:
        assert not world.moved.wait_for(lambda: world.steps > 1, timeout=0.02)
    pacing.resume()
    assert world.await_steps(500)
    world.thread.join(5)


def test_an_end_releases_a_waiting_world():
    pacing = Pacing(0.0001)
    world = Stepping(pacing)
    world.thread.start()
    assert world.await_steps(1)
    pacing.end()
    assert world.await_steps(500)
    world.thread.join(5)


def test_a_faster_pace_takes_effect_at_once():
    pacing = Pacing(0.0001)
    world = Stepping(pacing)
    world.thread.start()
    assert world.await_steps(1)
    pacing.set_factor(None)
    assert world.await_steps(500)
    world.thread.join(5)


@pytest.mark.parametrize(("factor", "paused"), [(None, False), (None, True), (2.0, False)])
def test_only_a_world_without_a_pace_that_is_not_paused_is_free(factor, paused):
    pacing = Pacing(factor)
    if paused:
        pacing.pause()
    assert pacing.is_free == (factor is None and not paused)
