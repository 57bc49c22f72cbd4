"""Keys that a step of a lesson presses by itself: when they are held, and what may be written."""

import msgspec
import pytest

from learnblock.errors import LearnBlockError
from learnblock.lessons.key_presses import KeyPress, recorded_keys
from learnblock.lessons.reading import read_files
from learnblock.lessons.trying import Attempt, attempts, try_step
from lesson_files import MAIN, files

TAPPED = 'keys = [{ key = "up", at = 1, times = 2 }, { key = "right", at = 3, seconds = 0.1 }]'
DRIVEN = """when forward = function.is_key_pressed("up"):
    function.drive_distance(50, 150)
end

when right = function.is_key_pressed("right"):
    function.turn(90)
end
"""
CHECK = """def is_pressed(run):
    held = [keys for _, keys in run.keys]
    return held == [["up"], [], ["up"], [], ["right"], []] or str(held)
"""
PYTHON = '[[step.check]]\nkind = "python"\nfunction = "is_pressed"\n'
PARTNERS = 'partners = [{ name = "friend", robot = "sim-ev3", program = "start.bt" }]'


def opened(keys=TAPPED, more=""):
    main = MAIN.replace("variants = 1", f"variants = 1\nseconds = 6\n{keys}\n{more}")
    checks = {"checks_py": CHECK, "checks_en_toml": "[texts]\n"}
    return read_files("it", files(f"{main}\n{PYTHON}", **checks))


def test_a_key_is_held_each_time_from_press_to_release():
    keys = recorded_keys([KeyPress(key="up", at=1, times=2), KeyPress(key="a", at=1.1, seconds=1)])
    assert keys is not None
    assert [keys.held(time) for time in (0.9, 1, 1.1, 1.2, 2.05, 2.15, 2.2)] == [
        (),
        ("up",),
        ("up", "a"),
        ("a",),
        ("up", "a"),
        ("up",),
        (),
    ]


def test_a_key_that_is_pressed_twice_at_once_is_held_until_the_last_release():
    presses = [KeyPress(key="up", at=0, seconds=2), KeyPress(key="up", at=1, seconds=2)]
    keys = recorded_keys(presses)
    assert keys is not None
    assert (keys.held(2.5), keys.held(3)) == (("up",), ())


def test_a_step_without_presses_leaves_the_keyboard_alone():
    assert recorded_keys(()) is None


@pytest.mark.parametrize("robot", ["sim-ebo", "sim-ev3"])
def test_a_program_gets_the_keys_of_its_step_in_the_same_run_each_time(robot):
    first, second = (
        next(iter(try_step(opened(), 1, DRIVEN, [Attempt(robot, 0)]))) for _ in range(2)
    )
    assert first.verdicts[-1].state == "met", first.verdicts[-1].reason
    assert first.result.report.trace_sha256 == second.result.report.trace_sha256
    x, _, heading = first.result.report.pose
    start_x = first.evidence.path[0].x
    assert (x - start_x, heading) == pytest.approx((100, 90), abs=6)


def test_the_pupils_robot_gets_the_keys_among_others():
    lesson = opened(more=PARTNERS)
    (tried,) = try_step(lesson, 1, DRIVEN, attempts(lesson, 1)[:1])
    assert [list(keys) for _, keys in tried.evidence.keys][:2] == [["up"], []]
    assert tried.evidence.of("friend").keys == []


@pytest.mark.parametrize(
    "wrong",
    [
        '{ key = "hyper", at = 1 }',
        '{ key = "up", at = -1 }',
        '{ key = "up", at = 4000 }',
        '{ key = "up", at = 1, times = 1000000000 }',
        '{ key = "up", at = 1, seconds = 0 }',
        '{ key = "up", at = 1, seconds = nan }',
        '{ key = "up", at = 1, every = 0 }',
        '{ key = "up", at = 1, then = 2 }',
        ", ".join(['{ key = "up", at = 1 }'] * 101),
    ],
)
def test_hostile_keys_are_refused_with_their_place(wrong):
    with pytest.raises(LearnBlockError, match=r"lesson\.toml"):
        opened(f"keys = [{wrong}]")


def test_the_most_presses_that_are_allowed_take_little():
    press = KeyPress(key="up", at=0, times=100, every=0.1, seconds=600)
    keys = recorded_keys([press] * 100)
    assert keys is not None
    assert len(msgspec.json.encode(keys)) < 1_000_000
