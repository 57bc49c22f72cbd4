"""The one log of a program, of which undo, merging and the file say numbers."""

import pytest

from learnblock import robots
from learnblock.blocks import builtin
from learnblock.project.document import document as reading
from learnblock.project.document import revisions as module
from learnblock.project.document.document import Document
from learnblock.project.document.revisions import MOST_REVISIONS, MOST_SAVES, Revisions

EBO = "learnblock.robots.sim_ebo"


def document(text):
    return Document.from_text(text, EBO, builtin())


@pytest.fixture
def revisions():
    return Revisions(document("x = 1\n"))


def type_in(revisions, *texts, notation="blocktext"):
    for text in texts:
        revisions.push(revisions.document.with_text(notation, text))


def lines(revisions, *numbers):
    """Make a step of undo of each number."""
    type_in(revisions, *(f"x = {number}\nstep_{number} = 0\n" for number in numbers))


def undone(revisions):
    """Undo everything; return the first line of each Block-Text on the way."""
    found = []
    while revisions.can_undo:
        revisions.undo()
        found.append(revisions.document.blocktext.split("\n")[0])
    return found


# Undo.


def test_an_edit_is_undone_and_redone(revisions):
    type_in(revisions, "x = 2\n")
    revisions.undo()
    assert revisions.document.blocktext == "x = 1\n"
    assert (revisions.can_undo, revisions.can_redo) == (False, True)
    revisions.redo()
    assert revisions.document.blocktext == "x = 2\n"
    assert (revisions.can_undo, revisions.can_redo) == (True, False)


def test_there_is_nothing_to_undo_at_first(revisions):
    revisions.undo()
    revisions.redo()
    assert revisions.document.blocktext == "x = 1\n"


def test_edits_of_different_views_are_undone_in_reverse_order(revisions):
    first = revisions.document
    type_in(revisions, first.python + "y=2\n", notation="python")
    second = revisions.document
    revisions.push(second.with_blocks(document("z = 3\n").workspace))
    type_in(revisions, "z = 4\n")
    revisions.undo()
    revisions.undo()
    now = revisions.document
    assert (now.python, now.workspace) == (second.python, second.workspace)
    revisions.undo()
    assert revisions.document.blocktext == first.blocktext


@pytest.mark.parametrize("most", [module.MOST_CHARACTERS, 0])
def test_a_text_with_mistakes_is_restored_with_them(revisions, monkeypatch, most):
    monkeypatch.setattr(module, "MOST_CHARACTERS", most)
    type_in(revisions, "x = (\n", "x = 5\n")
    before = revisions.document
    revisions.undo()
    assert revisions.document.blocktext == "x = (\n"
    assert revisions.document.stale == ("blocks", "python")
    assert revisions.document.python.endswith("\nx = 1\n")
    revisions.redo()
    assert revisions.document.blocktext == before.blocktext


def test_the_last_steps_are_restored_without_parsing_or_checking_anything(revisions, monkeypatch):
    lines(revisions, 2, 3)
    settled = revisions.document.settled()
    revisions.undo()
    for name in ("parse", "recover", "read_python", "from_workspace", "derive", "problems"):
        monkeypatch.setattr(reading, name, None)
    revisions.redo()
    assert revisions.document is settled
    assert revisions.document.problems == ()
    assert undone(revisions) == ["x = 2", "x = 1"]


def test_steps_beyond_the_limit_are_restored_from_their_texts(revisions, monkeypatch):
    monkeypatch.setattr(module, "MOST_CHARACTERS", 100)
    lines(revisions, *range(2, 10))
    before = revisions.document
    assert undone(revisions) == [f"x = {number}" for number in range(8, 0, -1)]
    while revisions.can_redo:
        revisions.redo()
    assert revisions.document.workspace == before.workspace


def test_a_new_edit_discards_the_undone_ones(revisions):
    type_in(revisions, "x = 2\n")
    revisions.undo()
    type_in(revisions, "y = 2\n")
    assert not revisions.can_redo


