"""The blocks that Blockly does not rename."""

import json

import msgspec
import pytest

from learnblock.blocks import builtin
from learnblock.language.workspace.blocks import Workspace
from learnblock.project.document.document import Document

PROGRAM = """\
def twice(number):
    return number * 2
end

def wave():
    function.expressJoy()
end

when near:
    print(time_near)
end

main:
    four = twice(2)
    wave()
    print(twice(number=four))
    deactivate near
    activate near
    print(`four if four else twice(1)`)
end
"""


@pytest.fixture
def document():
    return Document.from_text(PROGRAM, "learnblock.robots.sim_ebo", builtin())


def edited(document, *changes):
    """Return the document after an edit that changes names in the blocks."""
    text = msgspec.json.encode(document.workspace).decode()
    for old, new in changes:
        assert old in text
        text = text.replace(old, new)
    return document.with_blocks(msgspec.convert(json.loads(text), Workspace))


def test_calls_by_parameters_names_and_raw_python_follow_a_function(document):
    after = edited(
        document,
        ('"fields":{"NAME":"twice"}', '"fields":{"NAME":"doubled"}'),
        ('{"name":"twice","params"', '{"name":"doubled","params"'),
    )
    assert after.blocktext == PROGRAM.replace("twice", "doubled")
    assert after.origin == "blocks"
    assert not after.problems


def test_raw_python_follows_a_renamed_variable(document):
    after = edited(document, ('"name":"four"', '"name":"total"'))
    assert after.blocktext == PROGRAM.replace("four", "total")


def test_keyword_arguments_follow_a_renamed_parameter(document):
    after = edited(document, ('"name":"number"', '"name":"n"'), ('["number"]}}}', '["n"]}}}'))
    assert after.blocktext == PROGRAM.replace("number", "n")


def test_the_blocks_that_were_not_renamed_keep_their_ids_and_places(document):
    after = edited(document, ('"name":"four"', '"name":"total"'))
    tops = [[(one.id, one.x, one.y) for one in stack] for stack in after.workspace.stacks]
    assert tops == [
        [(one.id, one.x, one.y) for one in stack] for stack in document.workspace.stacks
    ]
