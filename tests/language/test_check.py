from pathlib import Path

import pytest

from learnblock.language import check, parse

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


def test_without_a_chosen_robot_no_device_is_missing(said):
    assert [] == said("function.look_floor()")


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