def test_an_edit_without_a_change_adds_no_step(revisions):
    revisions.push(revisions.document.with_blocks(revisions.document.workspace))
    assert not revisions.can_undo


def test_steps_use_the_currently_chosen_robot(revisions):
    type_in(revisions, "x = 2\n")
    revisions.replace(revisions.document.with_robot(robots.find("sim-thymio").module, frozenset()))
    revisions.undo()
    assert "sim_thymio" in revisions.document.python
    assert revisions.document.target.equipment == frozenset()


def test_steps_use_the_skills_known_now(revisions):
    type_in(revisions, "main:\n    function.move_straight()\nend\n", "x = 2\n")
    revisions.replace(revisions.document.with_configurations({}))
    revisions.undo()
    assert {"unknown-skill"} == {one.code for one in revisions.document.problems}


def test_the_number_of_steps_is_limited(monkeypatch):
    monkeypatch.setattr(module, "MOST_STEPS", 5)
    revisions = Revisions(document("x = 1\n"))
    lines(revisions, *range(8))
    assert undone(revisions) == ["x = 6", "x = 5", "x = 4", "x = 3", "x = 2"]


def test_the_size_of_the_steps_is_limited(revisions, monkeypatch):
    monkeypatch.setattr(module, "MOST_CHARACTERS", 0)
    monkeypatch.setattr(module, "MOST_BYTES", 4000)
    lines(revisions, *range(100))
    steps = undone(revisions)
    assert 2 < len(steps) < 20
    assert steps[0] == "x = 98"


# What an edit was made on.


def test_a_view_of_an_earlier_revision_is_found_by_its_number(revisions):
    number = revisions.number
    type_in(revisions, revisions.document.python + "y=2\n", notation="python")
    type_in(revisions, "z = (\n")
    assert revisions.text(number, "blocktext") == "x = 1\n"
    assert revisions.text(number + 1, "python").endswith("x = 1\ny=2\n")
    assert revisions.text(number + 2, "blocktext") == "z = (\n"
    assert revisions.text(number + 2, "blocks") == "x = 1\ny = 2\n"


def test_a_revision_is_forgotten_after_many_others_unless_it_was_saved(revisions):
    revisions.replace(revisions.document)
    saved = revisions.number
    revisions.saved(saved)
    revisions.replace(revisions.document)
    for _ in range(MOST_REVISIONS - 1):
        revisions.replace(revisions.document)
    assert revisions.text(saved + 1, "blocktext") == "x = 1\n"
    revisions.replace(revisions.document)
    assert revisions.text(saved + 1, "blocktext") is None
    assert revisions.text(saved, "blocktext") == "x = 1\n"


# What is in the file.


def saved(*texts):
    first, *others = texts
    made = Revisions(document(first))
    for text in others:
        type_in(made, text)
        made.saved(made.number)
    return made


def edited(revisions, text):
    return revisions.text(revisions.edited("blocktext", text), "blocktext")


def test_an_editor_that_read_the_file_before_the_last_save_has_edited_an_earlier_one():
    assert edited(saved("a", "a\nb", "a\nb\nc"), "a\nx") == "a"


def test_an_editor_that_read_the_last_save_has_edited_that():
    assert edited(saved("a", "a\nb"), "a\nb\nx") == "a\nb"


def test_of_two_saves_as_different_the_later_was_edited():
    assert edited(saved("a\nb", "a\nc"), "a") == "a\nc"


def test_who_goes_back_to_an_earlier_save_has_edited_the_last():
    assert edited(saved("a", "a\nb"), "a") == "a\nb"


def test_old_saves_are_forgotten():
    texts = ["\n".join(str(line) for line in range(number)) for number in range(MOST_SAVES + 5)]
    assert edited(saved(*texts), "x") == texts[5]


def test_an_edit_that_is_not_saved_was_not_edited_by_another_program():
    revisions = saved("a", "a\nb")
    type_in(revisions, "a\nb\nc")
    assert edited(revisions, "a\nb\nc\nd") == "a\nb"
