"""Each rule with a program that calls for it, and with one that does not."""

import pytest

from learnblock.evidence.evidence import evidence_of
from learnblock.i18n import Phrase, languages, translate
from learnblock.i18n.words import words
from learnblock.language import parse
from learnblock.lessons import checks
from learnblock.lessons.hints import Elsewhere, Hint, gives_away, hints
from learnblock.lessons.hints.ranking import WEIGHTS
from learnblock.lessons.judging import judge
from learnblock.lessons.lesson import HintRule, Step
from learnblock.running.result import RunResult
from learnblock.simulator import load_world
from runs import run_file

PARTS = ("look", "part", "how", "because")
PRINTS = checks.Prints(lines=("done",))
AHEAD = checks.EndsAt(x=200, y=0, radius=30)
CORNER = checks.EndsAt(x=200, y=-200, radius=30)
NEVER_HIT = checks.Never(what=checks.Collided())
ENDS = checks.Ends()
USUAL = Elsewhere()


@pytest.fixture
def found(tmp_path):
    """Returns the hints for a program that is run in a world."""

    def find(program, *wanted, world="empty", seconds=15, elsewhere=USUAL, **more):
        source = program if "main:" in program or "when " in program else main(program)
        file = tmp_path / "program.bt"
        file.write_text(source)
        step = Step(title="a", phase="make", text="b", world=world, check=wanted, **more)
        run = run_file(file, "sim-thymio", world=world, seconds=seconds)
        tree, evidence = parse(source), evidence_of(RunResult(run.report, run.trace))
        drawn = load_world(world)
        verdicts = judge(step, tree, evidence, drawn)
        return hints(step, tree, verdicts, evidence, world=drawn, elsewhere=elsewhere)

    return find


def main(body):
    lines = "\n".join(f"    {line}" for line in body.strip().splitlines())
    return f"main:\n{lines}\nend\n"


def rules(given):
    return [one.rule for one in given]


