import pytest

from learnblock.errors import LearnBlockError, UnknownNameError
from learnblock.language import format as format_program
from learnblock.language import parse, to_python
from learnblock.language.rename import rename

PROGRAM = """\
speed = 3

def turn_by(angle):
    function.turn(angle * speed)
    for i from 1 to 3:
        print(i, angle)
    end
end

when seen = function.is_any_tag():
    turn_by(angle=90)
    activate go
end

when go:
    x = state_seen and time_seen > 3
end
"""


def renamed(text, *how):
    return format_program(rename(parse(text), *how))


def test_a_variable_is_renamed_wherever_it_is_set_or_read():
    expected = PROGRAM.replace("speed", "factor")
    assert expected == renamed(PROGRAM, "variable", "speed", "factor")


def test_a_parameter_is_renamed_in_its_function_and_where_it_is_given_by_name():
    assert PROGRAM.replace("angle", "degrees") == renamed(PROGRAM, "variable", "angle", "degrees")


def test_what_a_for_counts_with_is_renamed():
    expected = PROGRAM.replace("for i", "for round").replace("(i,", "(round,")
    assert expected == renamed(PROGRAM, "variable", "i", "round")


def test_a_function_is_renamed_with_its_calls():
    assert PROGRAM.replace("turn_by", "go_round") == renamed(
        PROGRAM, "function", "turn_by", "go_round"
    )


def test_a_when_is_renamed_with_its_state_and_its_time():
    assert PROGRAM.replace("seen", "near") == renamed(PROGRAM, "when", "seen", "near")
    assert PROGRAM.replace("go:", "drive:").replace("te go", "te drive") == renamed(
        PROGRAM, "when", "go", "drive"
    )


SCOPES = """\
x = 1

def f(x):
    print(x)
end

def g():
    print(x)
    f(x=x)
end
"""


def test_a_variable_of_the_whole_program_leaves_a_parameter_of_that_name():
    expected = SCOPES.replace("x = 1", "y = 1").replace(
        "print(x)\n    f(x=x)", "print(y)\n    f(x=y)"
    )
    assert expected == renamed(SCOPES, "variable", "x", "y")


def test_a_parameter_leaves_the_variable_of_the_whole_program_of_that_name():
    expected = SCOPES.replace("f(x):\n    print(x)", "f(y):\n    print(y)").replace("x=x", "y=x")
    assert expected == renamed(SCOPES, "variable", "f.x", "y")


def test_a_variable_in_raw_python_is_renamed_too():
    text = "x = 1\npython:\n    y = [x for _ in 'x'] + [a.x, x]\nend\nz = `{x: 'x'}`\n"
    expected = "n = 1\npython:\n    y = [n for _ in 'x'] + [a.x, n]\nend\nz = `{n: 'x'}`\n"
    assert expected == renamed(text, "variable", "x", "n")


def test_raw_python_that_names_it_intricately_is_left_to_its_author():
    text = "x = 1\npython:\n    def f():\n        global x\n        x = 2\nend\n"
    with pytest.raises(LearnBlockError, match="the Python in line 2 uses `x`"):
        renamed(text, "variable", "x", "n")


def test_a_name_that_python_reserves_may_be_chosen():
    program = rename(parse(PROGRAM), "variable", "speed", "class")
    assert "class_ = 3" in to_python(program).text


@pytest.mark.parametrize(
    ("how", "message"),
    [
        (("variable", "speed", "2x"), "`2x` is no name"),
        (("variable", "speed", ""), "`` is no name"),
        (("variable", "speed", "while"), "`while` is a word of the language"),
        (("variable", "speed", "x"), "there is a variable `x` already"),
        (("variable", "speed", "angle"), "there is a variable `angle` already"),
        (("variable", "speed", "turn_by"), "there is a function `turn_by` already"),
        (("variable", "speed", "state_go"), "asks for the state of a `when`"),
        (("function", "turn_by", "print"), "`print` is a function of the language"),
        (("function", "turn_by", "speed"), "there is a variable `speed` already"),
        (("when", "seen", "go"), "there is a `when go` already"),
        (("when", "go", "start"), "only `when start` runs at the start"),
    ],
)
def test_a_name_that_will_not_do_is_refused_with_a_sentence(how, message):
    with pytest.raises(LearnBlockError, match=message):
        renamed(PROGRAM, *how)


@pytest.mark.parametrize("sort", ["variable", "function", "when"])
def test_what_is_not_there_is_not_renamed(sort):
    with pytest.raises(UnknownNameError, match=f"there is no {sort} `sped`"):
        renamed(PROGRAM, sort, "sped", "y")


def test_a_when_does_not_take_the_name_of_a_variable_that_looks_like_its_state():
    text = "state_near = 1\nwhen seen:\n    pass\nend\n"
    with pytest.raises(LearnBlockError, match="there is a variable `state_near` already"):
        renamed(text, "when", "seen", "near")


def test_renaming_forth_and_back_changes_nothing():
    program = parse(PROGRAM)
    for sort, name in (("variable", "speed"), ("function", "turn_by"), ("when", "seen")):
        assert program == rename(rename(program, sort, name, "other"), sort, "other", name)
