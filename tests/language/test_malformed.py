"""Every slip has a program in tests/cases/malformed and, beside it, the message that teaches."""

from pathlib import Path

import pytest

PROGRAMS = sorted((Path(__file__).parent.parent / "cases" / "malformed").glob("*.bt"))


@pytest.mark.parametrize("program", PROGRAMS, ids=lambda path: path.stem)
def test_a_slip_is_named_with_its_place_and_what_to_do(program, report):
    expected = program.with_suffix(".txt").read_text(encoding="utf-8")
    assert expected == report(program.read_text(encoding="utf-8"), program.name)


def test_at_least_thirty_slips_are_taught():
    assert len(PROGRAMS) >= 30