#: A rule, a program that calls for it, one that does not, and the checks.
BUILT = [
    ("error", "x = 1 / 0", "x = 1 / 1", PRINTS),
    ("empty", "pass", "x = 1", PRINTS),
    ("empty-body", "repeat 2:\n    pass\nend", "repeat 2:\n    x = 1\nend", PRINTS),
    (
        "unreachable",
        'forever:\n    function.sleep(1)\nend\nprint("x")',
        'forever:\n    function.sleep(1)\n    break\nend\nprint("x")',
        PRINTS,
    ),
    (
        "not-called",
        "def go():\n    x = 1\nend\n\nmain:\n    y = 1\nend\n",
        "def go():\n    x = 1\nend\n\nmain:\n    go()\nend\n",
        PRINTS,
    ),
    (
        "never-started",
        "when go:\n    deactivate go\nend\n\nwhen start:\n    x = 1\nend\n",
        "when go:\n    deactivate go\nend\n\nwhen start:\n    activate go\nend\n",
        PRINTS,
    ),
    (
        "checked-once",
        "if function.is_front_obstacle(100):\n    function.stop_bot()\nend",
        "while not function.is_front_obstacle(100):\n    function.sleep(1)\nend",
        PRINTS,
    ),
    (
        "unchanged-variable",
        "n = 0\nwhile n < 3:\n    function.sleep(1)\nend",
        "n = 0\nwhile n < 3:\n    n += 1\nend",
        PRINTS,
    ),
    (
        "wrong-side",
        "if function.is_left_ground_line():\n    function.move_right()\nend",
        "if function.is_left_ground_line():\n    function.move_left()\nend",
        PRINTS,
    ),
    (
        "wrong-side",
        "if function.is_left_obstacle():\n    function.turn(-20)\nend",
        "if function.is_left_obstacle():\n    function.turn(20)\nend",
        PRINTS,
    ),
    (
        "opposite-condition",
        "while function.is_front_obstacle(100):\n    function.move_straight(50)\nend",
        "while not function.is_front_obstacle(100):\n    function.move_straight(50)\nend",
        PRINTS,
    ),
    (
        "impossible-condition",
        "x = 4\nif x < 3 and x > 5:\n    x = 1\nend",
        "x = 4\nif x < 3 or x > 5:\n    x = 1\nend",
        PRINTS,
    ),
    (
        "not-used",
        "x = 1",
        "def go():\n    x = 1\nend\n\nmain:\n    go()\nend\n",
        checks.Uses(construct="function"),
    ),
    ("no-loop", "x = 1", "repeat 2:\n    x = 1\nend", checks.Uses(construct="loop")),
    (
        "used-too-often",
        "function.turn(1)\nfunction.turn(2)",
        "function.turn(1)",
        checks.Uses(skill="turn", at_most=1),
    ),
    ("repetition", "a = 1\nb = 2\na = 1\nb = 2", "a = 1\nb = 2\nc = 3", checks.Size(blocks=2)),
    ("too-large", "a = 1\nb = 2\nc = 3", "a = 1", checks.Size(blocks=2)),
]
RAN = [
    (
        "loop-without-wait",
        "repeat 3:\n    function.move_straight(50)\nend",
        "repeat 3:\n    function.move_straight(50)\n    function.sleep(0.1)\nend",
        PRINTS,
    ),
    (
        "no-wait",
        "function.move_straight(50)\nfunction.stop_bot()",
        "function.move_straight(50)\nfunction.sleep(1)\nfunction.stop_bot()",
        AHEAD,
    ),
    ("never-runs", "if 1 > 2:\n    x = 1\nend", "if 1 < 2:\n    x = 1\nend", PRINTS),
    (
        "motors-on",
        "function.move_straight(50)\nfunction.sleep(3)",
        "function.move_straight(50)\nfunction.sleep(3)\nfunction.stop_bot()",
        AHEAD,
    ),
    (
        "never-ends",
        "forever:\n    function.sleep(1)\nend",
        "forever:\n    break\nend\nx = 1 / 0",
        ENDS,
    ),
    ("too-early", "x = 1", "forever:\n    function.sleep(1)\nend", PRINTS),
]
DRIVEN = [
    ("value-too-small", "function.drive_distance(100)", "function.drive_distance(400)", AHEAD),
    ("value-too-large", "function.drive_distance(400)", "function.drive_distance(100)", AHEAD),
    ("wrong-sign", "function.drive_distance(-200)", "function.drive_distance(100)", AHEAD),
    (
        "wrong-direction",
        "function.drive_distance(200)\nfunction.turn(-90)\nfunction.drive_distance(200)",
        "function.drive_distance(200)\nfunction.turn(90)\nfunction.drive_distance(100)",
        CORNER,
    ),
    (
        "no-turn",
        "function.drive_distance(200)\nfunction.sleep(1)\nfunction.drive_distance(200)",
        "function.drive_distance(200)\nfunction.turn(90)\nfunction.drive_distance(100)",
        CORNER,
    ),
    ("never-moved", "function.sleep(1)", "function.drive_distance(100)", AHEAD),
    ("wrong-direction", "function.turn(-90)", "function.turn(45)", checks.Turns(by=90)),
    ("value-too-small", "function.turn(45)", "function.turn(120)", checks.Turns(by=90)),
    ("no-turn", "function.drive_distance(50)", "function.turn(45)", checks.Turns(by=90)),
]
SHOWN = [
    (
        "too-few-times",
        'print("done")',
        'print("x")',
        checks.Happens(what=checks.Printed(what="done"), at_least=2),
    ),
    (
        "too-many-times",
        'repeat 3:\n    print("done")\nend',
        'repeat 2:\n    print("done")\nend',
        checks.Happens(what=checks.Printed(what="done"), at_most=2),
    ),
    ("text-almost", 'print("dne")', 'print("something else")', PRINTS),
    ("wrong-text", 'print("something else")', "x = 1", PRINTS),
    ("not-shown", "x = 1", 'print("something else")', PRINTS),
    ("wrong-order", 'print("b")\nprint("a")', 'print("a")', checks.Prints(lines=("a", "b"))),
    (
        "event-missing",
        "x = 1",
        "function.turn(10)",
        checks.Happens(what=checks.Called(skill="turn"), at_least=2),
    ),
    ("forbidden", 'print("done")', "x = 1", checks.Never(what=checks.Printed(what="done"))),
    (
        "never-stands",
        "function.drive_distance(50)",
        "function.sleep(2)",
        checks.Happens(what=checks.Stood(seconds=1)),
    ),
]
CASES = [*BUILT, *RAN, *DRIVEN, *SHOWN]


@pytest.mark.parametrize(
    ("rule", "wrong", "other", "check"), CASES, ids=[f"{one[0]}-{n}" for n, one in enumerate(CASES)]
)
def test_a_rule_is_found_only_where_it_fits(found, rule, wrong, other, check):
    assert f"hint-{rule}" in rules(found(wrong, check))
    assert f"hint-{rule}" not in rules(found(other, check))


def test_where_nothing_else_fits_the_check_itself_is_the_hint(found):
    assert rules(found("function.drive_distance(100)", AHEAD))[-1] == "hint-look-again"


