"""Tables of settings: of a robot, or of anything else, in one file."""

from typing import Annotated, Literal

import pytest
from hypothesis import given
from hypothesis import strategies as st
from msgspec import Meta

from learnblock.errors import SettingsError
from learnblock.settings import Settings, Table, file


class Mine(Settings, frozen=True):
    number: Annotated[int, Meta(ge=0, le=63)] | Literal["none"] = "none"
    version: Literal["auto", "2020"] = "auto"
    text: Annotated[str, Meta(max_length=100)] = ""
    on: bool = False


OUTER = Table(("mine",), "mine", Mine)
INNER = Table(("all", "of-mine"), "the inner mine", Mine)


@pytest.mark.parametrize(
    ("name", "text", "value"),
    [
        ("number", "7", 7),
        ("number", "none", "none"),
        ("version", "2020", "2020"),
        ("text", "7", "7"),
        ("text", "true", "true"),
        ("on", "true", True),
    ],
)
def test_what_is_typed_is_what_its_setting_allows(name, text, value):
    assert getattr(OUTER.change(name, text), name) == value
    assert getattr(OUTER.load(), name) == value


def test_tables_stand_in_one_file_and_leave_each_other_alone():
    OUTER.change("number", "1")
    INNER.change("number", "2")
    OUTER.change("on", "true")
    assert (OUTER.load().number, INNER.load().number) == (1, 2)
    assert (OUTER.load().on, INNER.load().on) == (True, False)


def test_a_table_of_anothers_is_nobodys_mistake():
    file().write_text("[other]\nx = 1\n[all.others]\ny = 2\n")
    assert OUTER.load() == INNER.load() == Mine()


@pytest.mark.parametrize(
    ("table", "text"),
    [
        (OUTER, "mine = 3\n"),
        (OUTER, "[[mine]]\nnumber = 1\n"),
        (INNER, "all = 3\n"),
        (INNER, "[all]\nof-mine = []\n"),
    ],
)
def test_a_table_that_is_none_is_told(table, text):
    file().write_text(text)
    with pytest.raises(SettingsError, match="expected a table of keys and values"):
        table.load()


@pytest.mark.parametrize("text", ["64", "-1", "1.5", "nan", "[]", "yes", "", "=", '"', "0\nx = 1"])
def test_what_it_may_not_be_is_refused_and_nothing_is_written(text):
    with pytest.raises(SettingsError, match="`number` is "):
        OUTER.change("number", text)
    assert not file().exists()


@given(st.text(st.characters(exclude_categories=["Cs"]), max_size=100))
def test_every_text_comes_back_from_the_file(text):
    OUTER.change("text", text)
    assert OUTER.load().text == text
