"""What pupils read about Python's frequent errors, with golden messages in tests/cases."""

import tomllib

import pytest

from learnblock.i18n import languages, translate
from learnblock.runtime.error_phrases import phrase_of
from places import TESTS

SLIPS = tomllib.loads((TESTS / "cases/runtime_slips/slips.toml").read_text(encoding="utf-8"))


def raised(program):
    try:
        exec(compile(program, "slip.py", "exec"), {"__name__": "slip"})  # noqa: S102
    except Exception as error:  # noqa: BLE001 - any error of the program
        return error
    return None


@pytest.mark.parametrize("slip", SLIPS.values(), ids=SLIPS)
def test_a_frequent_error_is_explained_above_pythons_own_words(slip):
    error = raised(slip["program"])
    first, _, below = str(phrase_of(error)).partition("\n")
    assert slip["says"] == first
    assert f"{type(error).__name__}: {error}" in f"{below}{first}"


@pytest.mark.parametrize("slip", SLIPS.values(), ids=SLIPS)
def test_a_frequent_error_is_explained_in_every_language(slip):
    phrase = phrase_of(raised(slip["program"]))
    assert len({translate(phrase, language) for language in languages()}) == len(languages())


def test_an_error_of_the_programs_own_keeps_its_words():
    assert "ValueError: the floor is wet" == str(phrase_of(ValueError("the floor is wet")))