def test_a_robot_that_asks_nothing_and_bumps_into_a_wall_is_told_to_look(found):
    program = "function.move_straight(150)\nfunction.sleep(7)"
    given = found(program, NEVER_HIT, world="parking", variants=3)
    assert given[0].rule == "hint-never-asks"
    assert "hint-collision" in rules(given)


def test_a_program_without_line_sensors_is_told_to_look_for_the_line(found):
    program = "function.move_straight(50)\nfunction.sleep(7)"
    assert found(program, checks.StaysOnLine(), world="line")[0].rule == "hint-never-asks"


def follow(left, right):
    return f"""forever:
    if function.is_left_ground_line():
        function.set_move(30, {left})
    elif function.is_right_ground_line():
        function.set_move(30, {right})
    else:
        function.set_move(50, 0)
    end
end"""


def test_a_program_that_sees_the_line_on_both_sides_and_loses_it_is_told_to_watch(found):
    on_line = checks.StaysOnLine(least=200)
    assert "hint-lost-line" in rules(found(follow(-1, 1), on_line, world="line", seconds=25))
    assert found(follow(-20, 20), on_line, world="line", seconds=8) == ()


def test_a_program_that_works_only_in_the_world_as_drawn_is_told_so(found):
    elsewhere = Elsewhere(is_variant=True, passes_usually=True)
    given = found("function.drive_distance(100)", AHEAD, elsewhere=elsewhere)
    assert given[0].rule == "hint-only-here"


def test_a_program_that_works_only_on_one_robot_is_told_so(found):
    elsewhere = Elsewhere(is_other_robot=True, passes_usually=True)
    given = found("function.drive_distance(100)", AHEAD, elsewhere=elsewhere)
    assert given[0].rule == "hint-other-robot"


def test_a_tour_names_the_first_turn_that_goes_wrong(found):
    program = "repeat 4:\n    function.drive_distance(200)\n    function.turn(-90)\nend"
    given = found(program, checks.Reaches(), world="square", seconds=40)
    assert (given[0].rule, given[0].lines) == ("hint-wrong-direction", (4,))


def test_a_loop_with_one_round_too_few_is_found_by_the_way_that_is_missing(found):
    program = "repeat 3:\n    function.drive_distance(200)\n    function.turn(90)\nend"
    given = found(program, checks.Reaches(), world="square", seconds=40)
    assert (given[0].rule, given[0].lines) == ("hint-too-few-times", (2,))


def test_the_same_run_always_gets_the_same_hints(found):
    program = "function.move_straight(50)\nfunction.stop_bot()"
    assert found(program, AHEAD, ENDS) == found(program, AHEAD, ENDS)


def test_a_program_that_passes_gets_no_hint(found):
    assert found("function.drive_distance(200)", AHEAD, ENDS) == ()


def test_the_teachers_rules_come_first_in_their_order(found):
    hint = (
        HintRule(check="ends_at", sign="wrong_sign", say=("never",)),
        HintRule(check="ends_at", sign="value_too_small", say=("small",)),
        HintRule(check="ends_at", say=("any",)),
    )
    given = found("function.drive_distance(100)", AHEAD, hint=hint)
    assert rules(given)[:3] == ["teacher-2", "teacher-3", "hint-value-too-small"]
    assert given[0].levels == ("small",)


def test_a_rule_of_the_teacher_for_a_named_check_leaves_others_alone(found):
    hint = (HintRule(check="home", say=("home",)),)
    named = checks.EndsAt(name="home", x=200, y=0, radius=30)
    assert rules(found("x = 1", AHEAD, hint=hint))[0] != "teacher-1"
    assert rules(found("x = 1", named, hint=hint))[0] == "teacher-1"


#: A sign, what it is about, a program with it, one without it, and the check.
SIGNS = [
    ("never_asks", None, "x = 1", "function.is_front_obstacle(100)", AHEAD),
    ("never_asks", "is_there_ground", "x = 1", "x = function.is_there_ground()", AHEAD),
    ("never_runs", "turn", "if 1 > 2:\n    function.turn(9)\nend", "function.turn(9)", PRINTS),
    ("loop_without_wait", None, "function.move_straight(50)\nfunction.stop_bot()", "x = 1", AHEAD),
    ("wrong_sign", None, "function.drive_distance(-200)", "function.drive_distance(100)", AHEAD),
    ("value_too_small", None, "function.drive_distance(100)", "x = 1", AHEAD),
    ("value_too_large", None, "function.drive_distance(300)", "x = 1", AHEAD),
    ("value_too_large", "turn", "function.turn(20)", "function.turn(2)", checks.Turns(by=9)),
    ("no_loop", None, "x = 1", "repeat 2:\n    x = 1\nend", AHEAD),
    ("too_early", None, "x = 1", "x = 1 / 0", PRINTS),
    ("too_late", None, "forever:\n    function.sleep(1)\nend", "x = 1", PRINTS),
    ("error", None, "x = 1 / 0", "x = 1", AHEAD),
    ("error", "mean", "x = mean([])", "x = 1 / 0", AHEAD),
    ("empty", None, "pass", "x = 1", AHEAD),
]


