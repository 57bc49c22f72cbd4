import pytest

from learnblock.errors import ProgramError
from learnblock.i18n import Phrase
from learnblock.language import format as format_program
from learnblock.language import parse, recover
from learnblock.language.tree.nodes import (
    Binary,
    Blank,
    Call,
    Comment,
    Import,
    Name,
    Number,
    Perform,
    SkillCall,
    Span,
    Unary,
    While,
)


def value(text):
    return parse(f"x = {text}\n").items[0].value


def codes(text):
    return [diagnostic.code for diagnostic in recover(text)[1]]


def test_indentation_carries_no_meaning():
    assert parse("while a:\nb()\nend\n") == parse("   while a:\n\t\tb()\n  end")


def test_a_line_end_closes_a_statement_except_inside_brackets():
    assert 2 == len(parse("x = a\ny = (1 +\n  2)\n").items)
    assert ["unexpected"] == codes("x = a\n-b\n")


def test_a_conditional_value_may_go_on_in_the_next_line_inside_brackets():
    assert parse("x = (a if b else c)\n") == parse("x = (a\n  if b\n  else c)\n")


def test_a_line_with_if_and_a_colon_begins_a_statement_even_after_an_open_bracket():
    assert ["unclosed-bracket"] == codes("print(1,\nif x > 3:\n    y = 2\nend\n")


@pytest.mark.parametrize("loop", ["forever:", "while True:", "forever :", "while (True):"])
def test_a_loop_without_end_has_one_canonical_spelling(loop):
    assert "forever:\n    pass\nend\n" == format_program(parse(f"{loop}\npass\nend\n"))


def test_words_of_waiting_and_repeating_are_names_elsewhere():
    text = "forever = wait\nwait = until(forever)\nuntil()\nforever[0] = 1\n"
    assert text == format_program(parse(text))


@pytest.mark.parametrize(
    ("text", "same"),
    [
        ("a if b else c if d else e", "a if b else (c if d else e)"),
        ("a or b if c else d", "(a or b) if c else d"),
        ("a if b or c else d", "a if (b or c) else d"),
        ("f'{a}{b}'", 'f"{a}{b}"'),
        ("F'a' + f''", 'f"a" + f""'),
        ("""f"{'a'}b{x}{f'{y}'}" """, 'f"ab{x}{y}"'),
        (r"f'\x41{{\N{BULLET}}}{x}'", 'f"A{{•}}{x}"'),
    ],
)
def test_values_with_conditions_and_texts_with_values_are_grouped_as_in_python(text, same):
    assert value(text) == value(same)


def test_a_value_in_a_text_knows_its_position():
    found = value('f"é {yy}{z}"')
    assert [Span(1, 10, 1, 12), Span(1, 14, 1, 15)] == [part.span for part in found.parts[1:]]


def test_a_space_before_the_colon_is_allowed():
    assert parse("while a :\n pass\nend\n") == parse("while a:\n pass\nend\n")


def test_a_block_may_be_on_one_line():
    assert parse("while a: b() end\n") == parse("while a:\n    b()\nend\n")


@pytest.mark.parametrize(
    ("text", "same"),
    [
        ("1 + 2 * 3", "1 + (2 * 3)"),
        ("-2 ** 2", "-(2 ** 2)"),
        ("2 ** -1", "2 ** (-1)"),
        ("2 ** 3 ** 2", "2 ** (3 ** 2)"),
        ("1 - 2 - 3", "(1 - 2) - 3"),
        ("not a == b", "not (a == b)"),
        ("a or b and not c", "a or (b and (not c))"),
        ("a + b < c * d", "(a + b) < (c * d)"),
        ("not a in b", "not (a in b)"),
    ],
)
def test_precedence_is_pythons(text, same):
    assert value(same) == value(text)


def test_comparisons_chain_as_in_python():
    assert value("(0 < x) < 3") != value("0 < x < 3")


def test_signs_are_separate_operators():
    assert Unary("-", Number("5")) == value("-5")
    assert Binary("-", Name("a"), Unary("-", Name("b"))) == value("a--b")


def test_positions_are_ignored_when_trees_are_compared():
    assert parse("x = 1\n") == parse("\n\n   x   =   1   # \n").__class__(parse("x = 1").items)


def test_a_node_knows_its_position():
    loop = parse("x = 1\n\n  while x:\n    y()\n  end\n").items[2]
    assert isinstance(loop, While)
    assert Span(3, 3, 5, 6) == loop.span
    assert Span(3, 9, 3, 10) == loop.condition.span


def test_comments_and_blank_lines_belong_to_the_tree():
    items = parse("# a\n\n\nb()  # c\n").items
    assert (Comment("a"), Blank(), Perform(Call("b"), "c")) == items


