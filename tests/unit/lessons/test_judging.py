"""Judging: each check met, failed and open, with the reason in words."""

from dataclasses import replace

import msgspec
import pytest

from learnblock.i18n import translate
from learnblock.language import parse
from learnblock.lessons import checks
from learnblock.lessons.checks import (
    At,
    Called,
    Collided,
    Drives,
    Ends,
    EndsAt,
    Expert,
    GoalReached,
    Happens,
    InOrder,
    Never,
    Printed,
    Prints,
    Reaches,
    Said,
    Sent,
    Shown,
    Size,
    StaysOnLine,
    Stood,
    Turns,
    Uses,
)
from learnblock.lessons.finding import Finding
from learnblock.lessons.judging import is_done, judge
from learnblock.robots.simulated import find_world
from lesson_files import ENDED, STEP, evidence

STILL = [{"t": t / 10, "pose": [0, 0, 0]} for t in range(21)]
DRIVEN = [{"t": t / 10, "pose": [t * 10, 0, t]} for t in range(101)]
GOAL = {"t": 3.0, "goal": "a", "state": "reached"}
OTHER = {"t": 5.0, "goal": "b", "state": "reached"}
LOST = {"t": 4.0, "goal": "a", "state": "failed"}
BUMP = {"t": 2.5, "collision": "box"}
JOY = {"t": 4.5, "device": "Display", "key": "FACE", "do": "show_emotion", "args": ["joy"]}
HELLO = {"t": 1.0, "print": "Hello  World"}
BYE = {"t": 2.0, "print": "bye"}
TURN = {"t": 1.0, "call": "turn", "args": [90]}
PROGRAM = parse(
    "def f(n):\n    return n\nend\nmain:\n    repeat 4:\n        f(1)\n    end\nend\n", "p"
)


def found(check, *lines, ended=True, report=ENDED, now=10.0, world=None, experts=None):
    step = msgspec.structs.replace(STEP, check=(check,), seconds=20)
    run = evidence(*lines, report=report if ended else None, now=now)
    (verdict,) = judge(step, PROGRAM, run, world, experts)
    return verdict


def told(verdict):
    return translate(verdict.reason, "en") if verdict.reason else ""


