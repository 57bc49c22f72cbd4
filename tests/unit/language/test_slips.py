"""The slips that pupils make, and what is said about them, in tests/cases/slips.

Each case has the program and its golden messages: severity, line and words; some have the program
as the messages advise to write it.
"""

import tomllib

import pytest

from learnblock.blocks import builtin
from learnblock.errors import FileError
from learnblock.i18n import languages, translate
from learnblock.language import check, from_python, parse
from places import TESTS

SLIPS = {
    f"{file.stem}-{name}": slip
    for file in sorted((TESTS / "cases" / "slips").glob("*.toml"))
    for name, slip in tomllib.loads(file.read_text(encoding="utf-8")).items()
}

MENDED = {name: slip for name, slip in SLIPS.items() if "mended" in slip}


def diagnosed(slip, version="program"):
    """The diagnostics of `learnblock check` without a robot."""
    text, is_python = slip[version], slip.get("notation") == "python"
    try:
        tree = from_python(text) if is_python else parse(text)
    except FileError as error:
        return error.diagnostics
    return check(tree, builtin(), python=text if is_python else None)


def is_marked_in(line, diagnostic):
    """What is missing is marked after the end of the line."""
    end = diagnostic.end_column or diagnostic.column
    return 1 <= diagnostic.column <= end <= len(line) + 2


@pytest.mark.parametrize("slip", SLIPS.values(), ids=SLIPS)
def test_a_slip_is_named_in_every_language_with_its_place_and_the_way_out(slip):
    found = diagnosed(slip)
    assert slip["says"] == [f"{one.severity} {one.line}: {one.message}" for one in found]
    lines = slip["program"].split("\n")
    for diagnostic in found:
        assert is_marked_in(lines[diagnostic.line - 1], diagnostic)
        words = {translate(diagnostic.message, language) for language in languages()}
        assert len(words) == len(languages())


@pytest.mark.parametrize("slip", MENDED.values(), ids=MENDED)
def test_a_program_that_follows_the_advice_has_no_slip(slip):
    assert [] == diagnosed(slip, "mended")


def test_there_are_more_than_three_hundred_slips():
    assert len(SLIPS) > 300
