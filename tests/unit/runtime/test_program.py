import pytest

from learnblock.language.python.source_map import SourceMap
from learnblock.runtime.program import Program

SQUARE = "from learnblock.robots.{} import Robot\n\nrobot = Robot()\nrobot.turn(90)\n"


def program(source, **options):
    return Program("square.py", source, source, **options)


def test_a_program_is_the_same_on_every_robot_and_under_every_name():
    ebo, thymio = (SQUARE.format(name) for name in ("ebo", "sim_thymio"))
    assert program(ebo).identity == Program("other.bt", thymio, "main:\nend").identity


def test_another_program_has_another_identity():
    assert program("x = 1").identity != program("x = 2").identity


@pytest.mark.parametrize(
    "text",
    [
        SQUARE.format("ebo").replace("\n", "\r\n"),
        SQUARE.format("ebo").replace("\n", "\r"),
        SQUARE.format("ebo").replace("\n", "\r\n", 2),
        SQUARE.format("ebo").removesuffix("\n"),
        SQUARE.format("ebo") + "\n\n",
        SQUARE.format("ebo").replace("\n", "\r\n").removesuffix("\r\n"),
        "\ufeff" + SQUARE.format("ebo"),
    ],
)
def test_the_ends_of_lines_and_of_the_file_make_no_other_program(text):
    assert program(SQUARE.format("ebo")).identity == program(text).identity


def test_the_names_of_a_program_are_its_attributes():
    assert program(SQUARE.format("ebo")).names == ("turn",)


def test_a_program_that_cannot_be_parsed_has_no_names():
    assert program("def f(").names == ()
    assert program("\0").names == ()


def test_half_a_surrogate_pair_has_an_identity_too():
    assert program("x = '\ud800'").identity


def test_lines_map_back_to_the_source():
    mapped = Program("a.bt", "import x\n\ny\n", "  first\nsecond", SourceMap((0, 0, 2)))
    assert mapped.written_line(3) == 2
    assert mapped.written_line(1) == 0
    assert program("x").written_line(1) == 1


def test_a_line_is_quoted_as_its_author_wrote_it():
    quoted = Program("a.bt", "", "  first  \nsecond")
    assert [quoted.quote(line) for line in (0, 1, 2, 3)] == ["", "first", "second", ""]
