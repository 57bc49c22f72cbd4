"""The words and values that a line of Python is split into for its block."""

import ast

import pytest

from learnblock.language.python.forms import filled, value_form


@pytest.mark.parametrize(
    ("text", "values"),
    [
        ('f"{x:.1f}"', ["x"]),
        ('f"é {x.y()} {z!r} {a=} {b:>{w}}"', ["x.y()", "z", "a", "b", "w"]),
        ('"a" f"{x.y}"', ["x.y"]),
        ("table[:, 0]", ["table", "0"]),
        ("table[*a, 1]", ["table", "a", "1"]),
    ],
)
def test_the_values_of_an_expression_have_sockets(text, values):
    form = value_form(text)
    assert form is not None
    assert [ast.unparse(value) for value in form.values] == values
    assert filled(form.words, values, value_form) == text


@pytest.mark.parametrize(
    ("value", "written"),
    [
        ("a != b", 'f"{a != b}"'),
        ("lambda: 1", 'f"{(lambda: 1)}"'),
        ("{1: 2}", 'f"{({1: 2})}"'),
        ('ages["Ana"]', "f\"{ages['Ana']}\""),
    ],
)
def test_a_value_that_is_put_into_an_f_string_keeps_its_meaning(value, written):
    form = value_form('f"{x.y()}"')
    assert form is not None
    assert filled(form.words, [value], value_form) == written
