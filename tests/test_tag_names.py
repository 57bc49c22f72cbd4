import pytest

from learnblock.errors import UnknownNameError
from learnblock.tag_names import TagNamesError, tag_id, tag_names


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


@pytest.mark.parametrize("tag", [-1, 587, "587", 2.5, float("nan"), None, [3]])
def test_what_is_no_tag_is_refused_with_the_numbers_there_are(dictionary, tag):
    with pytest.raises(UnknownNameError, match="numbers 0 to 586"):
        tag_id(tag)


def test_a_name_that_is_nearly_right_is_corrected(dictionary):
    dictionary.write_text("ball = 3\n")

    with pytest.raises(UnknownNameError, match="no tag `bal`; did you mean `ball`"):
        tag_id("bal")


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("goal = 1\nball = 587\n", ":2:0: bad-tag `ball` is 587; a tag's number is a whole"),
        ('ball = "3"\n', ":1:0: bad-tag `ball` is '3'; a tag's number"),
        ("ball = true\n", ":1:0: bad-tag `ball` is True"),
        ("[more]\nball = 3\n", ":0:0: bad-tag `more` is {'ball': 3}"),
        ("ball: 3\n", "not-toml .*; write lines like `ball = 3`"),
    ],
)
def test_a_wrong_dictionary_is_refused_with_its_line(dictionary, text, message):
    dictionary.write_text(text)

    with pytest.raises(TagNamesError, match=message):
        tag_id("ball")