CASES = [
    # A check, the lines of a run, whether it is over, and what the check says.
    (Reaches(goals=("a",)), [GOAL], True, "met"),
    (Reaches(goals=("a",)), [GOAL], False, "met"),
    (Reaches(goals=("a",)), [], False, "open"),
    (Reaches(goals=("a",)), [], True, "The goal 'a' was not reached."),
    (Reaches(goals=("a",)), [LOST], False, "The goal 'a' can't be reached any more."),
    (Reaches(goals=("a", "b")), [GOAL, OTHER], False, "met"),
    (Reaches(goals=("a", "b")), [GOAL], True, "The goal 'b' was not reached."),
    (Reaches(goals=("a",), within=3), [GOAL], False, "met"),
    (
        Reaches(goals=("a",), within=2),
        [GOAL],
        False,
        "The goal 'a' was reached after 3 s, but has to be reached within 2 s.",
    ),
    (Reaches(goals=("a",), within=9), [], False, "The goal 'a' was not reached within 9 s."),
    (Reaches(goals=("a",), within=11), [], False, "open"),
    (Reaches(), [], True, "This world has no goals."),
    (Happens(what=Printed(what="hello*")), [HELLO], False, "met"),
    (Happens(what=Printed(what="hello*")), [BYE], False, "open"),
    (
        Happens(what=Printed(what="hello*")),
        [BYE],
        True,
        "The program did not print 'hello…'.",
    ),
    (
        Happens(what=Shown(what="joy"), within=4),
        [JOY],
        False,
        "The robot showed 'joy' at 4.5 s; this has to happen within 4 s.",
    ),
    (
        Happens(what=Called(skill="turn"), at_least=2),
        [TURN],
        True,
        "The program used turn only once; this has to happen at least twice.",
    ),
    (Happens(what=Called(skill="turn"), at_least=2), [TURN, TURN], False, "met"),
    (Happens(what=Called(skill="turn"), at_most=1), [TURN], False, "open"),
    (Happens(what=Called(skill="turn"), at_most=1), [TURN], True, "met"),
    (
        Happens(what=Called(skill="turn"), at_most=1),
        [TURN, TURN],
        False,
        "The program used turn more than once.",
    ),
    (Happens(what=Called(skill="turn"), at_least=0, at_most=0), [], True, "met"),
    (Never(what=Collided()), [], True, "met"),
    (Never(what=Collided()), [], False, "open"),
    (
        Never(what=Collided()),
        [BUMP],
        False,
        "The robot bumped into something at 2.5 s.",
    ),
    (Never(what=Collided(thing="wall")), [BUMP], True, "met"),
    (InOrder(events=(Called(skill="turn"), Printed(what="bye"))), [TURN, BYE], False, "met"),
    (InOrder(events=(Called(skill="turn"), Printed(what="bye"))), [TURN], False, "open"),
    (
        InOrder(events=(Called(skill="turn"), Printed(what="bye"))),
        [TURN],
        True,
        "The program did not print 'bye'; "
        "this has to come after something else: the program uses turn.",
    ),
    (
        InOrder(events=(Printed(what="bye"), Called(skill="turn"))),
        [TURN, BYE],
        True,
        "The order is wrong: first the program prints 'bye', and only then the program uses turn.",
    ),
    (
        InOrder(events=(GoalReached(name="a"), Shown(what="joy")), within=1),
        [GOAL, JOY],
        True,
        "1.5 s went by, and at most 1 s are allowed: "
        "first the goal 'a' is reached, then the robot shows 'joy'.",
    ),
    (
        InOrder(events=(GoalReached(name="a"), Shown(what="joy")), within=2),
        [GOAL, JOY],
        True,
        "met",
    ),
    # The later of two turns is near enough.
    (
        InOrder(events=(Called(skill="turn"), Printed(what="bye")), within=0.5),
        [TURN, {**TURN, "t": 1.8}, BYE],
        False,
        "met",
    ),
    (
        InOrder(events=(Printed(what="bye"), Printed(what="bye"))),
        [BYE],
        True,
        "The order is wrong: first the program prints 'bye', "
        "and only then the program prints 'bye'.",
    ),
    (Drives(at_least=900), DRIVEN, False, "met"),
    (Drives(at_least=2000), DRIVEN, False, "open"),
    (Drives(at_least=2000), DRIVEN, True, "You drove 1,000 mm; drive at least 2,000 mm."),
    (Drives(at_least=900, at_most=1100), DRIVEN, False, "open"),
    (Drives(at_least=900, at_most=1100), DRIVEN, True, "met"),
    (Drives(at_most=500), DRIVEN, False, "You drove 1,000 mm; at most 500 mm are allowed."),
    (EndsAt(x=1000, y=30), DRIVEN, True, "met"),
    (EndsAt(x=1000, y=30), DRIVEN, False, "open"),
    (
        EndsAt(x=0, y=0),
        DRIVEN,
        True,
        "The robot stopped 1,000 mm away from the place; at most 50 mm are allowed.",
    ),
    (EndsAt(x=1000, y=0, heading=-265), DRIVEN, True, "met"),
    (
        EndsAt(x=1000, y=0, heading=0),
        DRIVEN,
        True,
        "The robot stopped at the right place, but 100° off its heading; at most 10° are allowed.",
    ),
    (EndsAt(x=0, y=0), [], True, "The robot's place is not known."),
    (Turns(by=100), DRIVEN, True, "met"),
    (Turns(by=100), DRIVEN, False, "open"),
    (Turns(by=-90), DRIVEN, True, "The robot turned by 100° in all instead of -90°."),
    (Ends(), [], True, "met"),
    (Ends(), [], False, "open"),
    (Ends(within=9), [], False, "The program was still running after 9 s."),
    (Ends(within=9), [], True, "The program ended after 10 s; it has to end within 9 s."),
    (Prints(lines=("hello world", "bye")), [HELLO, BYE], False, "met"),
    (Prints(lines=("hello world", "bye")), [HELLO], False, "open"),
    (Prints(lines=("hello world", "bye")), [BYE], True, "The program did not print 'hello world'."),
    (
        Prints(lines=("bye", "hello world")),
        [HELLO, BYE],
        True,
        "The program did not print 'hello world' after 'bye'.",
    ),
    (Uses(construct="repeat"), [], False, "met"),
    (Uses(construct="if"), [], False, "Your program does not use 'if'."),
    (
        Uses(function="f", at_least=2),
        [],
        False,
        "Your program uses your function f only once instead of at least twice.",
    ),
    (
        Uses(construct="loop", at_least=0, at_most=0),
        [],
        False,
        "Your program uses a loop, which is not allowed here.",
    ),
    (Size(blocks=3), [], False, "met"),
    (Size(blocks=2), [], False, "Your program has 3 blocks; at most 2 are allowed."),
]


