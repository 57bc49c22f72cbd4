from contextlib import suppress

import pytest
from hypothesis import given
from hypothesis import strategies as st

from learnblock.errors import LearnBlockError, TagNamesError, UnknownNameError
from learnblock.i18n import Phrase
from learnblock.monitor.tag_sheet import sheet
from learnblock.perception.tag_names import (
    parse,
    save_names,
    tag_id,
    tag_names,
    write,
)


@pytest.fixture
def dictionary(tmp_path, monkeypatch):
    monkeypatch.setenv("LEARNBLOCK_HOME", str(tmp_path))
    return tmp_path / "tags.toml"


@pytest.mark.parametrize("tag", [8, 8.0, "8", " 8 "])
def test_a_number_is_itself_however_it_is_written(dictionary, tag):
    assert tag_id(tag) == 8


def test_without_a_dictionary_there_are_no_names(dictionary):
    assert tag_names() == {}


def test_a_name_is_looked_up(dictionary):
    dictionary.write_text('ball = 3\n"red door" = 12\n')

    assert (tag_id("ball"), tag_id("red door")) == (3, 12)


def test_a_changed_dictionary_is_read_again(dictionary):
    dictionary.write_text("ball = 3\n")
    tag_id("ball")
    dictionary.write_text("ball = 3\ngoal = 44\n")

    assert tag_id("goal") == 44


@pytest.mark.parametrize("tag", [-1, 587, "587"])
def test_an_unknown_tag_number_is_refused_with_the_known_ones(dictionary, tag):
    with pytest.raises(LearnBlockError) as refused:
        tag_id(tag)
    assert refused.value.phrase == Phrase("world-no-tag", number=str(tag), last="586")


@pytest.mark.parametrize("tag", [2.5, float("nan"), None, [3]])
def test_neither_a_number_nor_a_name_is_refused(dictionary, tag):
    with pytest.raises(UnknownNameError) as refused:
        tag_id(tag)
    assert refused.value.phrase == Phrase("unknown-name", kind="tag", name=str(tag))


def test_a_similar_name_is_suggested(dictionary):
    dictionary.write_text("ball = 3\n")

    with pytest.raises(UnknownNameError, match=r"no tag 'bal'. Did you mean 'ball'"):
        tag_id("bal")


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("goal = 1\nball = 587\n", ":2:0: bad-tag 'ball' has the value 587"),
        ('ball = "3"\n', ":1:0: bad-tag 'ball' has the value '3'"),
        ("ball = true\n", ":1:0: bad-tag 'ball' has the value True"),
        ("[more]\nball = 3\n", ":0:0: bad-tag 'more' has the value {'ball': 3}"),
        ("ball: 3\n", "not-toml .* such as: ball = 3"),
    ],
)
def test_an_invalid_dictionary_is_refused_with_its_line(dictionary, text, message):
    dictionary.write_text(text)

    with pytest.raises(TagNamesError, match=message):
        tag_id("ball")


@pytest.mark.parametrize("name", ["tags.toml", "tags.csv"])
def test_a_dictionary_that_is_written_is_read_again(name):
    names = {"ball": 3, "red door": 12, 'a "quoted", one': 3, "größe": 586}
    written = write(names, as_csv=name.endswith(".csv"))
    assert parse(written, name) == names


@given(st.dictionaries(st.text(min_size=1, max_size=20), st.integers(0, 586), max_size=5))
def test_all_written_names_are_read_again(names):
    with suppress(TagNamesError):
        assert parse(write(names), "tags.toml") == names
        stripped = {name.strip(): number for name, number in names.items()}
        assert parse(write(names, as_csv=True), "tags.csv") == stripped


def test_a_spreadsheet_table_needs_no_header(dictionary):
    assert parse("ball,3\r\n red door ,12\r\n", "TAGS.CSV") == {"ball": 3, "red door": 12}


def test_saved_names_replace_the_previous_ones(dictionary):
    save_names({"ball": 3})
    save_names({"goal": 4})
    assert tag_names() == {"goal": 4}


@pytest.mark.parametrize(
    ("names", "code"),
    [
        ({"": 3}, "perception-tags-bad-name"),
        ({"a\nb": 3}, "perception-tags-bad-name"),
        ({"x" * 101: 3}, "perception-tags-bad-name"),
        ({"12": 3}, "perception-tags-number-as-name"),
        ({"ball": 587}, "perception-tags-bad-number"),
        ({str(one) + "x": 1 for one in range(2001)}, "perception-tags-too-many"),
    ],
    ids=["empty", "two lines", "long", "a number", "no tag", "many"],
)
def test_an_invalid_dictionary_is_not_saved(names, code, dictionary):
    with pytest.raises(TagNamesError) as refused:
        save_names(names)
    assert code in {problem.message.code for problem in refused.value.diagnostics}
    assert not dictionary.exists()


@pytest.mark.parametrize(
    ("name", "text", "message"),
    [
        ("tags.csv", "ball,3,4\n", "'ball' has the value 'ball,3,4'"),
        ("tags.csv", "name,tag\nball,many\n", "'ball' has the value 'many'"),
        ("tags.toml", "a = [" * 5000, "such as: ball = 3"),
        ("tags.toml", "#" * 300_000, "the limit is 262,144"),
    ],
)
def test_a_file_that_is_not_a_dictionary_is_refused(name, text, message):
    with pytest.raises(TagNamesError, match=message):
        parse(text, name)


def test_a_sheet_shows_each_tag_in_its_size_with_its_name():
    page = sheet([(3, "ball & bat"), (12, "")], 40)
    assert page.count("<img ") == 2
    assert "3 ball &amp; bat</figcaption>" in page
    assert "inline-size: 50mm" in page
