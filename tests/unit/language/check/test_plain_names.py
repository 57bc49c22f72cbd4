"""Names that a program without a robot uses and sets nowhere."""

import pytest

from learnblock.blocks import builtin
from learnblock.language import check, from_python, parse


def messages(text):
    return [str(one.message) for one in check(parse("without robot\n" + text), builtin())]


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("count = 3\nprint(cuont)", "'cuont' has no value. Did you mean 'count'?"),
        ("pritn(3)", "There is no function 'pritn'. Did you mean 'print'?"),
        (
            "count = 3\nprint(`[each for each in cuont]`)",
            "'cuont' has no value. Did you mean 'count'?",
        ),
        ("count = 3\n`assert cuont`", "'cuont' has no value. Did you mean 'count'?"),
        (
            "def show(value):\n    print(valeu)\nend\nshow(3)",
            "'valeu' has no value. Did you mean 'value'?",
        ),
    ],
)
def test_a_misspelled_name_is_reported_once(text, message):
    assert [message] == messages(text)
    assert [message] == messages(f"{text}\n{text.splitlines()[-1]}")


@pytest.mark.parametrize(
    "text",
    [
        "print(isinstance(3, int), ValueError, __name__)",
        "`import math as m`\nprint(`m.pi`)",
        "`from turtle import *`\nforward(100)",
        '`exec("count = 3")`\nprint(count)',
        "`with open(path) as file`:\n    print(file)\nend\npath = 3",
        "`def f(*values, width=3)`:\n    print(values, width)\nend\n`f(1)`",
        "print(`[each for each in range(3)]`, `(n := 3)`, n)",
        "`try`:\n    print(3)\n`except ValueError as problem`:\n    print(problem)\nend",
        "lambda = 3\nprint(lambda)",
        "int = 3\n`def f(value=int_)`:\n    print(value)\nend",
    ],
)
def test_a_name_that_python_may_know_is_not_reported(text):
    assert [] == messages(text)


def test_a_misspelled_name_in_python_is_reported_there():
    text = "count = 3\nprint(cuont)\n"
    (found,) = check(from_python(text), builtin(), python=text)
    assert ("'cuont' has no value. Did you mean 'count'?", 2) == (str(found.message), found.line)
