import time

from learnblock.client.clock import WallClock


def test_a_wall_clock_starts_at_zero_and_runs():
    clock = WallClock()
    first = clock.time()
    assert 0 <= first <= clock.time() < 5


def test_a_wall_clock_sleeps_in_real_time(monkeypatch):
    slept = []
    monkeypatch.setattr(time, "sleep", slept.append)
    WallClock().sleep(0.5)
    assert slept == [0.5]


def test_a_wall_clock_does_not_sleep_backwards(monkeypatch):
    monkeypatch.setattr(time, "sleep", None)
    WallClock().sleep(0)
    WallClock().sleep(-1)


def test_a_wall_clock_has_no_instants():
    assert WallClock().instant is None
