"""By how much, and where, a run missed a check: for every kind of goal, in both languages."""

import msgspec
import pytest
from hypothesis import given
from hypothesis import strategies as st

from learnblock.i18n import translate
from learnblock.lessons.checks import (
    At,
    Collided,
    Drives,
    EndsAt,
    GoalReached,
    Happens,
    Never,
    Reaches,
    StaysOnLine,
    Stood,
    Turns,
)
from learnblock.lessons.misses import missed
from learnblock.robots.simulated import find_world
from learnblock.running import Report
from learnblock.simulator import WorldDescription
from lesson_files import ENDED, evidence

BUMP = {"t": 1.0, "collision": "box"}
JOY = {"t": 1.0, "device": "Display", "key": "FACE", "do": "show_emotion", "args": ["joy"]}
CORNERS = [[200, 0], [200, -200], [0, -200], [0, 0]]


def world(kind, **goal):
    """The world of a square, with one goal."""
    goals = {kind: [{"name": "a", **goal}]}
    plain = msgspec.to_builtins(find_world("square"))
    tags = [{"id": 3, "x": 500, "y": 0, "heading": 180}]
    line = [{"points": [[0, 0], [1000, 0]]}]
    return msgspec.convert({**plain, "goal": goals, "tag": tags, "line": line}, WorldDescription)


def driven(*places, seconds=1.0):
    """Poses along a way, one for each place (x, y, heading)."""
    return [{"t": index * seconds, "pose": list(pose)} for index, pose in enumerate(places)]


def found(check, lines, in_world=None, report=ENDED, language="en"):
    miss = missed(check, evidence(*lines, report=report), in_world)
    return miss and translate(miss.words, language)


AHEAD = driven((0, 0, 0), (100, 0, 0))
ALL = Reaches()
CASES = [
    (ALL, world("reach", x=300, y=0, radius=50), AHEAD, "The goal 'a': 200 mm short."),
    (
        ALL,
        world("reach", x=100, y=90, radius=20),
        AHEAD,
        "The goal 'a': 90 mm too far right.",
    ),
    (
        ALL,
        world("reach", x=300, y=0, radius=50, object="box"),
        AHEAD,
        "'box' is not there yet.",
    ),
    (ALL, world("tour", points=CORNERS), AHEAD, "The first corner: 100 mm short."),
    (
        ALL,
        world("tour", points=CORNERS),
        driven((0, 0, 0), (200, 0, 90), (200, -200, 180), (80, -200, 180)),
        "The third corner: 80 mm short.",
    ),
    (
        ALL,
        world("tour", points=[[200, 0], [400, 0]]),
        driven((0, 0, 0), (300, 0, 0)),
        "Place 2 of 2: 100 mm short.",
    ),
    (
        ALL,
        world("stop", x=300, y=0, radius=30),
        driven((0, 0, 0), (400, 0, 0)),
        "The goal 'a': 100 mm too far.",
    ),
    (
        ALL,
        world("stop", x=100, y=0, radius=30, heading=90),
        AHEAD,
        "The goal 'a': the right place, but turned 90° too far left.",
    ),
    (
        ALL,
        world("stop", x=100, y=0, radius=30, seconds=3),
        driven((0, 0, 0), (100, 0, 0), (100, 0, 0)),
        "The goal 'a': the robot stood there for 1 s instead of 3 s.",
    ),
    (
        ALL,
        world("visit", id=3, distance=200),
        AHEAD,
        "Tag 3: 200 mm too far away; come within 200 mm.",
    ),
    (
        ALL,
        world("visit", id=3, distance=200),
        driven((0, 0, 0), (600, 0, 0)),
        "Tag 3: the robot was behind it, not in front.",
    ),
    (
        ALL,
        world("visit", id=3, distance=200),
        driven((0, 0, 0), (400, 0, 90)),
        "Tag 3: the robot was near, but turned 90° too far right.",
    ),
    (
        ALL,
        world("follow"),
        AHEAD,
        "The robot followed 11 % of the line instead of 100 %.",
    ),
    (ALL, world("show", emotion="joy"), AHEAD, "The robot never showed 'joy'."),
    (
        ALL,
        world("show", emotion="joy", x=300, y=0, radius=50),
        [*AHEAD, JOY],
        "The robot showed 'joy' 200 mm away from the place.",
    ),
    (ALL, world("avoid", distance=500), AHEAD, "The goal 'a': 400 mm short."),
    (
        ALL,
        world("avoid", distance=500),
        [*AHEAD, BUMP],
        "The robot bumped into something after 100 mm.",
    ),
    (
        Happens(what=GoalReached(name="a")),
        world("reach", x=300, y=0, radius=50),
        AHEAD,
        "The goal 'a': 200 mm short.",
    ),
    (Happens(what=At(x=300, y=0)), None, AHEAD, "At its nearest, the robot was 200 mm short."),
    (
        Happens(what=Stood(seconds=3)),
        None,
        driven((0, 0, 0), (0, 0, 0)),
        "The longest stop was 1 s instead of 3 s.",
    ),
    (Never(what=Collided()), None, [*AHEAD, BUMP], "The robot bumped into something after 100 mm."),
    (Never(what=At(x=100, y=0)), None, AHEAD, "The robot was there at 0 s."),
    (EndsAt(x=300, y=0), None, AHEAD, "The robot stopped 200 mm short."),
    (EndsAt(x=20, y=0), None, AHEAD, "The robot stopped 80 mm too far."),
    (
        EndsAt(x=100, y=0, heading=-90),
        None,
        AHEAD,
        "The robot stopped in the right place, but turned 90° too far right.",
    ),
    (Drives(at_least=500), None, AHEAD, "The robot drove 100 mm: 400 mm short."),
    (Drives(at_most=50), None, AHEAD, "The robot drove 100 mm: 50 mm too far."),
    (Turns(by=90), None, driven((0, 0, 0), (0, 0, 60)), "The robot turned 60°: 30° too little."),
    (Turns(by=-90), None, driven((0, 0, 0), (0, 0, -99)), "The robot turned -99°: 9° too much."),
    (
        StaysOnLine(distance=50),
        world("follow"),
        driven((0, 0, 0), (100, 0, 0), (100, 200, 0)),
        "The robot left the line at 2 s.",
    ),
]


