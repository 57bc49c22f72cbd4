"""The slips that pupils make with blocks, and what their blocks say, in tests/cases/block_slips.

Each case has its workspace (`drawn_blocks`) and its golden messages in English and Spanish: the
severity, the marked block, and the words. Some name the robot.
"""

import tomllib

import pytest

from drawn_blocks import drawn, label
from learnblock import robots
from learnblock.blocks import builtin
from learnblock.i18n import translate
from learnblock.project.document.document import Document
from places import TESTS
from workspaces import blocks

CASES = {
    name: case
    for file in sorted((TESTS / "cases" / "block_slips").glob("*.toml"))
    for name, case in tomllib.loads(file.read_text(encoding="utf-8")).items()
}


def marks(case, language):
    """The messages on the blocks of a case, as the page shows them."""
    workspace = drawn(case["blocks"])
    robot = robots.find(case.get("robot", "sim-ebo")).load()
    empty = Document.from_text("", robot.__module__, builtin(), equipment=robot.known_equipment())
    labels = {block.id: label(block, workspace) for block in blocks(workspace)}
    return list(
        dict.fromkeys(
            f"{one.severity} {labels[one.block]}: "
            + translate(one.in_blocks or one.message, language)
            for one in empty.with_blocks(workspace).problems
        )
    )


@pytest.mark.parametrize("case", CASES.values(), ids=CASES)
def test_a_slip_is_named_on_its_block_with_the_way_out(case):
    assert (case["says"], case["dice"]) == (marks(case, "en"), marks(case, "es"))


def test_there_are_more_than_seventy_slips():
    assert len(CASES) > 70
