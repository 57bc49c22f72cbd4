"""Imports that are added to a program."""

import pytest

from learnblock.blocks.schema.configuration import BlockConfiguration
from learnblock.language import format as format_program
from learnblock.language import parse
from learnblock.language.edit.imports import libraries_used, with_import

SKILLS = {
    name: BlockConfiguration("others", "Others", name, library=library)
    for name, library in (("waltz", "dance"), ("sing", "songs"), ("turn", ""))
}


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("", 'import "dance"\n'),
        ("x = 1\n", 'import "dance"\n\nx = 1\n'),
        ('import "songs"\n\nx = 1\n', 'import "songs"\nimport "dance"\n\nx = 1\n'),
        ("# About.\n\nx = 1\n", '# About.\n\nimport "dance"\n\nx = 1\n'),
        ("# Of f.\ndef f(): pass end\n", 'import "dance"\n\n# Of f.\ndef f():\n    pass\nend\n'),
        ('robot(world="line")\n', 'import "dance"\n\nrobot(world="line")\n'),
        ("main:\n    pass\nend\n", 'import "dance"\n\nmain:\n    pass\nend\n'),
        ('import "dance"\n', 'import "dance"\n'),
    ],
)  # fmt: skip
def test_an_import_is_added_above_the_code_that_needs_it(text, expected):
    assert format_program(with_import(parse(text), "dance")) == expected
    assert with_import(parse(text), "dance") == parse(expected)


def test_a_program_uses_the_libraries_of_the_skills_that_it_calls():
    text = "when seen = function.sing(): function.turn(9) end\nmain: print(function.waltz()) end"
    assert libraries_used(parse(text), SKILLS) == {"dance", "songs"}
    assert libraries_used(parse("function.turn(9)\nfunction.other()\n"), SKILLS) == set()
