"""Beginners' mistakes in tests/cases/malformed, each with its message in a file next to it."""

import pytest

from learnblock.i18n import languages, translate
from places import TESTS

PROGRAMS = sorted((TESTS / "cases" / "malformed").glob("*.bt"))


@pytest.mark.parametrize("program", PROGRAMS, ids=lambda path: path.stem)
def test_a_slip_is_reported_in_every_language_with_its_position_and_advice(
    program, report, diagnose
):
    text = program.read_text(encoding="utf-8")
    expected = program.with_suffix(".txt").read_text(encoding="utf-8")
    assert expected == report(text, program.name)
    for diagnostic in diagnose(text):
        words = [translate(diagnostic.message, language) for language in languages()]
        assert len(set(words)) == len(languages())


def test_at_least_thirty_slips_have_a_message():
    assert len(PROGRAMS) >= 30
