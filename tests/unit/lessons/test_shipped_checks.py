"""The checks in Python of the lessons that come with LearnBlock."""

import runpy

import pytest

from learnblock.lessons.check_texts import check_texts
from learnblock.lessons.expert_child import reason, seen_run
from learnblock.lessons.reading import find_lesson
from learnblock.lessons.trying import attempts
from lesson_tries import read_once, tried
from places import ROOT


def check(lesson, name):
    """A function of a lesson's Python, which says of a run True, or why not by language."""
    texts = check_texts(read_once(lesson))
    function = runpy.run_path(str(ROOT / "lessons" / lesson / "checks.py"))[name]

    def judged(seen):
        verdict = function(seen_run(seen, texts))
        return verdict if isinstance(verdict, bool) else reason(verdict, texts)

    return judged


def run(**seen):
    """What a check gets to see of a run."""
    return {"path": (), "prints": (), "calls": (), "shows": (), "time": 60, **seen}


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


def test_words_of_any_language_are_right_in_a_report():
    reports = check("2-03-wait-until", "reports")
    for clear, wall in (("clear", "wall"), ("libre", "pared"), ("libre", "wall")):
        prints = [(1, clear), (2, clear), (3, clear), (4, wall)]
        assert reports(run(prints=prints)) is True
        assert reports(run(prints=prints[:3] * 2)) is not True


def test_a_face_counts_only_after_the_camera_was_asked():
    asks = check("4-03-faces", "asks_before_each_face")
    joy, surprise, neutral = "expressJoy", "expressSurprise", "expressNeutral"
    happy, surprised, sad = "is_any_face_happy", "is_any_face_surprised", "is_any_face_sad"

    def told(*skills):
        return asks(run(shows=[(1, "joy")], calls=[(1, skill) for skill in skills]))

    assert told(happy, joy, surprised, surprise, sad, neutral) is True
    assert "number 2" in told(happy, joy, sad, surprise)["en"]
    # At the same moment, but before the question.
    assert "number 1" in told(joy, happy)["en"]


def test_a_robot_waits_two_seconds_after_each_face():
    stays = check("4-03-faces", "stays_with_each_friend")
    path = [(tick / 10, 0, 0, max(0, tick - 20) * 9) for tick in range(30)]
    assert stays(run(path=path, shows=[(0, "joy")])) is True
    assert "number 1" in stays(run(path=path, shows=[(1.9, "joy")]))["en"]


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


DECISION = """main:
    forever:
        if function.is_front_obstacle(100):
            function.expressFear()
            function.turn(-90)
        else:
            function.expressJoy()
            function.move_straight(80)
        end
    end
end
"""
EVENTS = """when ahead = function.is_front_obstacle(100):
    function.expressFear()
    function.turn(90)
end

when free = not function.is_front_obstacle(100):
    function.expressJoy()
    function.move_straight(80)
end
"""
WAIT = """main:
    forever:
        function.expressJoy()
        function.move_straight(80)
        wait until function.is_front_obstacle(100)
        function.expressFear()
        function.turn(90)
    end
end
"""
FUNCTION = """def get_away():
    function.expressFear()
    function.turn(90)
end

main:
    while 1 == 1:
        if not function.is_front_obstacle(100):
            function.expressJoy()
            function.set_move(80, 0)
        else:
            get_away()
        end
    end
end
"""


@pytest.mark.slow
def test_a_careful_robot_may_turn_to_either_side_and_decide_in_any_style():
    lesson = find_lesson("2-01-avoid-a-box")
    found = tried(lesson, 5, [DECISION, EVENTS, WAIT, FUNCTION], attempts(lesson, 5)[:1])
    for [done] in found:
        assert {one.check.name: one.state for one in done.verdicts} == dict.fromkeys(
            ["faces", "bump", "turn", "far", "box"], "met"
        )


def turning_robot(turning, driving):
    """A robot that drives, turns and drives, and the faces that it shows meanwhile."""
    path = [(tick / 10, tick * 8, 0, 0) for tick in range(20)]
    path += [(2 + tick / 10, 160, 0, tick * 9) for tick in range(11)]
    path += [(3.1 + tick / 10, 160, -tick * 8, 90) for tick in range(20)]
    return run(path=path, shows=[(0, driving), (2, turning), (3.1, driving)])


def test_a_robot_is_scared_while_it_turns_and_happy_while_it_drives():
    faces = check("2-01-avoid-a-box", "happy_on_the_way_and_scared_at_obstacles")
    assert faces(turning_robot("fear", "joy")) is True
    assert "turns, and does not look scared" in faces(turning_robot("joy", "fear"))["en"]
    assert "drives, and does not look happy" in faces(turning_robot("fear", "sadness"))["en"]


@pytest.mark.parametrize(("x", "falls"), [(392, False), (-430, False), (470, True)])
def test_a_robot_falls_when_its_middle_is_beyond_the_edge(x, falls):
    stays = check("1-06-edge", "stays_on_the_table")
    assert (stays(run(path=[(0, 0, 0, 0), (9, x, 0, 0)])) is not True) == falls


def test_turns_around_to_either_side_count_alike():
    around = check("1-06-edge", "turns_around")
    for side in (-1, 1):
        headings = [side * min(tick * 10, 540) for tick in range(60)]
        path = [(number / 10, 0, 0, heading % 360) for number, heading in enumerate(headings)]
        assert around(run(path=path)) is True
        assert "360°" in around(run(path=path[:37]))["en"]


@pytest.mark.parametrize(
    ("place", "is_right"),
    [((1, 170, 0, 0), True), ((1, 170, 0, 180), False), ((1, -400, 0, 0), False)],
)
def test_bench_is_printed_only_where_the_bench_is_ahead(place, is_right):
    at_bench = check("3-06-events", "bench_at_the_bench")
    assert (at_bench(run(path=[place], prints=[(1, "bench")])) is True) == is_right


@pytest.mark.parametrize(("surprised", "is_right"), [(14, True), (13, False), (15, False)])
def test_a_robot_is_surprised_four_seconds_after_it_got_lost(surprised, is_right):
    after_four = check("3-02-line-with-states", "surprised_after_4_seconds")
    shows = [(0, "joy"), (5, "sadness"), (6, "joy"), (10, "sadness"), (surprised, "surprise")]
    assert (after_four(run(shows=shows)) is True) == is_right


def test_a_report_counts_only_when_the_robot_has_parked():
    reports = check("4-01-noisy-sensor", "reports_at_the_end")
    path = [(0, 0, 0, 0), (1, 0, 0, 0), (2, 100, 0, 0), (3, 100, 0, 0)]
    assert reports(run(path=path, prints=[(3, "parked at 297 mm")])) is True
    assert "before it has parked" in reports(run(path=path, prints=[(0, "parked at 297 mm")]))["en"]
    assert "not the distance" in reports(run(path=path, prints=[(3, "parked at 700 mm")]))["en"]
