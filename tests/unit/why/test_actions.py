"""What the robot did or did not do."""

import pytest

from asked import answered, run_of, told

DRIVES = """\
function.move_straight(60)
function.sleep(1)
function.stop_bot()
function.sleep(1)
function.move_straight(60)
function.sleep(3)
function.turn(-90)
function.sleep(1)
"""


@pytest.fixture(scope="module")
def history(tmp_path_factory):
    return run_of(tmp_path_factory.mktemp("run"), DRIVES)


def test_a_movement_that_was_over_is_not_the_one_at_a_moment(history):
    given = answered(history, "why did it stop at 4")
    assert told(given)[:2] == [("why-not-then", 0), ("why-moved", 5)]
    assert given.words("en")[:2] == (
        "At 4 s the robot was told something else.",
        "At 2 s the robot was told to drive straight ahead: line 5 says move_straight(60).",
    )


def test_a_movement_that_has_just_ended_may_still_be_asked_about(history):
    assert told(answered(history, "why did it stop at 2.5"))[0] == ("why-moved", 3)


def test_a_turn_is_told_from_where_it_began(history):
    words = answered(history, "why did it turn left at 6.5").words("en")
    assert words[0].startswith("At 5.2 s the robot was told to turn left on the spot: line 7")


def test_a_turn_that_is_about_to_begin_is_told(history):
    words = answered(history, "why did it turn left at 5").words("en")
    assert words[0].startswith("At 5.2 s the robot was told to turn left on the spot: line 7")


def test_a_statement_that_took_time_is_told_with_its_begin_and_end(history):
    words = answered(history, "why did it not turn left").words("en")
    assert words[0] == "It did: line 7, turn(-90), ran from 5 to 6.82 s."


def test_a_statement_that_lasts_is_told_with_its_begin(history):
    assert answered(history, "not turn left at 6").words("en")[0] == (
        "It did: line 7, turn(-90), began at 5 s."
    )


def test_what_replaces_a_movement_only_later_is_not_told_of_a_moment_before(tmp_path):
    program = DRIVES + "function.move_straight(60)\nfunction.sleep(1)\n"
    given = answered(run_of(tmp_path, program), "not turn left at 6")
    assert not {code for code, _ in told(given)} & {"why-overridden-soon", "why-overridden-later"}


def test_a_robot_that_was_never_told_to_move_stands_still(tmp_path):
    program = "count = 5\nwhile count < 3:\n    function.turn_left()\nend\nfunction.sleep(3)\n"
    given = answered(run_of(tmp_path, program), "why did it stand still at 2?")
    assert told(given) == [("why-never-told", 0), ("why-needs", 2), ("why-set", 1)]
    assert given.words("en")[0] == "No line had told the robot to move by 2 s."
    assert given.words("es")[0] == (
        "Ninguna línea le había dicho al robot que se moviera hasta el segundo 2."
    )


def test_a_program_without_a_movement_is_said_to_have_none(tmp_path):
    given = answered(run_of(tmp_path, "function.sleep(3)\n"), "why did it stand still at 2?")
    assert given.words("en")[0] == "No line of your program tells the robot to move."
    assert told(given)[1:] == [("why-busy", 1)]


def test_a_robot_that_is_blocked_stands_still_because_it_bumped(tmp_path):
    program = "function.move_straight(150)\nfunction.sleep(20)\n"
    given = answered(run_of(tmp_path, program, world="arena"), "why did it stop at 11?")
    assert told(given)[:2] == [("why-bumped", 0), ("why-moved", 1)]
    assert 5 < given.sentences[0].time < 6, "when it bumped, and not when the wait began"


def test_a_robot_stops_when_its_program_is_over(tmp_path):
    history = run_of(tmp_path, "function.move_straight(60)\nfunction.sleep(2)\n")
    given = answered(history, "why did it stop?")
    assert [code for code, _ in told(given)] == ["why-finished", "why-stops-at-end", "why-moved"]


def test_a_robot_stops_when_its_program_fails(tmp_path):
    history = run_of(tmp_path, "function.move_straight(60)\nfunction.sleep(2)\nprint(1 / 0)\n")
    given = answered(history, "why did it stop?")
    assert told(given)[:2] == [("why-failed", 3), ("why-stops-at-end", 0)]


def test_a_movement_that_was_told_again_and_again_is_never_later_than_asked(tmp_path):
    program = "forever:\n    function.move_straight(50)\n    function.sleep(0.05)\nend\n"
    given = answered(run_of(tmp_path, program), "drive straight at 3.53")
    assert given.sentences[0].phrase.code == "why-moved"
    assert given.sentences[0].time <= 3.53