@pytest.mark.parametrize(("check", "lines", "ended", "expected"), CASES)
def test_a_check_is_met_open_or_failed_for_a_reason(check, lines, ended, expected):
    verdict = found(check, *lines, ended=ended)
    assert (verdict.state if verdict.state != "failed" else told(verdict)) == expected


def test_every_kind_of_check_is_judged():
    kinds = {type(check) for check, *_ in CASES} | {StaysOnLine, Expert}
    assert kinds == {*checks.Check.__args__}


@pytest.mark.parametrize(
    ("event", "line"),
    [
        (GoalReached(name="a"), GOAL),
        (Shown(what="JOY"), JOY),
        (Shown(what="hi*"), {"t": 1, "device": "Screen", "do": "show_text", "args": ["hi there"]}),
        (Said(what="*there"), {"t": 1, "device": "Speaker", "do": "say", "args": ["hi there"]}),
        (Printed(what="hello world"), HELLO),
        (Called(skill="turn"), TURN),
        (Sent(message="go"), {"t": 1, "send": "go", "value": 3}),
        (Collided(thing="b*x"), BUMP),
        (At(x=0, y=0, radius=1), STILL[0]),
    ],
)
def test_an_event_is_found_in_a_run(event, line):
    assert found(Happens(what=event), line).state == "met"
    assert found(Happens(what=event), BYE).state == "failed"


def test_a_robot_comes_into_a_region_as_often_as_it_was_outside():
    way = [{"t": t, "pose": [x, 0, 0]} for t, x in enumerate((0, 500, 0, 0, 500))]
    assert found(Happens(what=At(x=0, y=0), at_least=2, at_most=2), *way).state == "met"


def test_a_robot_stands_when_it_has_not_moved_for_so_long():
    assert found(Happens(what=Stood(seconds=2)), *STILL).at == 2.0
    assert found(Happens(what=Stood(seconds=2.1)), *STILL, report=replace(ENDED, time=2)).state == (
        "failed"
    )
    assert found(Happens(what=Stood(seconds=0.5)), *DRIVEN).state == "failed"


@pytest.mark.parametrize(
    ("report", "reason"),
    [
        ("error", "The program ended with an error."),
        ("time limit", "The program did not end before the time was up."),
        ("killed", "The program did not end by itself."),
    ],
)
def test_a_program_that_does_not_end_by_itself_is_told_why(report, reason):
    assert told(found(Ends(), report=replace(ENDED, ended=report))) == reason


class TestStaysOnLine:
    world = find_world("line")
    start = (-60, -500)

    def way(self, on, off):
        """As many poses on the line, westwards, and off it."""
        x, y = self.start
        poses = [(x - step / 5, y) for step in range(on)] + [(x, y - 300)] * off
        return [{"t": t / 10, "pose": [*pose, 180]} for t, pose in enumerate(poses)]

    def judged(self, on, off, *, least=10, share=0.9, **more):
        check = StaysOnLine(least=least, share=share)
        return found(check, *self.way(on, off), world=self.world, **more)

    def test_it_is_met_when_the_robot_stayed_there_and_drove(self):
        assert self.judged(95, 5).state == "met"

    def test_the_reason_names_both_shares(self):
        expected = "You stayed on the line for 70 % of the time instead of 90 %."
        assert told(self.judged(70, 30)) == expected

    def test_a_share_just_too_small_does_not_read_like_the_one_asked(self):
        assert "89 %" in told(self.judged(896, 104))

    def test_standing_on_the_line_does_not_count(self):
        assert told(self.judged(20, 0)) == "You drove 4 mm; drive at least 10 mm."

    def test_the_time_before_the_line_does_not_count(self):
        before = [{"t": 0.0, "pose": [0, 900, 0]}] * 50
        way = self.way(95, 5)
        check = StaysOnLine(least=10)
        assert found(check, *before, *way, world=self.world).state == "met"

    def test_a_robot_that_never_comes_there_has_failed(self):
        assert told(self.judged(0, 10)) == "The robot never came to the line."

    def test_it_is_open_while_it_can_still_be_met(self):
        assert self.judged(85, 15, ended=False, now=10.0).state == "open"

    def test_it_fails_as_soon_as_it_cannot_be_met_any_more(self):
        verdict = self.judged(60, 40, ended=False, now=10.0)
        assert told(verdict).startswith("You stayed on the line for 60 % of the time so far")

    def test_a_world_without_the_line_is_told(self):
        verdict = found(StaysOnLine(), *STILL, world=find_world("empty"))
        assert told(verdict) == "This world has no line 'line'."


