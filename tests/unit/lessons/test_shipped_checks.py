"""The checks in Python of the lessons that come with LearnBlock."""

import runpy
from types import SimpleNamespace

import pytest

from learnblock.lessons.reading import find_lesson
from learnblock.lessons.trying import attempts
from lesson_tries import tried
from places import ROOT


def check(lesson, name):
    """A function of a lesson's Python."""
    return runpy.run_path(str(ROOT / "lessons" / lesson / "checks.py"))[name]


def run(**seen):
    """What a check gets to see of a run."""
    return SimpleNamespace(**{"path": (), "prints": (), "calls": (), "shows": (), **seen})


@pytest.mark.parametrize("y", [0, 250, -300])
def test_a_robot_parks_at_any_place_along_the_wall(y):
    parks = check("1-05-park", "parks_100_mm_from_the_wall")
    assert parks(run(path=[(0, -400, y, 0), (9, 420, y, 0)])) is True


@pytest.mark.parametrize(("x", "words"), [(300, "too far"), (480, "too close")])
def test_a_robot_that_parks_at_a_wrong_distance_is_told_which(x, words):
    parks = check("1-05-park", "parks_100_mm_from_the_wall")
    assert words in parks(run(path=[(0, -400, 0, 0), (9, x, 0, 0)]))["en"]


#: A tour that stays at each place from the second given.
STOPS = [(4, 0, -300), (10, 0, 100), (16, 400, 100), (22, 400, -300)]
NAMES = ["bakery", "school", "park", "home"]


def tour(name_at, note_at):
    """A tour that prints a name and plays a note so many seconds after it has come to a place."""
    path = [(0, -400, -300, 0)]
    for time, x, y in STOPS:
        path += [(time + tick, x, y, 0) for tick in range(4)]
        path.append((time + 5, x - 200, y - 200, 0))
    prints = [(time + name_at, name) for (time, *_), name in zip(STOPS, NAMES, strict=True)]
    return run(
        path=path, prints=prints, calls=[(time + note_at, "play_note") for time, *_ in STOPS]
    )


@pytest.mark.parametrize(("name_at", "note_at"), [(0, 1), (1, 0), (3, 2)])
def test_name_and_note_may_come_in_any_order_at_a_place(name_at, note_at):
    at_places = check("3-04-lists-tour", "name_and_note_at_each_place")
    assert at_places(tour(name_at, note_at)) is True


def test_a_name_or_note_elsewhere_is_told_with_its_place():
    at_places = check("3-04-lists-tour", "name_and_note_at_each_place")
    assert at_places(tour(-2, 0))["en"] == "No name is printed at this place: bakery."
    assert at_places(tour(0, -2))["es"] == "En este sitio se tocan 0 notas: panadería."


def test_a_face_counts_only_after_the_camera_was_asked():
    asks = check("4-03-faces", "asks_before_each_face")
    shows = [(1, "joy"), (4, "surprise"), (7, "neutral")]
    calls = [(1, "is_any_face_happy"), (4, "is_any_face_surprised"), (7, "is_any_face_sad")]
    assert asks(run(shows=shows, calls=calls)) is True
    assert "number 2" in asks(run(shows=shows, calls=[calls[0], calls[2]]))["en"]
    assert asks(run(shows=shows))["en"].startswith("The robot shows face number 1")


@pytest.fixture(scope="module")
def noted():
    """What became of the checks of a patrol that notes an obstacle at another moment."""
    lesson = find_lesson("4-06-patrol")
    solution = lesson.solution(5)
    note = "        append(turns, round(function.get_timer()))\n"
    turn = "        function.turn(100)\n"
    late = solution.replace(note, "").replace(turn, turn + note)
    assert late != solution
    done = tried(lesson, 5, [solution, late], attempts(lesson, 5)[:1])
    return [{one.check.name: one for one in found.verdicts} for [found] in done]


@pytest.mark.slow
def test_a_time_noted_after_backing_away_is_too_late(noted):
    right, late = noted
    assert right["true"].state == "met"
    assert late["true"].state == "failed"
    assert "too late" in str(late["true"].reason)
