"""The check of imports and of the skills of libraries."""

import dataclasses

import pytest

from learnblock.blocks.importable import Importable
from learnblock.i18n import Phrase
from learnblock.language import check, parse

IMPORTABLE = Importable(frozenset({"dance", "songs"}), frozenset({"helper"}))


@pytest.fixture
def found(skills):
    waltz = dataclasses.replace(skills["stop_bot"], name="waltz", library="dance")

    def of(text, importable=IMPORTABLE):
        diagnostics = check(parse(text), {**skills, "waltz": waltz}, None, importable)
        return [(one.line, one.code, one.message) for one in diagnostics]

    return of


@pytest.mark.parametrize(
    "text",
    [
        'import "dance"\nfunction.waltz()\n',
        'import "helper"\ngreet(tempo)\n',
        'import "dance"\nimport "helper"\ngreet(tempo)\n',
        "python:\n    from math import *\nend\nx = gcd(4, 6)\n",
    ],
)
def test_imported_names_may_be_used(text, found):
    assert [] == found(text)


def test_an_unknown_library_is_reported_with_its_line_and_the_known_ones(found):
    [(line, code, message)] = found('# A program.\nimport "danse"\n')
    assert (2, "unknown-library") == (line, code)
    assert Phrase("check-unknown-library-near", name="danse", near="dance") == message
    [(_, _, message)] = found('import "zebra"\n')
    known = ("dance", "helper", "songs")
    assert Phrase("check-unknown-library", name="zebra", known=known) == message


def test_without_libraries_none_is_suggested(found):
    [(_, _, message)] = found('import "zebra"\n', Importable())
    assert Phrase("check-no-libraries", name="zebra") == message


def test_if_the_libraries_are_unknown_no_import_is_reported(found):
    assert [] == found('import "zebra"\nx = y\n', None)


def test_a_skill_of_a_library_that_is_not_imported_is_reported_with_the_library(found):
    [(line, code, message)] = found("x = 1\nfunction.waltz()\n")
    assert (2, "not-imported") == (line, code)
    assert Phrase("check-not-imported", skill="waltz", library="dance") == message


def test_a_library_defines_no_other_names(found):
    codes = [code for _, code, _ in found('import "dance"\nx = y\ngreet()\n')]
    assert ["unknown-name", "unknown-function"] == codes
