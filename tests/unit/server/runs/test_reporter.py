"""Which bumps of a robot are worth a line."""

from learnblock.runtime.recorder import Collision
from learnblock.server.runs.reporter import Bumps


def times(bumps, *collisions):
    return [one.time for one in bumps.news([Collision(*one) for one in collisions])]


def test_a_bump_is_told_once():
    bumps = Bumps()
    assert times(bumps, (1.0, "box")) == [1.0]
    assert times(bumps, (1.0, "box")) == []
    assert times(bumps, (1.0, "box"), (1.2, "wall")) == [1.2]


def test_sliding_along_a_wall_is_one_bump_and_coming_back_is_another():
    touches = [(n / 10, "wall") for n in range(40)]
    assert times(Bumps(), *touches, (9.0, "wall")) == [0.0, 9.0]
