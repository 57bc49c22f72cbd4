"""Tables of settings, of a robot or anything else, in one file."""

from concurrent.futures import ThreadPoolExecutor
from typing import Annotated, Literal

import pytest
from hypothesis import given
from hypothesis import strategies as st
from msgspec import Meta

from learnblock.errors import SettingsError
from learnblock.i18n import Phrase
from learnblock.storage.settings import Settings, SettingsSection, file


class Mine(Settings, frozen=True):
    number: Annotated[int, Meta(ge=0, le=63)] | Literal["none"] = "none"
    version: Literal["auto", "2020"] = "auto"
    text: Annotated[str, Meta(max_length=100)] = ""
    on: bool = False


OUTER = SettingsSection(("mine",), "mine", Mine)
INNER = SettingsSection(("all", "of-mine"), "the inner mine", Mine)


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
def test_a_typed_value_is_read_as_its_setting_allows(name, text, value):
    assert getattr(OUTER.change(name, text), name) == value
    assert getattr(OUTER.load(), name) == value


def test_tables_in_one_file_do_not_affect_each_other():
    OUTER.change("number", "1")
    INNER.change("number", "2")
    OUTER.change("on", "true")
    assert (OUTER.load().number, INNER.load().number) == (1, 2)
    assert (OUTER.load().on, INNER.load().on) == (True, False)


def test_unknown_tables_are_ignored():
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
def test_a_value_instead_of_a_table_is_reported(table, text):
    file().write_text(text)
    with pytest.raises(SettingsError) as refused:
        table.load()
    (diagnostic,) = refused.value.diagnostics
    assert diagnostic.message.values["allowed"] == Phrase("toml-table")


@pytest.mark.parametrize("text", ["64", "-1", "1.5", "nan", "[]", "yes", "", "=", '"', "0\nx = 1"])
def test_an_invalid_value_is_refused_and_nothing_is_written(text):
    with pytest.raises(SettingsError) as refused:
        OUTER.change("number", text)
    (diagnostic,) = refused.value.diagnostics
    assert diagnostic.message.code == "toml-wrong-value"
    assert diagnostic.message.values["place"] == Phrase("file-place", path="number")
    assert not file().exists()


@given(st.text(st.characters(exclude_categories=["Cs"]), max_size=100))
def test_every_text_is_read_back_from_the_file(text):
    OUTER.change("text", text)
    assert OUTER.load().text == text


def test_a_change_keeps_comments_and_everything_else_in_the_file():
    text = """\
# Our robots.
[other]
x = 1  # another program's

[mine]
number = 3  # the one with the blue wheels
text = "a"
"""
    file().write_text(text)
    OUTER.change_all({"text": "", "on": True})
    OUTER.change("number", "4")
    assert file().read_text() == text.replace("= 3", "= 4").replace('text = "a"', "on = true")


def test_changes_at_the_same_time_are_all_saved():
    def count(table):
        for _ in range(8):
            table.update(lambda settings: {"text": settings.text + "x"})

    with ThreadPoolExecutor() as threads:
        list(threads.map(count, [OUTER, INNER, OUTER]))
    assert (len(OUTER.load().text), len(INNER.load().text)) == (16, 8)
