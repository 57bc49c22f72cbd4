"""Block sets: the built-in sets name existing blocks, and a user's file may have any content."""

import msgspec
import pytest
from hypothesis import given
from hypothesis import strategies as st

from learnblock.blocks import block_sets, builtin
from learnblock.blocks.block_sets import BlockNames, BlockSet
from learnblock.blocks.palette import palette
from learnblock.errors import BlockSetError, UnknownNameError

LESSON = """\
[title]
en = "Tuesday"

[show]
categories = ["Base"]
blocks = ["lb_main", "function.somebody_elses"]
"""

words = st.text(st.characters(codec="utf-8", exclude_characters="\0"), min_size=1, max_size=20)
names = st.builds(
    BlockNames,
    categories=st.lists(words, max_size=3).map(tuple),
    blocks=st.lists(words, max_size=3).map(tuple),
)
texts = st.dictionaries(st.sampled_from(["en", "es", "eu-ES"]), words, max_size=3)
sets = st.builds(
    BlockSet,
    name=st.just("lesson"),
    title=texts,
    description=texts,
    show=names,
    hide=names,
)


@pytest.fixture(autouse=True)
def own_home(tmp_path, monkeypatch):
    monkeypatch.setenv("LEARNBLOCK_HOME", str(tmp_path))
    return tmp_path


@pytest.fixture(scope="module")
def tabs():
    return palette(builtin(), "en")["toolbox"]["contents"]


def test_a_first_lesson_shows_ten_blocks():
    first = block_sets.built_in()["first-steps"]
    assert (len(first.show.blocks), first.show.categories, first.hide) == (10, (), BlockNames())


def test_the_last_of_our_sets_hides_nothing():
    everything = block_sets.built_in()[block_sets.EVERYTHING]
    assert (everything.show, everything.hide) == (BlockNames(), BlockNames())


@pytest.mark.parametrize("name", block_sets.BUILT_IN)
def test_our_sets_name_existing_blocks_in_every_language(name, tabs):
    ours = block_sets.built_in()[name]
    blocks = {one["block"] for tab in tabs for one in tab.get("contents", ())}
    assert set(ours.show.blocks + ours.hide.blocks) - blocks == set()
    mentioned = set(ours.show.categories + ours.hide.categories)
    assert mentioned - {tab["category"] for tab in tabs} == set()
    assert {"en", "es"} == set(ours.title) == set(ours.description)


def test_no_two_blocks_of_a_tab_have_the_same_name(tabs):
    for tab in tabs:
        blocks = [one["block"] for one in tab.get("contents", ())]
        assert len(blocks) == len(set(blocks))


@given(sets)
def test_a_written_set_is_read_again(block_set):
    assert block_sets.parse(block_sets.write(block_set), "lesson") == block_set


def test_missing_blocks_are_kept_in_a_set():
    lesson = block_sets.parse(LESSON, "tuesday")
    assert "function.somebody_elses" in lesson.show.blocks
    assert "function.somebody_elses" in block_sets.write(lesson)


def test_a_set_is_saved_listed_and_deleted(own_home):
    lesson = block_sets.parse(LESSON, "tuesday")
    block_sets.save_own(lesson, replace=False)
    assert block_sets.own() == ((lesson,), ())
    block_sets.delete_own("tuesday")
    assert block_sets.own() == ((), ())


def test_a_set_is_replaced_only_on_request():
    lesson = block_sets.parse(LESSON, "tuesday")
    block_sets.save_own(lesson, replace=False)
    with pytest.raises(BlockSetError, match="already"):
        block_sets.save_own(lesson, replace=False)
    other = msgspec.structs.replace(lesson, show=BlockNames())
    block_sets.save_own(other, replace=True)
    assert block_sets.own()[0] == (other,)


@pytest.mark.parametrize("name", ["../x", "a/b", "", ".x", "nul", "first-steps", "x" * 61, "a\0"])
def test_an_invalid_file_name_is_refused(name, own_home):
    with pytest.raises(BlockSetError):
        block_sets.save_own(BlockSet(name=name), replace=True)
    assert list(own_home.rglob("*.toml")) == []


def test_a_missing_set_cannot_be_deleted():
    with pytest.raises(UnknownNameError):
        block_sets.delete_own("tuesday")


@pytest.mark.parametrize(
    ("text", "line", "message"),
    [
        ("[show]\nblock = []\n", 2, "Did you mean 'blocks'?"),
        ('[show]\nblocks = "lb_main"\n', 2, "must be a list"),
        ("[title]\nen = 3\n", 1, "'title'"),
        ("show = ]", 1, "This is not valid TOML"),
        (f"[show]\nblocks = {['x'] * 1001}\n", 2, "0 to 1,000 items"),
    ],
)
def test_an_invalid_file_is_reported_with_its_line(text, line, message):
    with pytest.raises(BlockSetError) as refused:
        block_sets.parse(text, "lesson")
    (diagnostic,) = refused.value.diagnostics
    assert (diagnostic.line, message in str(diagnostic.message)) == (line, True), diagnostic


def test_an_invalid_file_does_not_affect_the_others(own_home):
    (own_home / "sets").mkdir()
    (own_home / "sets" / "broken.toml").write_text("show = 3")
    (own_home / "sets" / "good.toml").write_text(LESSON)
    (own_home / "sets" / "folder.toml").mkdir()
    found, wrong = block_sets.own()
    assert ([one.name for one in found], len(wrong)) == (["good"], 2)
