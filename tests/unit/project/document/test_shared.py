"""An edit of a program that others have changed since it was made."""

import pytest
from hypothesis import given
from hypothesis import strategies as st
from msgspec.structs import replace

from learnblock.blocks import builtin
from learnblock.language.workspace.blocks import Block, Input, Workspace
from learnblock.project.document.document import Document
from learnblock.project.document.shared import Edit, base_of, merged

EBO = "learnblock.robots.sim_ebo"
PROGRAM = """\
main:
    function.move_straight(50)
    function.turn_right()
end
"""
FASTER = PROGRAM.replace("50", "60")
LEFT = PROGRAM.replace("turn_right", "turn_left")
BOTH = FASTER.replace("turn_right", "turn_left")
HALF = PROGRAM.replace("turn_right()", "turn_rig(")


def document(text=PROGRAM):
    return Document.from_text(text, EBO, builtin())


def blocks(text):
    return document(text).workspace


def test_edits_of_two_lines_of_block_text_are_both_in_the_program():
    found = merged(document(FASTER), Edit("blocktext", LEFT, PROGRAM))
    assert (found.document.blocktext, found.lost) == (BOTH, None)


def test_edits_of_two_lines_of_python_are_both_in_the_program():
    edit = Edit("python", document(LEFT).python, document().python)
    found = merged(document(FASTER), edit)
    assert (found.document.blocktext, found.lost) == (BOTH, None)


def test_an_edit_of_blocks_keeps_what_was_written_in_a_text():
    found = merged(document(FASTER), Edit("blocks", blocks(LEFT), PROGRAM))
    assert (found.document.blocktext, found.lost) == (BOTH, None)
    assert document().with_blocks(found.document.workspace).blocktext == BOTH


def test_an_edit_of_a_text_keeps_what_was_built_of_blocks():
    now = document().with_blocks(blocks(FASTER))
    found = merged(now, Edit("blocktext", LEFT, PROGRAM))
    assert (found.document.blocktext, found.lost) == (BOTH, None)


def test_where_both_changed_the_same_line_the_edit_wins_and_the_other_program_is_lost():
    now = document(FASTER)
    found = merged(now, Edit("blocktext", PROGRAM.replace("50", "70"), PROGRAM))
    assert "move_straight(70)" in found.document.blocktext
    assert found.lost is now


def test_an_edit_that_does_not_win_is_the_one_that_is_lost():
    slower = PROGRAM.replace("50", "40")
    found = merged(document(FASTER), Edit("blocktext", slower, PROGRAM, wins=False))
    assert found.document.blocktext == FASTER
    assert found.lost.blocktext == slower


@pytest.mark.parametrize("wins", [True, False])
def test_of_two_valid_programs_that_make_no_valid_one_together_one_is_kept(wins):
    base = "main:\n    function.turn_right()\nend\n"
    looped = "main:\n    while True:\n        function.turn_right()\n    end\nend\n"
    commented = "# one\n# two\nmain:\n    function.turn_right()\nend\n"
    bare = "function.turn_right()\n"
    assert not merged(document(looped), Edit("blocktext", commented, base)).lost
    found = merged(document(looped), Edit("blocktext", bare, base, wins=wins))
    assert not found.document.unread
    assert found.lost


def test_an_edit_whose_base_is_forgotten_wins_or_is_lost_as_a_whole():
    now = document(FASTER)
    assert merged(now, Edit("blocktext", LEFT, None)).document.blocktext == LEFT
    assert merged(now, Edit("blocktext", LEFT, None)).lost is now
    assert merged(now, Edit("blocktext", LEFT, None, wins=False)).document is now


def test_a_line_that_is_being_written_stays_while_others_edit_another_view():
    now = document().with_text("python", document().python.replace("right()", "righ("))
    assert now.unread
    found = merged(now, Edit("blocktext", FASTER, PROGRAM), keeps_unread=True).document
    assert found.python == document(FASTER).python.replace("right()", "righ(")
    assert found.good.blocktext.text == FASTER


def test_a_line_that_is_being_written_in_the_same_text_stays_too():
    found = merged(document(HALF), Edit("blocktext", FASTER, PROGRAM)).document
    assert found.blocktext == HALF.replace("50", "60")
    assert found.unread


def test_blocks_that_are_no_program_are_shown_over_the_program_of_others():
    turn = Block("lb_skill_turn", "turn")
    incomplete = Workspace([[Block("lb_start", "start", inputs={"DO": Input(stack=[turn])})]])
    found = merged(document(FASTER), Edit("blocks", incomplete, PROGRAM))
    assert found.document.workspace is incomplete
    assert found.document.good.blocktext.text == FASTER


def test_moving_a_block_while_others_write_a_line_loses_nothing():
    now = document(FASTER).with_text("blocktext", HALF.replace("50", "60"))
    moved = Workspace([[replace(blocks(FASTER).stacks[0][0], x=300)]])
    found = merged(now, Edit("blocks", moved, PROGRAM))
    assert (found.lost, found.document.blocktext) == (None, now.blocktext)
    assert found.document.workspace == moved


def test_blocks_are_merged_with_a_text_that_others_have_only_spaced_differently():
    now = document(PROGRAM.replace("50", " 50 "))
    found = merged(now, Edit("blocks", blocks(LEFT), PROGRAM))
    assert (found.document.blocktext, found.lost) == (LEFT, None)


@pytest.mark.parametrize("view", ["blocktext", "python"])
def test_a_text_that_is_merged_is_read_only_once(view, monkeypatch):
    now, edit = document(FASTER), Edit(view, document(LEFT).text_of(view), document().text_of(view))
    read, with_text = [], Document.with_text
    monkeypatch.setattr(
        Document, "with_text", lambda *given: read.append(given[2]) or with_text(*given)
    )
    assert merged(now, edit).document.text_of(view) == document(BOTH).text_of(view)
    assert read == [document(BOTH).text_of(view)]


def test_the_base_of_blocks_is_their_program():
    assert base_of(document(FASTER), blocks(PROGRAM)) == PROGRAM
    assert base_of(document(FASTER), PROGRAM) == PROGRAM


LINES = [f"    function.move_straight({number})" for number in range(6)]
programs = st.lists(st.sampled_from(LINES), min_size=1, max_size=6, unique=True).map(
    lambda lines: "\n".join(["main:", *lines, "end", ""])
)


@given(programs, programs, programs, st.sampled_from(["blocktext", "python", "blocks"]))
def test_a_merged_program_has_every_line_that_was_added_or_names_a_lost_one(base, now, new, view):
    edited = document(new)
    content = edited.workspace if view == "blocks" else edited.text_of(view)
    found = merged(document(now), Edit(view, content, document(base).text_of(view)))
    added = (set(now.splitlines()) | set(new.splitlines())) - set(base.splitlines())
    assert found.lost or added <= set(found.document.blocktext.splitlines())
