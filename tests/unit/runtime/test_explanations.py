"""What pupils read about Python's frequent errors, with golden messages in tests/cases."""

import tomllib

import pytest

from learnblock.i18n import languages, translate
from learnblock.runtime.error_phrases import phrase_of
from learnblock.runtime.failed_code import failed_code
from places import TESTS

SLIPS = tomllib.loads((TESTS / "cases/runtime_slips/slips.toml").read_text(encoding="utf-8"))


def raised(program):
    """The error that a program raises, and its phrase."""
    try:
        exec(compile(program, "slip.py", "exec"), {"__name__": "slip"})  # noqa: S102
    except Exception as error:  # noqa: BLE001 - any error of the program
        return error, phrase_of(error, failed_code(error, "slip.py", program))
    return None


@pytest.mark.parametrize("slip", SLIPS.values(), ids=SLIPS)
def test_a_frequent_error_is_explained_in_every_language_above_pythons_own_words(slip):
    error, phrase = raised(slip["program"])
    first, _, below = str(phrase).partition("\n")
    assert slip["says"] == first
    assert f"{type(error).__name__}: {error}" in below
    assert len({translate(phrase, language) for language in languages()}) == len(languages())


def test_an_error_of_the_programs_own_keeps_its_words():
    assert "ValueError: the floor is wet" == str(phrase_of(ValueError("the floor is wet")))


def test_an_error_outside_the_program_is_explained_without_its_words():
    error, _ = raised("values = []\nmin(values)")
    elsewhere = phrase_of(error, failed_code(error, "other.py", "values = []"))
    assert "Check 'len(...) > 0' first." in str(elsewhere)
