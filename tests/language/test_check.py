from pathlib import Path

import pytest

from learnblock.blocks.configuration import BlockConfiguration, Configurations, Parameter
from learnblock.fields import Range
from learnblock.language import check, from_python, parse

CASES = Path(__file__).parent.parent / "cases"
EBO = frozenset(
    ("Base:ROBOT", "Camera:ROBOT", "Display:ROBOT", "JointMotor:CAMERA", "Gyroscope:Z_AXIS")
)


@pytest.fixture
def said(skills):
    """What is said of a program: line, severity and code of each diagnostic."""

    def of(text, devices=None):
        found = check(parse(text), skills, devices)
        return [(one.line, one.severity, one.code) for one in found]

    return of


@pytest.mark.parametrize("case", ["square_trajectory", "reaction_to_tags", "line_follower_ebo"])
def test_nothing_is_wrong_with_the_papers_programs_on_ebo(case, said):
    assert [] == said((CASES / case / "program.bt").read_text("utf-8"), EBO)


def test_a_device_that_only_an_effect_needs_is_a_warning(said, thymio):
    text = (CASES / "line_follower_thymio" / "program.bt").read_text("utf-8")
    assert [(2, "warning", "missing-device")] == said(text, thymio)


def test_a_question_that_can_never_be_answered_is_an_error(said, thymio):
    text = (CASES / "line_follower_ebo" / "program.bt").read_text("utf-8")
    found = [(line, severity) for line, severity, _ in said(text, thymio)]
    assert [(2, "warning"), (4, "error"), (7, "error"), (10, "error")] == found


def test_a_robot_that_cannot_move_is_an_error(said):
    assert [(1, "error", "missing-device")] == said("function.stop_bot()", frozenset())


@pytest.mark.parametrize(
    ("arguments", "advice"),
    [
        ("120", "`speed` of `function.paint` is 120 here; it goes from 0 to 100"),
        ("-1", "`speed` of `function.paint` is -1 here; it goes from 0 to 100"),
        ('5, "wide"', "is 'wide' here; the choices are 'thin', 'thick'"),
        ('5, "thin", "red"', "is 'red' here; a colour is a text such as \"#ff8800\""),
    ],
)
def test_a_constant_that_a_field_does_not_offer_is_a_warning(arguments, advice):
    parameters = (
        Parameter("speed", "float", range=Range(0, 100)),
        Parameter("brush", "choice", "thin", choices=("thin", "thick")),
        Parameter("colour", "colour", "#000000"),
    )
    paint = BlockConfiguration("others", "Paint", "paint", parameters)
    (found,) = check(parse(f"function.paint({arguments})\n"), {"paint": paint})

    assert ("unusual-value", "warning") == (found.code, found.severity)
    assert advice in found.message


def test_what_a_field_offers_is_fine():
    parameters = (Parameter("speed", "float", range=Range(0, 100)), Parameter("way", "angle", 0))
    paint = BlockConfiguration("others", "Paint", "paint", parameters)

    assert [] == check(
        parse("x = 1\nfunction.paint(100, 720)\nfunction.paint(x)\n"), {"paint": paint}
    )


def test_a_skill_of_a_file_that_is_wrong_is_told_with_what_is_wrong():
    reason = "dance.py, line 3: this is no Python"
    skills = Configurations({}, {"waltz": reason}, ())
    (found,) = check(parse("function.waltz()\n"), skills)

    assert "unknown-skill" == found.code
    assert found.message.endswith(
        "the file that it stands in is wrong: dance.py, line 3: this is no Python"
    )


def test_without_a_chosen_robot_no_device_is_missing(said):
    assert [] == said("function.look_floor()")


