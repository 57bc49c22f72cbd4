"""Answers about a run as a whole."""

import pytest

from asked import answered, run_of, told


def codes(given):
    return [code for code, _ in told(given)]


def test_nothing_happens_in_events_that_only_start_each_other(tmp_path):
    program = (
        "when start:\n    function.look_front()\nend\n"
        "when one:\n    function.expressJoy()\n    activate two\nend\n"
        "when two:\n    activate one\nend\n"
    )
    given = answered(run_of(tmp_path, program, "sim-cozmo"), "why did nothing happen")
    assert told(given)[0] == ("why-only-each-other", 4)


def test_nothing_happens_where_nothing_is_told(tmp_path):
    given = answered(run_of(tmp_path, "x = 1\n"), "why does nothing happen")
    assert codes(given) == ["why-no-acts"]


def test_nothing_happens_while_the_program_waits(tmp_path):
    program = "function.sleep(20)\nfunction.expressJoy()\n"
    given = answered(run_of(tmp_path, program), "why did nothing happen")
    assert told(given)[0] == ("why-busy", 1)


def test_nothing_happens_without_the_device(tmp_path):
    program = 'function.say_Text("hello")\nfunction.sleep(2)\n'
    given = answered(run_of(tmp_path, program, "sim-thymio"), "why did nothing happen")
    assert told(given)[0] == ("why-no-effect", 1)


def test_a_loop_keeps_a_program_from_its_end(tmp_path):
    program = "forever:\n    function.turn(90)\n    function.stop_bot()\nend\n"
    given = answered(run_of(tmp_path, program), "why does my program not end")
    assert told(given)[0] == ("why-loop-goes-on", 1)
    given = answered(run_of(tmp_path, program), "why does it not stop")
    assert told(given)[0] == ("why-loop-goes-on", 1)


def test_an_event_keeps_a_program_from_its_end(tmp_path):
    program = "when go:\n    function.move_straight(60)\nend\nwhen start:\n    activate go\nend\n"
    given = answered(run_of(tmp_path, program), "why does it not end")
    assert told(given)[0] == ("why-when-goes-on", 1)
    assert ("why-never-stopped", 1) in told(given)


def test_a_program_ends_because_its_loop_is_over(tmp_path):
    program = "n = 0\nwhile n < 2:\n    function.turn(20)\n    n += 1\nend\nfunction.expressJoy()\n"
    given = answered(run_of(tmp_path, program), "why is it over so soon")
    assert codes(given)[:2] == ["why-finished", "why-loop-over"]


@pytest.mark.parametrize(
    ("program", "line"),
    [
        ("function.move_straight(5)\nfunction.sleep(9)\n", 1),
        ("repeat 3:\n    function.drive_distance(30)\n    function.sleep(3)\nend\n", 3),
    ],
)
def test_a_robot_is_slow_by_its_speed_or_its_pauses(tmp_path, program, line):
    given = answered(run_of(tmp_path, program), "why is it so slow")
    assert told(given)[0][1] == line


def test_a_movement_is_long_because_of_a_pause(tmp_path):
    program = "function.move_straight(50)\nfunction.sleep(8)\nfunction.turn(90)\n"
    given = answered(run_of(tmp_path, program), "why does it go straight for so long")
    assert told(given)[:2] == [("why-moved", 1), ("why-busy", 2)]


def test_a_line_is_lost_by_what_the_robot_did_when_it_saw_it(tmp_path):
    program = (
        "forever:\n    if function.is_there_black_line():\n        function.turn(90)\n"
        "        function.move_straight(60)\n    end\nend\n"
    )
    given = answered(
        run_of(tmp_path, program, "sim-thymio", world="line"), "why did it leave the line"
    )
    assert told(given)[0] == ("why-line-seen", 2)
    assert told(given)[1] == ("why-moved", 3)


def test_a_robot_falls_while_the_program_is_busy(tmp_path):
    program = (
        "function.move_straight(60)\nfunction.sleep(10)\n"
        "wait until not function.is_there_ground()\nfunction.stop_bot()\n"
    )
    given = answered(run_of(tmp_path, program, "sim-cozmo", world="edge"), "why did it fall down")
    assert ("why-busy", 2) in told(given)


def test_one_event_holds_up_another(tmp_path):
    program = (
        "when drive:\n    function.move_straight(60)\n    function.sleep(9)\nend\n"
        "when near = function.is_front_obstacle(150):\n    function.stop_bot()\nend\n"
        "when start:\n    activate drive\nend\n"
    )
    history = run_of(tmp_path, program, "sim-thymio", world="parking", seconds=9)
    assert told(answered(history, "not when near at 8"))[0] == ("why-busy", 3)


def test_a_line_behind_the_loop_had_not_run_yet(tmp_path):
    program = "n = 1\nrepeat 3:\n    print(n)\n    function.sleep(0.1)\nend\nn += 1\n"
    given = answered(run_of(tmp_path, program), "why does it always write 1")
    assert told(given)[-1] == ("why-not-yet", 6)


SPANS = (
    "repeat 3:\n    function.turn(90)\n    function.sleep(2)\nend\n"
    "function.expressJoy()\nfunction.move_straight(60)\nfunction.sleep(3)\n"
)


@pytest.mark.parametrize(
    ("question", "code", "first", "last"),
    [
        ("why did it turn between 0 and 2 s", "why-moved", 0, 2),
        ("why did it turn in the first 2 seconds", "why-moved", 0, 2),
        ("why did it turn after 4 s", "why-moved", 4, 12),
        ("why did it show joy between 0 and 3 s", "why-not-between", 3, 3),
        ("why did it drive forward between 0 and 3 s", "why-not-between", 3, 3),
        ("what did it do between 4 and 8 s", "why-moved", 3, 8),
    ],
)
def test_a_span_is_obeyed(tmp_path, question, code, first, last):
    given = answered(run_of(tmp_path, SPANS, "sim-ebo", seconds=16), question)
    [one, *others] = given.sentences
    assert one.phrase.code == code
    assert first <= one.time <= last
    assert all(other.time <= last + 0.06 for other in others if other.event >= 0)