def test_a_comment_inside_brackets_moves_above_its_statement():
    assert "# one\nx = [1, 2]  # two\n" == format_program(parse("x = [1,  # one\n 2]  # two\n"))


def test_main_is_written_last_with_its_comment():
    text = "# about main\nmain:\n    pass\nend\ndef f():\n    pass\nend\n"
    expected = "def f():\n    pass\nend\n\n# about main\nmain:\n    pass\nend\n"
    assert expected == format_program(parse(text))


def test_words_of_loops_are_names_elsewhere():
    text = "repeat = to\nfor to from from to step step to: repeat(3) end\n"
    assert text.split("\n", maxsplit=1)[0] == format_program(parse(text)).split("\n")[0]


def test_elapsed_time_may_be_called_as_a_skill():
    assert Call("elapsedTime", (Number("3"),)) == value("function.elapsedTime(3)")
    assert SkillCall("turn", (Number("3"),)) == value("function.turn(3)")


def test_names_are_compared_in_normalized_form():
    assert Name("fi") == value("\ufb01")


def test_windows_line_ends_change_nothing():
    text = "while a:  # b\n\n    python:\n        x = 1\n    end\nend\n"
    assert parse(text) == parse(text.replace("\n", "\r\n"))


def test_every_error_of_a_file_is_reported_in_one_pass():
    with pytest.raises(ProgramError) as caught:
        parse("x = = 1\nif x\n  y = (\nend\nz 3\n", "mine.bt")
    assert [1, 2, 3, 5] == [diagnostic.line for diagnostic in caught.value.diagnostics]
    assert str(caught.value).startswith("mine.bt:1:3: ")
    last = caught.value.diagnostics[-1]
    assert "z 3\n  ^" == last.pointed(caught.value.source)
    assert "missing-brackets" == last.code
    assert Phrase("blocktext-missing-brackets", name="z") == last.message


def test_an_invalid_statement_keeps_the_rest_of_the_tree():
    program, diagnostics = recover("a()\nb(\nwhile x\n  c()\nend\nd()\n")
    assert 2 == len(diagnostics)
    assert 3 == len(program.items)


def test_a_correct_program_has_no_diagnostics():
    assert () == recover("x = 1\n")[1]


@pytest.mark.parametrize(
    "text",
    ["(" * 100, "[" * 100, "f(" * 100, "xs[" * 100, "-(" * 100],
)
def test_a_hundred_brackets_are_read(text):
    closing = "".join({"(": ")", "[": "]"}[mark] for mark in reversed(text) if mark in "([")
    program = parse(f"x = {text}1{closing}\n")
    assert program == parse(format_program(program))


def test_a_hundred_ifs_with_a_hundred_brackets_inside_are_read():
    brackets = "x = " + "(" * 100 + "1" + " + 1)" * 100 + "\n"
    text = format_program(parse("if a:\n" * 100 + brackets + "end\n" * 100))
    assert text == format_program(parse(text))


@pytest.mark.parametrize("size", [1_000, 30_000])
@pytest.mark.parametrize(
    "text", ["(", "[", "f(", "-", "not ", "1 + ", "1 ** ", "xs[", '"', "a b ", "if a: ", "\\"]
)
def test_too_much_depth_or_length_is_a_program_error(text, size):
    with pytest.raises(ProgramError):
        parse("x = " + text * size)


@pytest.mark.parametrize("line", ["if a:\n", "end\n", "x = (\n", "else:\n", "def f(:\n", "main:\n"])
def test_a_long_file_of_errors_is_read_in_one_pass(line):
    assert recover(line * 5_000)[1]


@pytest.mark.parametrize("white", [" ", "\t", "\n", " \n", "\f", "\xa0"])
def test_a_lot_of_white_space_is_read_in_one_pass(white):
    assert 1 == len(parse("x = 1" + white * 500_000).items)


@pytest.mark.parametrize("text", ["x = 1\0", "x = '\ud800'", "x" * 2_000_001])
def test_text_that_no_program_can_contain_is_refused(text):
    assert 1 == len(recover(text)[1])


def test_the_name_of_an_import_is_normalized_as_in_python():
    program = parse('import "songsʳslow"\n')
    assert Import("songsrslow") == program.items[0]


def test_open_brackets_above_a_line_that_resembles_a_slip_are_reported_once():
    text = "function.turn(print(\na, b, c = values#c\nlambda #c\n"
    _, diagnostics = recover(text)
    assert [("unclosed-bracket", 1)] == [(one.code, one.line) for one in diagnostics][:1]