@pytest.mark.parametrize(
    ("text", "code", "advice"),
    [
        ("total = 1\nprint(totl)\n", "unknown-name", "did you mean `total`?"),
        ("x = true\n", "unknown-name", "write `True`"),
        ("function.trun(90)\n", "unknown-skill", "did you mean `turn`?"),
        ("def go(): pass end\ngoo()\n", "unknown-function", "did you mean `go`?"),
        ("stop_bot()\n", "unknown-function", "`function.stop_bot(...)`"),
        ("function.turn()\n", "missing-argument", "also needs `angle`"),
        ("function.turn(1, 2)\n", "argument-count", "takes 1 argument (angle), not 2"),
        ("function.move_straight(speed=9)\n", "unknown-argument", "did you mean `advSpeed`?"),
        ('function.turn("90")\n', "wrong-type", "write 90 without quotes"),
        ("x = sqrt(1, 2)\n", "argument-count", "`sqrt` takes 1 argument, not 2"),
        ("when follow: activate folow end\n", "unknown-when", "did you mean `follow`?"),
        ("when follow: print(state_folow) end\n", "unknown-when", "did you mean `follow`?"),
        ("print(x)\nx = 1\n", "unset-variable", "write `x = ...` above"),
        ("while True: pass end\nx = 1\n", "unreachable", "`while True` never ends in line 1"),
        ("repeat 3:\n    break\n    x = 1\nend\n", "unreachable", "`break` leaves in line 2"),
        ("if function.is_tag(1): x = 1 end\n", "sensor-outside-loop", "use a `when`"),
    ],
)
def test_each_mistake_is_named_with_what_to_do(text, code, advice, skills):
    (diagnostic,) = check(parse(text), skills)
    assert (code, True) == (diagnostic.code, advice in diagnostic.message)


def test_a_file_knows_its_own_name(skills):
    skeleton = "from learnblock.robots.ebo import Robot\n\nrobot = Robot()\n\n"
    program = from_python(skeleton + "if __name__ == '__main__':\n    robot.turn(90)\n")
    assert [] == check(program, skills)


def test_diagnostics_stand_in_order_of_the_text(said):
    text = "x = y\nwhile True:\n    function.foo(z)\n    activate a\nend\nfoo()\n"
    lines = [line for line, _, _ in said(text)]
    assert sorted(lines) == lines
    assert {1, 3, 4, 6} == set(lines)


@pytest.mark.parametrize(
    "text",
    [
        "def f(a): return a + b end\nb = 1\nprint(f(2))\n",
        "when start: total = 0 end\nwhen run: total += 1 end\n",
        "for i from 1 to 3: print(i) end\n",
        "for x in [1]: print(x) end\n",
        "python:\n    import os\n    n, m = 1, 2\n    def g(): pass\nend\nprint(n, m)\ng()\n",
        'import "dance"\nwaltz(tempo)\n',
        "while True:\n    if function.is_any_tag(): break end\nend\nfunction.stop_bot()\n",
        "def f(): return 1 end\nprint(f())\n",
        "x = `[i for i in range(3)]`\nprint(x)\n",
        "when seen = function.is_any_tag(): print(state_seen, time_seen) end\n",
        "state_of_mind = 1\nprint(state_of_mind)\n",
        "def f(state_x): return state_x end\nprint(f(1))\n",
        "x = 1\nif x == 1: x = 2 end\n",
        'robot(world="line")\nx = 1\n',
    ],
)
def test_what_is_right_is_left_alone(text, said):
    assert [] == said(text)


def test_a_variable_is_set_before_it_is_read(said):
    assert [(1, "error", "unset-variable")] == said("x += 1\nx = 1\n")
    assert [(1, "error", "unset-variable")] == said("print(x)\nmain:\n    x = 1\nend\n")


def test_a_main_after_an_endless_loop_is_never_reached(said):
    text = "while True: pass end\nmain:\n    pass\nend\n"
    assert [(3, "warning", "unreachable")] == said(text)


def test_deep_programs_are_too_much_for_python_only(said):
    ifs = "x = 1\n" + "if x:\n" * 100 + "x = 2\n" + "end\n" * 100
    assert ["too-deep"] == [code for _, _, code in said(ifs)]
    loops = "repeat 1:\n" * 21 + "pass\n" + "end\n" * 21
    assert ["too-deep"] == [code for _, _, code in said(loops)]


def test_raw_python_must_be_python(said):
    assert [(3, "error", "invalid-python")] == said("x = 1\npython:\n    y = = 1\nend\n")
    assert [(2, "error", "invalid-python")] == said("python:\n    y = = 1\nend\n")
