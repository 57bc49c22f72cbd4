"""Which edits are undone together."""

import pytest

from learnblock.blocks import builtin
from learnblock.project.document.document import Document
from learnblock.project.document.revisions import Revisions

EBO = "learnblock.robots.sim_ebo"


class Typist:
    """Edits the program ``x = 1``, and undoes everything."""

    def __init__(self):
        self.time = 100.0
        self.revisions = Revisions(Document.from_text("x = 1\n", EBO, builtin()), lambda: self.time)

    def types(self, *texts):
        for text in texts:
            self.revisions.push(self.revisions.document.with_text("blocktext", text))

    def undoes(self):
        """Undo everything; return each Block-Text on the way."""
        found = []
        while self.revisions.can_undo:
            self.revisions.undo()
            found.append(self.revisions.document.blocktext)
        return found


@pytest.fixture
def typist():
    return Typist()


def test_letters_of_a_word_are_one_step(typist):
    typist.types("x = 1\ns", "x = 1\nsp", "x = 1\nspe")
    assert typist.undoes() == ["x = 1\n"]


def test_each_word_is_a_step(typist):
    typist.types("x = 1\na", "x = 1\na ", "x = 1\na =", "x = 1\na = ", "x = 1\na = 2")
    assert typist.undoes() == ["x = 1\na = ", "x = 1\na ", "x = 1\n"]


def test_each_line_is_a_step(typist):
    typist.types("x = 12\n", "x = 12\n\n")
    assert typist.undoes() == ["x = 12\n", "x = 1\n"]


def test_letters_deleted_one_after_another_are_one_step(typist):
    typist.types("x = long\n")
    typist.types("x = lon\n", "x = lo\n", "x = l\n")
    assert typist.undoes() == ["x = long\n", "x = 1\n"]


def test_typing_after_a_pause_is_another_step(typist):
    typist.types("x = 12\n")
    typist.time += 1.5
    typist.types("x = 123\n")
    assert typist.undoes() == ["x = 12\n", "x = 1\n"]


def test_typing_elsewhere_is_another_step(typist):
    typist.types("x = 12\n", "xy = 12\n")
    assert typist.undoes() == ["x = 12\n", "x = 1\n"]


def test_a_number_typed_into_a_block_is_one_step_and_another_block_is_another(typist):
    revisions = typist.revisions
    for text in ("x = 12\n", "x = 123\n", "x = 123\nx += 1\n"):
        shown = revisions.document.with_text("blocktext", text).workspace
        revisions.push(revisions.document.with_blocks(shown))
    assert typist.undoes() == ["x = 123\n", "x = 1\n"]
