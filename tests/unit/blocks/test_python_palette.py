"""Python's own blocks in the palette, and their sentences."""

import re

import msgspec
import pytest

from learnblock.blocks import builtin
from learnblock.blocks.python_palette import STAGE
from learnblock.blocks.python_sentences import BLOCK, FORMS, LINE, VALUE
from learnblock.blocks.toolbox import toolbox
from learnblock.blocks.translation import languages, translation
from learnblock.language import (
    Workspace,
    check,
    from_python,
    from_workspace,
    parse,
    to_python,
)
from learnblock.language import format as format_program

_TABS = toolbox(builtin(), translation("en"))["contents"]
OFFERED = {
    item["block"]: item
    for tab in _TABS
    if tab["category"] == "lb_python"
    for item in tab["contents"]
}
#: The page shows the sentence of these.
FORMS_BY_NAME = {form.name: form for forms in FORMS.values() for form in forms}


class _Ids:
    """Gives the blocks of the palette what they have in a program: ids, and variables by id."""

    def __init__(self):
        self.count = 0
        self.names = {}

    def block(self, item):
        self.count += 1
        kept = {key: item[key] for key in ("type", "extraState") if key in item}
        fields = {name: self.field(value) for name, value in item.get("fields", {}).items()}
        inputs = {
            name: {kind: self.block(inner) for kind, inner in plugged.items()}
            for name, plugged in item.get("inputs", {}).items()
        }
        return {**kept, "id": f"b{self.count}", "fields": fields, "inputs": inputs}

    def field(self, value):
        if not isinstance(value, dict):
            return value
        self.names[value["name"]] = value["name"]
        return {"id": value["name"]}


def dropped(item, with_robot):
    """The program of a block of the palette in an empty program; a value is printed."""
    ids = _Ids()
    block = ids.block(item)
    if item["type"] == VALUE:
        block = {"type": "text_print", "id": "print", "inputs": {"TEXT": {"block": block}}}
    hat, stack = "lb_main", [block]
    if not with_robot:
        hat, stack = "lb_start", [{"type": "lb_without_robot", "id": "none"}, block]
    workspace = {
        "stacks": [[{"type": hat, "id": "hat", "inputs": {"DO": {"stack": stack}}}]],
        "variables": [{"name": name, "id": key} for name, key in ids.names.items()],
    }
    found = from_workspace(msgspec.convert(workspace, Workspace), builtin())
    assert not found.problems
    return found.program


@pytest.mark.parametrize("with_robot", [True, False], ids=["with robot", "without robot"])
@pytest.mark.parametrize("name", OFFERED)
def test_a_block_of_python_in_the_palette_is_a_valid_program_in_every_notation(name, with_robot):
    program = dropped(OFFERED[name], with_robot)
    text = format_program(program)
    assert parse(text) == program
    python = to_python(program).text
    compile(python, name, "exec")
    assert format_program(from_python(python)) == text
    assert not [found for found in check(program, builtin()) if found.severity == "error"]


def test_the_palette_shows_pythons_blocks_from_the_last_stage_on():
    later = {item["block"] for tab in _TABS for item in tab.get("contents", ()) if "stage" in item}
    assert later == set(OFFERED)
    assert {item["stage"] for item in OFFERED.values()} == {STAGE} == {"coder"}
    assert {item["type"] for item in OFFERED.values()} == {LINE, BLOCK, VALUE}


@pytest.mark.parametrize("language", languages())
@pytest.mark.parametrize("name", FORMS_BY_NAME)
def test_a_sentence_has_every_part_of_its_form_once(name, language):
    form = FORMS_BY_NAME[name]
    words = translation(language)[form.word]
    assert sorted(re.findall(r"%\d", words)) == sorted(re.findall(r"%\d", form.python))
