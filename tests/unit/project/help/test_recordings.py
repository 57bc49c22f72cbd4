"""The examples in the help of blocks, and what happened in them."""

from pathlib import Path

import pytest

from learnblock import running
from learnblock.blocks.known import all_configurations
from learnblock.blocks.palette import palette
from learnblock.project.help.examples import example_name, examples
from learnblock.project.help.recordings import record, recordings

#: It needs a library, and none comes with LearnBlock.
_WITHOUT = {"lb_import"}


def _offered():
    tabs = palette(all_configurations(), "en")["toolbox"]["contents"]
    return {block["block"] for tab in tabs for block in tab.get("contents", ())}


def test_every_block_of_the_palette_has_an_example_that_ran():
    without = {name for name in _offered() if example_name(name) not in recordings()}
    assert without == _WITHOUT


def test_the_recordings_are_of_the_examples():
    ran = {name: recording.program for name, recording in recordings().items()}
    assert ran == {name: example.program for name, example in examples().items()}


@pytest.mark.parametrize("name", sorted(examples()))
def test_an_example_uses_its_block(name):
    skill = name.removeprefix("function.")
    if skill != name:
        assert f"{skill}(" in examples()[name].program


def test_no_example_has_mistakes():
    for name, example in examples().items():
        source = running.source_of(Path(name), example.program, is_python=False)
        assert not [found for found in running.check(source) if found.severity == "error"], name


def test_the_same_example_does_the_same_again():
    wanted = {
        name: examples()[name] for name in ("controls_repeat_ext", "function.is_left_obstacle")
    }
    assert dict(record(wanted)) == {name: recordings()[name] for name in wanted}