@pytest.mark.parametrize(("check", "in_world", "lines", "words"), CASES)
def test_a_miss_says_by_how_much(check, in_world, lines, words):
    assert found(check, lines, in_world) == words


@pytest.mark.parametrize(("check", "in_world", "lines", "words"), CASES)
def test_a_miss_is_said_in_spanish(check, in_world, lines, words):
    spanish = found(check, lines, in_world, language="es")
    assert spanish
    assert spanish != words
    assert "lesson-" not in spanish


def test_a_miss_has_a_mark_between_the_place_and_the_robot():
    miss = missed(ALL, evidence(*AHEAD, report=ENDED), world("tour", points=CORNERS))
    assert miss is not None
    assert miss.place == (200, 0)
    assert miss.nearest == (100, 0)


def test_of_goals_that_follow_one_another_the_first_is_missed():
    plain = msgspec.to_builtins(find_world("square"))
    goals = {
        "reach": [{"name": "b", "x": 0, "y": 0, "radius": 50, "after": "a"}],
        "tour": [{"name": "a", "points": CORNERS}],
    }
    both = msgspec.convert({**plain, "goal": goals}, WorldDescription)
    assert found(ALL, AHEAD, both) == "The first corner: 100 mm short."


def test_nothing_is_said_of_a_goal_whose_reason_says_all():
    assert found(Reaches(goals=("unknown",)), AHEAD) is None
    assert found(ALL, [], world("reach", x=300, y=0)) is None


PLACES = st.tuples(st.integers(-900, 900), st.integers(-900, 900), st.integers(-180, 180))


@given(st.lists(PLACES, min_size=1, max_size=6), st.sampled_from(CASES))
def test_any_way_of_a_robot_can_be_judged(places, case):
    check, in_world, _, _ = case
    report = Report(ended="finished", time=10.0, pose=places[-1])
    for language in ("en", "es"):
        words = found(check, driven(*places), in_world, report, language)
        assert words is None or "{" not in words