@pytest.mark.parametrize("case", SIGNS, ids=[f"{one[0]}-{n}" for n, one in enumerate(SIGNS)])
def test_a_sign_of_the_teachers_is_seen_where_it_is(found, case):
    sign, about, seen, unseen, check = case
    hint = (HintRule(sign=sign, about=about, say=("look",)),)
    assert "teacher-1" in rules(found(seen, check, hint=hint))
    assert "teacher-1" not in rules(found(unseen, check, hint=hint))


def test_a_collision_is_a_sign(found):
    hint = (HintRule(sign="collision", say=("look",)),)
    program = "function.move_straight(150)\nfunction.sleep(7)"
    assert rules(found(program, NEVER_HIT, world="parking", hint=hint))[0] == "teacher-1"


@pytest.mark.parametrize("rule", WEIGHTS)
def test_every_rule_has_words_in_every_language(rule):
    values = dict.fromkeys(("what", "name", "where", "thing", "joined", "kind"), "x")
    values |= {"message": "x", "reason": "x", "time": 1.0}
    for language in languages():
        assert all(words(f"hint-{rule}-{part}", values, language) for part in PARTS)


def test_a_hint_that_contains_a_statement_of_the_solution_gives_it_away(found):
    solution = parse(main("function.drive_distance(200)"))
    rule = HintRule(say=("Write drive_distance( 200 ) there.",))
    (given, *_) = found("x = 1", AHEAD, hint=(rule,))
    assert gives_away(given, solution) == "function.drive_distance(200)"


def test_a_statement_in_a_value_that_no_words_show_gives_it_away():
    solution = parse(main("function.drive_distance(200)"))
    inner = Phrase("hint-where-line", line="function.drive_distance(200)")
    for value in (inner, (inner,), "drive_distance(200)"):
        level = Phrase("hint-empty-look", wanted=value)
        given = Hint("hint-empty", (level,), Phrase("hint-empty-because"))
        assert gives_away(given, solution) == "function.drive_distance(200)"


def test_no_hint_of_ours_gives_a_solution_away(found):
    solution = parse(main("function.move_straight(50)\nfunction.sleep(4)\nfunction.stop_bot()"))
    for program in ("function.move_straight(50)\nfunction.stop_bot()", "x = 1 / 0", "pass"):
        for given in found(program, AHEAD, ENDS):
            assert gives_away(given, solution) is None


def test_a_hint_says_why_it_was_chosen(found):
    for given in found("function.drive_distance(100)", AHEAD):
        assert isinstance(given.because, Phrase)
        assert translate(given.because, "es") != translate(given.because, "en")


def lines_of(given, rule):
    """The lines that the hint of a rule names."""
    return next(one.lines for one in given if one.rule == f"hint-{rule}")


def test_a_robot_that_turns_away_too_early_is_told_of_the_limit_in_its_decision(found):
    program = (
        "forever:\n    if function.is_front_obstacle(100):\n        function.turn(90)\n"
        "    else:\n        function.move_straight(80)\n    end\nend"
    )
    way = checks.InOrder(events=(checks.At(x=480, y=0, radius=30), checks.At(x=410, y=-300)))
    given = found(program, way, world="parking", seconds=20)
    assert lines_of(given, "value-too-large") == (3,)
    assert "hint-wrong-order" not in rules(given)


def test_a_turn_too_many_after_a_loop_is_named_and_not_one_inside(found):
    program = (
        "repeat 4:\n    function.drive_distance(100)\n    function.turn(90)\nend\nfunction.turn(90)"
    )
    home = checks.EndsAt(x=0, y=0, radius=60, heading=0)
    assert lines_of(found(program, home), "value-too-large") == (6,)
    assert lines_of(found(program, checks.Turns(by=360)), "value-too-large") == (6,)


def test_a_drive_too_many_after_a_loop_is_named_and_not_one_inside(found):
    program = "repeat 2:\n    function.drive_distance(100)\nend\nfunction.drive_distance(90)"
    given = found(program, checks.Drives(at_most=220))
    assert lines_of(given, "value-too-large") == (5,)
