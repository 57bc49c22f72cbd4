import pytest

from learnblock import robots
from learnblock.blocks import builtin
from learnblock.server.program import edits as module
from learnblock.server.program.document import Document
from learnblock.server.program.edits import Edits

EBO = "learnblock.robots.sim_ebo"


class Clock:
    def __init__(self):
        self.time = 100.0

    def __call__(self):
        return self.time


@pytest.fixture
def clock():
    return Clock()


@pytest.fixture
def edits(clock):
    return Edits(Document.from_text("x = 1\n", EBO, builtin()), clock)


def type_in(edits, *texts, notation="blocktext"):
    for text in texts:
        edits.push(edits.document.with_text(notation, text))


def undone(edits):
    """Yield every Block-Text while undoing."""
    found = []
    while edits.can_undo:
        edits.undo()
        found.append(edits.document.blocktext)
    return found


def test_an_edit_is_undone_and_redone(edits):
    type_in(edits, "x = 2\n")
    edits.undo()
    assert (edits.document.blocktext, edits.can_undo, edits.can_redo) == ("x = 1\n", False, True)
    edits.redo()
    assert (edits.document.blocktext, edits.can_undo, edits.can_redo) == ("x = 2\n", True, False)


def test_there_is_nothing_to_undo_at_first(edits):
    edits.undo()
    edits.redo()
    assert edits.document.blocktext == "x = 1\n"


def test_edits_of_different_views_are_undone_in_reverse_order(edits):
    first = edits.document
    type_in(edits, first.python + "y=2\n", notation="python")
    second = edits.document
    edits.push(second.with_blocks(Document.from_text("z = 3\n", EBO, builtin()).workspace))
    type_in(edits, "z = 4\n")
    edits.undo()
    edits.undo()
    assert (edits.document.python, edits.document.workspace) == (second.python, second.workspace)
    edits.undo()
    assert edits.document.blocktext == first.blocktext


def test_a_text_with_mistakes_is_restored_with_them(edits):
    type_in(edits, "x = (\n", "x = 5\n")
    before = edits.document
    edits.undo()
    assert edits.document.blocktext == "x = (\n"
    assert edits.document.stale == ("blocks", "python")
    assert edits.document.python.endswith("\nx = 1\n")
    edits.redo()
    assert edits.document.blocktext == before.blocktext


def test_letters_of_a_word_are_one_step(edits):
    type_in(edits, "x = 1\ns", "x = 1\nsp", "x = 1\nspe")
    assert undone(edits) == ["x = 1\n"]


def test_each_word_is_a_step(edits):
    type_in(edits, "x = 1\na", "x = 1\na ", "x = 1\na =", "x = 1\na = ", "x = 1\na = 2")
    assert undone(edits) == ["x = 1\na = ", "x = 1\na ", "x = 1\n"]


def test_each_line_is_a_step(edits):
    type_in(edits, "x = 12\n", "x = 12\n\n")
    assert undone(edits) == ["x = 12\n", "x = 1\n"]


def test_letters_deleted_one_after_another_are_one_step(edits):
    type_in(edits, "x = long\n")
    type_in(edits, "x = lon\n", "x = lo\n", "x = l\n")
    assert undone(edits) == ["x = long\n", "x = 1\n"]


def test_typing_after_a_pause_is_another_step(edits, clock):
    type_in(edits, "x = 12\n")
    clock.time += 1.5
    type_in(edits, "x = 123\n")
    assert undone(edits) == ["x = 12\n", "x = 1\n"]


def test_typing_elsewhere_is_another_step(edits):
    type_in(edits, "x = 12\n", "xy = 12\n")
    assert undone(edits) == ["x = 12\n", "x = 1\n"]


def test_a_number_typed_into_a_block_is_one_step_and_another_block_is_another(edits):
    def shown(text):
        return edits.document.with_text("blocktext", text).workspace

    for text in ("x = 12\n", "x = 123\n", "x = 123\nx += 1\n"):
        edits.push(edits.document.with_blocks(shown(text)))
    assert undone(edits) == ["x = 123\n", "x = 1\n"]


def test_a_new_edit_discards_the_undone_ones(edits):
    type_in(edits, "x = 2\n")
    edits.undo()
    type_in(edits, "y = 2\n")
    assert not edits.can_redo


def test_an_edit_without_a_change_adds_no_step(edits):
    edits.push(edits.document.with_blocks(edits.document.workspace))
    assert not edits.can_undo


def test_steps_use_the_currently_chosen_robot(edits):
    type_in(edits, "x = 2\n")
    edits.replace(edits.document.with_robot(robots.find("sim-thymio").module, frozenset()))
    edits.undo()
    assert "sim_thymio" in edits.document.python
    assert edits.document.target.equipment == frozenset()


def test_the_number_of_steps_is_limited(edits, clock, monkeypatch):
    monkeypatch.setattr(module, "MOST_BYTES", 2000)
    for number in range(100):
        clock.time += 10
        type_in(edits, f"x = {number}\n")
    steps = undone(edits)
    assert 2 < len(steps) < 20
    assert steps[0] == "x = 98\n"
