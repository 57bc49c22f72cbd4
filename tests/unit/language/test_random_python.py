"""Random modules of Python, over its whole grammar, in three notations.

Below are the faults that such modules have found, each in a few lines.
"""

import ast

import pytest
from hypothesis import HealthCheck, given, settings

from gate import examples
from learnblock.blocks.schema.loading import builtin
from learnblock.language import format as format_program
from learnblock.language import from_python, from_workspace, parse, to_python, to_workspace
from python_scores import meaning
from random_python import modules

many = settings(
    max_examples=examples(800, gate=12), deadline=None, suppress_health_check=list(HealthCheck)
)


def assert_same(program, text):
    """Check that a program read from other notations means what the Python `text` does."""
    assert meaning(ast.parse(to_python(program, None).text)) == meaning(ast.parse(text))


def assert_comes_back(text):
    """Check that Python comes back: unedited as it is, and the same by blocks and Block-Text."""
    program = from_python(text)
    assert to_python(program, None).text == text
    blocktext = format_program(program)
    assert format_program(parse(blocktext)) == blocktext
    assert_same(parse(blocktext), text)
    read = from_workspace(to_workspace(program, builtin()).workspace, builtin())
    assert read.problems == ()
    assert read.program == program
    assert_same(read.program, text)


@pytest.mark.timeout(1800)  # 2,000 modules with `--all`
@many
@given(modules())
def test_a_random_module_comes_back(text):
    assert_comes_back(text)


FOUND = {
    "global outside a function": "for a in b:\n    if a:\n        global c\n        c = 1\n",
    "global deep in a function": "def f():\n    while a:\n        global b\n",
    "yield as a decorator": "def f():\n\n    @(yield 1)\n    class C:\n        pass\n",
}


@pytest.mark.parametrize("text", FOUND.values(), ids=FOUND)
def test_a_module_that_once_did_not_comes_back(text):
    assert_comes_back(text)
