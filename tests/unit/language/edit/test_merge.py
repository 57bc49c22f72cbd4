"""Two edits of one text."""

from hypothesis import given
from hypothesis import strategies as st

from learnblock.language.edit import merge as merging
from learnblock.language.edit.merge import Merge, merge

texts = st.lists(st.sampled_from(["", "a", "b", "    c", "end"]), max_size=8).map("\n".join)


def test_edits_of_different_lines_are_both_in_the_result():
    assert merge("a\nb\nc", "a 1\nb\nc", "a\nb\nc 2") == Merge("a 1\nb\nc 2")


def test_edits_of_neighbouring_lines_are_no_conflict():
    assert merge("a\nb", "a 1\nb", "a\nb 2") == Merge("a 1\nb 2")


def test_of_two_insertions_at_one_place_the_result_has_both():
    assert merge("a\nb", "a\n1\nb", "a\n2\nb") == Merge("a\n1\n2\nb")


def test_two_people_may_begin_to_write_in_the_same_empty_line():
    assert merge("a\n", "a\nx", "a\ny") == Merge("a\nx\ny")


def test_a_line_may_be_typed_on_while_another_is_inserted_before_it():
    assert merge("a\nm", "a\nx\nm", "a\nmo") == Merge("a\nx\nmo")


def test_the_same_edit_made_twice_is_made_once():
    assert merge("a\nb", "a\nx\nb", "a\nx\nb") == Merge("a\nx\nb")


def test_an_insertion_that_was_continued_is_not_repeated():
    assert merge("a\nb", "a\nx\ny\nb", "a\nx\nb") == Merge("a\nx\ny\nb")


def test_of_two_edits_of_one_line_the_preferred_one_wins_and_is_called_a_conflict():
    assert merge("a\nb", "a 1\nb", "a 2\nb") == Merge("a 2\nb", is_conflict=True)


def test_a_short_line_that_occurs_twice_does_not_mislead():
    base, now = "a\n# \n# long", "a\n# b\n# long\n# "
    assert merge(base, now, "a\n# \n# longer") == Merge("a\n# b\n# longer\n# ")


def test_a_line_inserted_into_lines_that_are_deleted_is_a_conflict():
    assert merge("a\nb\nc\nd", "a\nb\nx\nc\nd", "a\nd") == Merge("a\nd", is_conflict=True)


def test_a_change_too_long_to_compare_is_one_change():
    base = "\n".join(f"line {number}" for number in range(600))
    assert 600 * 600 > merging.MOST_PAIRS
    other = base.replace("line 5\n", "line five\n")
    preferred = "first\n" + base + "\nlast"
    assert merge(base, other, preferred) == Merge(preferred, is_conflict=True)


@given(texts, texts)
def test_an_edit_merged_with_none_is_that_edit(base, edited):
    assert merge(base, edited, base) == Merge(edited)
    assert merge(base, base, edited) == Merge(edited)
    assert merge(base, edited, edited) == Merge(edited)


@given(texts, texts, texts)
def test_a_merge_without_conflict_has_every_inserted_line(base, other, preferred):
    merged = merge(base, other, preferred)
    lines = merged.text.split("\n")
    for edited in () if merged.is_conflict else (other, preferred):
        for line in filter(None, edited.split("\n")):
            assert line in base.split("\n") or line in lines


@given(texts, texts, texts)
def test_which_edit_is_preferred_decides_conflicts_alone(base, other, preferred):
    one, two = merge(base, other, preferred), merge(base, preferred, other)
    assert one.is_conflict == two.is_conflict
    if not one.is_conflict:
        assert sorted(one.text.split("\n")) == sorted(two.text.split("\n"))