def test_all_goals_are_those_of_the_world():
    world = find_world("square")
    assert told(found(Reaches(), world=world)) == "The goal 'four corners' was not reached."


def test_checks_of_the_program_need_no_run_and_others_wait_for_it():
    step = msgspec.structs.replace(STEP, check=(Size(blocks=9), Ends()))
    assert [one.state for one in judge(step, PROGRAM, None, None)] == ["met", "open"]


def test_checks_of_a_program_that_cannot_be_read_stay_open():
    step = msgspec.structs.replace(STEP, check=(Size(blocks=9),))
    assert [one.state for one in judge(step, None, None, None)] == ["open"]


def test_an_experts_check_is_judged_when_the_run_is_over():
    def experts(check, run):
        return Finding("met", run.now)

    check = Expert(function="f")
    states = [
        found(check, experts=experts).state,
        found(check, experts=experts, ended=False).state,
        found(check).state,
    ]
    assert states == ["met", "open", "open"]


def test_a_check_of_another_robot_looks_at_that_robot():
    lines = [{**HELLO, "robot": "one"}, {**BYE, "robot": "two"}]
    run = replace(evidence(*lines, robot="one"), team={"one": ENDED, "two": ENDED})
    wanted = (
        Happens(what=Printed(what="bye")),
        Happens(what=Printed(what="bye"), robot="two"),
    )
    step = msgspec.structs.replace(STEP, check=wanted)
    assert [one.state for one in judge(step, PROGRAM, run, None)] == ["failed", "met"]


def test_a_step_is_done_without_its_optional_checks():
    step = msgspec.structs.replace(STEP, check=(Ends(), Size(blocks=1, optional=True)))
    assert is_done(judge(step, PROGRAM, evidence(), None))
    assert not is_done(judge(step, PROGRAM, None, None))


@pytest.mark.parametrize(
    "line",
    [
        {"t": "x", "print": "hello world"},
        {"t": 1, "print": 3},
        {"t": 1, "pose": [1, 2]},
        {"t": 1, "pose": [1, 2, None]},
        {"t": 1, "device": "Display", "do": "show_emotion", "args": "joy"},
        {"t": 1, "goal": ["a"], "state": "reached"},
        {"t": 1e300, "pose": [0, 0, 0]},
        {"print": "hello world"},
        [1, 2],
        "print",
        None,
    ],
)
def test_a_line_that_no_run_writes_is_no_evidence(line):
    events = (Printed(what="*"), Shown(what="*"), At(x=0, y=0), GoalReached(name="a"))
    for event in events:
        assert found(
            Happens(what=event), line if isinstance(line, dict) else {"raw": line}
        ).state == ("failed")


def test_a_pattern_with_many_stars_takes_no_time():
    pattern = "*a" * 90 + "*b"
    check = Happens(what=Printed(what=pattern))
    assert found(check, {"t": 1, "print": "a" * 8000}).state == "failed"


def test_events_that_happen_very_often_are_put_in_order_fast():
    calls = [{"t": number / 1000, "call": "turn", "args": []} for number in range(50_000)]
    check = InOrder(events=(Called(skill="turn"),) * 5, within=1)
    assert found(check, *calls).state == "met"
