"""What the check says of libraries."""

import dataclasses

import pytest

from learnblock.blocks.importable import Importable
from learnblock.language import check, parse

IMPORTABLE = Importable(frozenset({"dance", "songs"}), frozenset({"helper"}))


@pytest.fixture
def said(skills):
    waltz = dataclasses.replace(skills["stop_bot"], name="waltz", library="dance")

    def of(text, importable=IMPORTABLE):
        found = check(parse(text), {**skills, "waltz": waltz}, None, importable)
        return [(one.line, one.code, one.message) for one in found]

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
def test_what_is_imported_may_be_used(text, said):
    assert [] == said(text)


def test_an_import_of_what_is_not_there_is_told_with_its_line_and_what_there_is(said):
    [(line, code, message)] = said('# A program.\nimport "danse"\n')
    assert (2, "unknown-library") == (line, code)
    assert "did you mean `dance`?" in message
    [(_, _, message)] = said('import "zebra"\n')
    assert "there are `dance`, `helper`, `songs`" in message


def test_where_there_is_nothing_to_import_that_is_said(said):
    [(_, _, message)] = said('import "zebra"\n', Importable())
    assert "there is none yet" in message


def test_where_it_is_not_known_what_can_be_imported_nothing_is_said(said):
    assert [] == said('import "zebra"\nx = y\n', None)


def test_a_skill_of_a_library_that_is_not_imported_is_told_with_the_import(said):
    [(line, code, message)] = said("x = 1\nfunction.waltz()\n")
    assert (2, "not-imported") == (line, code)
    assert 'write `import "dance"` above everything else' in message


def test_a_library_makes_no_other_names_known(said):
    codes = [code for _, code, _ in said('import "dance"\nx = y\ngreet()\n')]
    assert ["unknown-name", "unknown-function"] == codes
