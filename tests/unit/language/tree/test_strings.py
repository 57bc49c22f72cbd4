import ast

import pytest
from hypothesis import given
from hypothesis import strategies as st

from learnblock.errors import EscapeError
from learnblock.language.tree.strings import quote, unquote

CHARACTERS = st.characters(exclude_categories=()) | st.sampled_from("'\"\\\n\r\t\0\x7f")


@given(st.text(CHARACTERS))
def test_a_string_survives_quoting(value):
    assert value == unquote(quote(value))


@given(st.text(CHARACTERS))
def test_python_reads_our_quotes_as_we_do(value):
    assert value == ast.literal_eval(quote(value))


@pytest.mark.parametrize(
    ("literal", "value"),
    [
        (r'"a\tb"', "a\tb"),
        (r"'\x41\u00e9\U0001F600\101'", "Aé😀A"),
        (r'"\N{BULLET}"', "•"),
        (r'"\d"', r"\d"),
    ],
)
def test_escapes_are_pythons(literal, value):
    assert value == unquote(literal)


@pytest.mark.parametrize("literal", [r'"\x4"', r'"\u12"', r'"\U00110000"', r'"\N{NO SUCH}"'])
def test_an_escape_without_a_character_is_refused(literal):
    with pytest.raises(EscapeError):
        unquote(literal)


def test_the_quotes_that_need_fewer_escapes_are_chosen():
    assert "'say \"hi\"'" == quote('say "hi"')
    assert '"it\'s"' == quote("it's")
