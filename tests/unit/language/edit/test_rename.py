import pytest

from learnblock.errors import LearnBlockError, UnknownNameError
from learnblock.i18n import Phrase
from learnblock.language import format as format_program
from learnblock.language import from_python, parse, to_python
from learnblock.language.edit.rename import rename

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


def test_a_variable_is_renamed_everywhere():
    expected = PROGRAM.replace("speed", "factor")
    assert expected == renamed(PROGRAM, "variable", "speed", "factor")


def test_a_parameter_is_renamed_in_its_function_and_in_keyword_arguments():
    assert PROGRAM.replace("angle", "degrees") == renamed(PROGRAM, "variable", "angle", "degrees")


def test_a_loop_variable_is_renamed():
    expected = PROGRAM.replace("for i", "for round").replace("(i,", "(round,")
    assert expected == renamed(PROGRAM, "variable", "i", "round")


def test_a_local_variable_is_renamed_in_its_function_alone():
    text = "x = 1\n\ndef f():\n    local x = 2\n    return x\nend\n"
    expected = text.replace("local x", "local y").replace("return x", "return y")
    assert expected == renamed(text, "variable", "f.x", "y")


def test_a_variable_of_a_loop_that_takes_values_apart_is_renamed():
    text = "for name, age in items(ages):\n    print(name, age)\nend\n"
    assert renamed(text, "variable", "age", "years") == text.replace("age ", "years ").replace(
        "age)", "years)"
    )


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


def test_renaming_a_global_variable_keeps_a_parameter_of_the_same_name():
    expected = SCOPES.replace("x = 1", "y = 1").replace(
        "print(x)\n    f(x=x)", "print(y)\n    f(x=y)"
    )
    assert expected == renamed(SCOPES, "variable", "x", "y")


def test_renaming_a_parameter_keeps_a_global_variable_of_the_same_name():
    expected = SCOPES.replace("f(x):\n    print(x)", "f(y):\n    print(y)").replace("x=x", "y=x")
    assert expected == renamed(SCOPES, "variable", "f.x", "y")


def test_a_variable_in_raw_python_is_renamed_too():
    text = "x = 1\npython:\n    y = [x for _ in 'x'] + [a.x, x]\nend\nz = `{x: 'x'}`\n"
    expected = "n = 1\npython:\n    y = [n for _ in 'x'] + [a.x, n]\nend\nz = `{n: 'x'}`\n"
    assert expected == renamed(text, "variable", "x", "n")


def test_a_variable_that_patterns_set_is_renamed_too():
    text = """x = [1]
`match x`:
    `case [x, *_] | [*_, 'x', x] if x.x`:
        print(x)
    `case {"x": int() as x} | {"y": 1, **x}`:
        print(`x.x`)
end
"""
    expected = """wide = [1]
`match wide`:
    `case [wide, *_] | [*_, 'x', wide] if wide.x`:
        print(wide)
    `case {"x": int() as wide} | {"y": 1, **wide}`:
        print(`wide.x`)
end
"""
    assert expected == renamed(text, "variable", "x", "wide")


def test_raw_python_with_an_unsupported_use_of_the_name_is_refused():
    text = "x = 1\npython:\n    import x.y\nend\n"
    with pytest.raises(LearnBlockError) as error:
        renamed(text, "variable", "x", "n")
    assert error.value.phrase == Phrase("edit-used-in-line", name="x", line="2")


def test_a_name_that_python_reserves_may_be_chosen():
    program = rename(parse(PROGRAM), "variable", "speed", "class")
    assert "class_ = 3" in to_python(program).text


@pytest.mark.parametrize(
    ("how", "message"),
    [
        (("variable", "speed", "2x"), Phrase("edit-bad-name", name="2x")),
        (("variable", "speed", ""), Phrase("edit-bad-name", name="")),
        (("variable", "speed", "while"), Phrase("blocktext-reserved-word", word="while")),
        (("variable", "speed", "x"), Phrase("edit-variable-exists", name="x")),
        (("variable", "speed", "angle"), Phrase("edit-variable-exists", name="angle")),
        (("variable", "speed", "turn_by"), Phrase("edit-function-exists", name="turn_by")),
        (
            ("variable", "speed", "state_go"),
            Phrase("edit-name-of-state", name="state_go", when="go"),
        ),
        (("function", "turn_by", "print"), Phrase("edit-language-function", name="print")),
        (("function", "turn_by", "speed"), Phrase("edit-variable-exists", name="speed")),
        (("when", "seen", "go"), Phrase("edit-when-exists", name="go")),
        (("when", "go", "start"), Phrase("edit-when-start")),
    ],
)
def test_a_new_name_that_is_taken_or_not_valid_is_refused(how, message):
    with pytest.raises(LearnBlockError) as error:
        renamed(PROGRAM, *how)
    assert error.value.phrase == message


@pytest.mark.parametrize("sort", ["variable", "function", "when"])
def test_a_missing_name_cannot_be_renamed(sort):
    with pytest.raises(UnknownNameError, match="'sped'"):
        renamed(PROGRAM, sort, "sped", "y")


def test_a_when_cannot_have_a_name_whose_state_is_a_variable():
    text = "state_near = 1\nwhen seen:\n    pass\nend\n"
    with pytest.raises(LearnBlockError) as error:
        renamed(text, "when", "seen", "near")
    assert error.value.phrase == Phrase("edit-variable-exists", name="state_near")


def test_renaming_back_restores_the_program():
    program = parse(PROGRAM)
    for sort, name in (("variable", "speed"), ("function", "turn_by"), ("when", "seen")):
        assert program == rename(rename(program, sort, name, "other"), sort, "other", name)


PLAIN = """\
import turtle
import math as maths


class Dog:
    def bark(self, times=1):
        print(times, count)


def show(value, width=2):
    global count
    try:
        count += maths.floor(value)
    except ValueError as error:
        print(error)


count = 3
with open("p.txt") as file:
    show(count, width=len(file.read()))
turtle.forward(count)
dog = Dog()
"""


@pytest.mark.parametrize(
    ("sort", "name", "changed"),
    [
        ("variable", "count", {7: 1, 11: 1, 13: 1, 18: 1, 20: 1, 21: 1}),
        ("variable", "error", {14: 1, 15: 1}),
        ("variable", "file", {19: 1, 20: 1}),
        ("variable", "maths", {2: 1, 13: 1}),
        ("variable", "width", {10: 1, 20: 1}),
        ("variable", "value", {10: 1, 13: 1}),
        ("function", "show", {10: 1, 20: 1}),
        ("function", "Dog", {5: 1, 22: 1}),
        ("variable", "dog", {22: 1}),
    ],
)
def test_a_name_of_plain_python_is_renamed_wherever_it_is(sort, name, changed):
    lines = to_python(rename(from_python(PLAIN), sort, name, "other")).text.splitlines()
    before = PLAIN.splitlines()
    different = {
        number: line.count("other")
        for number, (line, old) in enumerate(zip(lines, before, strict=True), 1)
        if line != old
    }
    assert changed == different
    assert PLAIN == "\n".join([*lines, ""]).replace("other", name)


def test_a_renamed_module_is_imported_by_another_name():
    lines = to_python(rename(from_python(PLAIN), "variable", "turtle", "pen")).text.splitlines()
    assert ["import turtle as pen", "pen.forward(count)"] == [lines[0], lines[20]]
