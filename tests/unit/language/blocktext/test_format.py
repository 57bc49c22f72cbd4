import pytest

from learnblock.language import format as format_program
from learnblock.language import parse
from learnblock.language.tree.nodes import Program, Repeat, While


@pytest.mark.parametrize(
    ("text", "canonical"),
    [
        ("x=1", "x = 1\n"),
        ("x = 'a'", 'x = "a"\n'),
        ("x = (1)", "x = 1\n"),
        ("while a:\nb()\nend # c", "while a:\n    b()\n    # c\nend\n"),
        ("\n\n\nx = 1\n\n\n\ny = 2\n\n\n", "x = 1\n\ny = 2\n"),
        ("x = 1\ndef f():\npass\nend\ny = 2", "x = 1\n\ndef f():\n    pass\nend\n\ny = 2\n"),
        ("#a\n##b\n#", "# a\n##b\n#\n"),
        ("f(1,\n  b=2,)", "f(1, b=2)\n"),
        ("robot()", ""),
        ("", ""),
    ],
)
def test_a_program_has_one_canonical_form(text, canonical):
    assert canonical == format_program(parse(text))
    assert canonical == format_program(parse(canonical))


def test_a_body_without_statements_is_written_with_pass():
    loop = While(parse("x = 1").items[0].value, ())
    assert "while 1:\n    pass\nend\n" == format_program(Program((loop,)))


def test_a_count_that_begins_with_a_list_goes_in_brackets():
    loop = Repeat(parse("x = [1][0]").items[0].value, parse("pass").items)
    text = format_program(Program((loop,)))
    assert "repeat ([1][0]):" == text.splitlines()[0]
    assert (loop,) == parse(text).items
