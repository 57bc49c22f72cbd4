"""Programs are tried in a step: contained, in variants and on robots, alone and with partners."""

import hashlib
from threading import Timer

import pytest

from learnblock.errors import ProgramError
from learnblock.lessons.reading import read_files
from learnblock.lessons.trying import Attempt, StopSwitch, attempts, try_step
from lesson_files import MAIN, files

SQUARE = """main:
    repeat 4:
        function.drive_distance(200)
        function.turn(90)
    end
end
"""
BUMPING = """main:
    function.drive_distance(2000)
end
"""


def opened(main=MAIN, **more):
    return read_files("it", files(main, **more))


def test_the_usual_robot_comes_first_in_the_world_as_it_is():
    assert attempts(opened(), 1) == (
        Attempt("sim-ebo", 0),
        Attempt("sim-ebo", 1),
        Attempt("sim-ev3", 0),
        Attempt("sim-ev3", 1),
    )
    assert attempts(opened(), 1, robots=["sim-ev3"], variants=0) == (Attempt("sim-ev3", 0),)


def test_a_solution_passes_in_each_attempt():
    wanted = attempts(opened(), 1)
    tried = [*try_step(opened(), 1, SQUARE, wanted)]
    assert {one.attempt for one in tried} == {*wanted}
    assert {verdict.state for one in tried for verdict in one.verdicts} == {"met"}


def test_an_attempt_has_the_trace_whose_hash_is_in_its_report():
    (tried,) = try_step(opened(), 1, SQUARE, [Attempt("sim-ebo", 0)])
    assert hashlib.sha256(tried.result.trace).hexdigest() == tried.result.report.trace_sha256
    assert b"collision" not in tried.result.trace


def test_collisions_are_evidence():
    main = MAIN.replace('kind = "goals"', 'kind = "never"\nwhat = { event = "collision" }')
    (tried,) = try_step(opened(main), 1, BUMPING, [Attempt("sim-ebo", 0)])
    assert tried.verdicts[0].state == "failed"
    assert tried.verdicts[0].at == tried.result.report.collisions[0].time


def test_a_run_ends_after_the_seconds_of_the_step():
    main = MAIN.replace('world = "square"', 'world = "square"\nseconds = 2')
    (tried,) = try_step(opened(main), 1, SQUARE, [Attempt("sim-ebo", 0)])
    assert (tried.result.report.ended, tried.result.report.time) == ("time limit", 2.0)


def test_a_lessons_own_world_is_used():
    world = '[[goal.reach]]\nname = "mine"\nx = 200\ny = 0\n[[start]]\nx = 0\ny = 0\n'
    (tried,) = try_step(opened(worlds__square_toml=world), 1, SQUARE, [Attempt("sim-ebo", 0)])
    assert [goal.name for goal in tried.result.report.goals] == ["mine"]


def test_partners_are_in_the_world_and_checks_can_look_at_them():
    main = MAIN.replace(
        'kind = "goals"',
        'kind = "happens"\nrobot = "friend"\nwhat = { event = "prints", what = "hello" }',
    ).replace(
        'world = "square"',
        'world = "square"\npartners = [{ name = "friend", robot = "sim-ev3", program = "hi.bt" }]',
    )
    lesson = opened(main, programs__hi_bt='main:\n    print("hello")\nend\n')
    (tried,) = try_step(lesson, 1, SQUARE, [Attempt("sim-ebo", 0)])
    assert [one.state for one in tried.verdicts] == ["met", "met"]
    assert tried.evidence.of("friend").distance < tried.evidence.distance


def test_a_program_that_cannot_be_read_is_refused():
    with pytest.raises(ProgramError):
        [*try_step(opened(), 1, "main:\n  (", [Attempt("sim-ebo", 0)])]


def test_a_python_program_is_tried_too():
    source = (
        "from learnblock.robots.sim_ebo import Robot\n\nrobot = Robot()\n"
        "for _ in range(4):\n    robot.drive_distance(200)\n    robot.turn(90)\n"
    )
    (tried,) = try_step(opened(), 1, source, [Attempt("sim-ebo", 0)], filename="program.py")
    assert [one.state for one in tried.verdicts] == ["met", "met"]


ENDLESS = """main:
    while True:
        function.move_straight(0)
    end
end
"""
PARTNER = 'partners = [{ name = "friend", robot = "sim-ev3", program = "hi.bt" }]'


@pytest.mark.parametrize("more", ["", PARTNER], ids=["alone", "with a partner"])
def test_a_run_that_goes_on_ends_at_once_when_it_is_stopped(more):
    main = MAIN.replace('world = "square"', f'world = "square"\nseconds = 600\n{more}')
    lesson, switch = opened(main, programs__hi_bt=ENDLESS), StopSwitch()
    Timer(1.0, switch.stop).start()
    assert [*try_step(lesson, 1, ENDLESS, attempts(lesson, 1), switch=switch)] == []


def test_nothing_runs_that_was_stopped_before():
    switch = StopSwitch()
    switch.stop()
    assert [*try_step(opened(), 1, SQUARE, attempts(opened(), 1), switch=switch)] == []
