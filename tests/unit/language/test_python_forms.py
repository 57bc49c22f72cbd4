"""The forms of Python that people write, in three notations: tests/cases/python_forms.toml."""

import tomllib

import pytest

from learnblock.language import format as format_program
from learnblock.language import from_python, from_workspace, parse, to_python, to_workspace
from places import TESTS
from workspaces import CONFIGURATIONS, blocks

FORMS = tomllib.loads((TESTS / "cases" / "python_forms.toml").read_text("utf-8"))
GREY = {"lb_python", "lb_python_text", "lb_python_value"}
#: The blocks of every program without a robot.
ALWAYS = {"lb_start", "lb_without_robot"}
every_form = pytest.mark.parametrize("form", FORMS.values(), ids=FORMS)


def block_text(form):
    return "without robot\n\n" + form["blocktext"]


@every_form
def test_a_form_of_python_has_words_in_block_text(form):
    assert format_program(from_python(form["python"])) == block_text(form)


@every_form
def test_a_form_has_blocks_and_none_of_them_is_grey(form):
    workspace = to_workspace(parse(block_text(form)), CONFIGURATIONS).workspace
    found = {block.type for block in blocks(workspace)}
    assert sorted(found - ALWAYS) == form["blocks"]
    assert found.isdisjoint(GREY)


@every_form
def test_a_form_comes_back_from_block_text_and_from_blocks_byte_for_byte(form):
    program = parse(block_text(form))
    read = from_workspace(to_workspace(program, CONFIGURATIONS).workspace, CONFIGURATIONS)
    assert (read.program, read.problems) == (program, ())
    assert to_python(program).text == to_python(read.program).text == form["python"]
