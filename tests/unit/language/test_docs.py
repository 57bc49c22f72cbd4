"""The examples of the language reference and the Python below them."""

import re

import pytest

from learnblock.language import format as format_program
from learnblock.language import from_python, parse, to_python
from places import ROOT

PAGE = ROOT / "docs" / "language.md"
EXAMPLE = re.compile(r"```blocktext\n(.*?)```\n\n```python( whole)?\n(.*?)```", re.DOTALL)
EXAMPLES = EXAMPLE.findall(PAGE.read_text("utf-8"))


@pytest.mark.parametrize(("block_text", "whole", "python"), EXAMPLES)
def test_an_example_becomes_the_python_below_it(block_text, whole, python):
    text = to_python(parse(block_text), "learnblock.robots.ebo").text
    body = text.partition("robot = Robot()\n")[2].lstrip("\n")
    assert python == (text if whole else body)


@pytest.mark.parametrize("block_text", [example[0] for example in EXAMPLES])
def test_an_example_is_restored_from_python(block_text):
    program = parse(block_text)
    assert program == from_python(to_python(program).text)
    assert program == parse(format_program(program))


def test_every_example_of_the_page_has_its_python():
    assert PAGE.read_text("utf-8").count("```blocktext") == len(EXAMPLES)


def test_the_page_names_every_function_of_the_library():
    from learnblock.language.tree.builtins import FUNCTIONS

    page = PAGE.read_text("utf-8")
    assert [] == [name for name in sorted(FUNCTIONS) if f"`{name}(" not in page]
