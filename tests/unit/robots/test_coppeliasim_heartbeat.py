"""The heartbeat of a robot in CoppeliaSim, and the limit of a simulation's start."""

from contextlib import contextmanager

import pytest

from learnblock.errors import RobotConnectionError
from learnblock.robots.coppeliasim.simulation import STOPPED, SceneSimulation
from learnblock.robots.heartbeat import PERIOD, Heartbeat
from learnblock.testing import ManualClock

RUNNING = 17


@pytest.fixture
def clock():
    return ManualClock()


@contextmanager
def beating(beat, clock):
    heartbeat = Heartbeat(beat, clock)
    clock.block_until(1)
    try:
        yield heartbeat
    finally:
        heartbeat.stop()


def test_the_heart_beats_with_exactly_its_period(clock):
    beats = []
    with beating(lambda: beats.append(clock.now()), clock):
        clock.advance(0.55)
    assert beats == pytest.approx([PERIOD * count for count in range(1, 6)])


def test_a_beat_that_fails_is_reported_and_the_last(clock):
    beats = []

    def beat():
        beats.append(clock.now())
        if clock.now() > 0.25:
            raise RobotConnectionError("coppeliasim-no-answer", place="there")

    with beating(beat, clock) as heartbeat:
        clock.advance(0.25)
        heartbeat.check()
        clock.advance(1)
        with pytest.raises(RobotConnectionError):
            heartbeat.check()
    assert beats == pytest.approx([0.1, 0.2, 0.3])


class Remote:
    """A CoppeliaSim whose simulation starts at some time."""

    place = "there"

    def __init__(self, clock, starts):
        self._clock, self._starts = clock, starts

    def constant(self, *names):
        return names

    def call(self, function, *_):
        is_running = self._clock.now() >= self._starts
        return {"getSimulationState": RUNNING if is_running else STOPPED}.get(function)


def test_a_simulation_that_does_not_start_is_given_up_exactly_in_time(clock):
    simulation = SceneSimulation(Remote(clock, starts=60), 3.0, clock)
    with pytest.raises(RobotConnectionError) as error:
        clock.run(simulation.start)
    assert error.value.phrase.code == "coppeliasim-not-started"
    assert clock.now() == pytest.approx(3.0)


def test_a_simulation_that_starts_late_is_waited_for(clock):
    clock.run(SceneSimulation(Remote(clock, starts=2.9), 3.0, clock).start)
    assert clock.now() == pytest.approx(2.9)
