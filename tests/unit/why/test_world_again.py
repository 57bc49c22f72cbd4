"""The world of a run, run again: any moment of it, exactly, and soon."""

import gc
import random
import weakref

import pytest

from learnblock.monitor.world_monitor import WorldMonitor
from learnblock.why.world_again import WorldAgain
from logged_runs import logged_text

#: It bumps into boxes and pushes them.
PUSHING = """\
main:
    forever:
        function.move_straight(150)
        function.sleep(3)
        function.turn(100)
        function.set_pen(True)
    end
end
"""
SECONDS = 60


@pytest.fixture(scope="module")
def recorded(tmp_path_factory):
    folder = tmp_path_factory.mktemp("pushing")
    return logged_text(folder, PUSHING, world="obstacles", seconds=SECONDS).recorded


@pytest.fixture(scope="module")
def moments(recorded):
    """What the world was like at some times, as it is when it runs once from its start."""
    chance = random.Random(7)  # noqa: S311 - chosen times, no secrets
    again = WorldAgain(recorded)
    times = sorted(round(chance.uniform(0, SECONDS), 2) for _ in range(40))
    return {time: state(again, time) for time in times}


def state(again, time):
    monitor = WorldMonitor.of(again.seek(time))
    strokes = [(stroke.colour, tuple(stroke.points)) for stroke in monitor.strokes()]
    return monitor.state(), strokes


def shuffled(moments):
    times = list(moments)
    random.Random(1).shuffle(times)  # noqa: S311 - as above
    return times


def test_a_moment_is_the_same_whatever_was_shown_before(recorded, moments):
    again = WorldAgain(recorded)
    assert [state(again, time) for time in shuffled(moments)] == [
        moments[time] for time in shuffled(moments)
    ]


def test_a_prepared_world_shows_the_same(recorded, moments):
    again = WorldAgain(recorded)
    while again.prepare():
        pass
    for time in shuffled(moments):
        assert state(again, time) == moments[time], time


def test_a_run_that_goes_on_shows_the_same_as_a_whole_one(recorded, moments):
    known = [line for line in recorded.lines if line.get("t", 0) <= SECONDS / 2]
    again = WorldAgain(recorded, lines=known)
    while again.prepare():
        pass
    again.seek(SECONDS)
    again.extend(recorded.lines[len(known) :])
    for time in shuffled(moments):
        assert state(again, time) == moments[time], time


def test_a_world_that_nobody_looks_at_any_more_is_forgotten(recorded):
    again = WorldAgain(recorded)
    again.prepare()
    world = weakref.ref(again.seek(1.0).simulation.world)
    del again
    gc.collect()
    assert world() is None


def test_looking_back_leaves_the_camera_of_this_computer_off(recorded, monkeypatch):
    def switch_on(time):
        raise AssertionError("it is on")

    monkeypatch.setattr("learnblock.client.extra_camera.extra_source", switch_on)
    assert WorldAgain(recorded).seek(1.0).simulation.steps == 100
