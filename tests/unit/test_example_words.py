"""Examples speak the user's language: comments, texts and names, and nothing else differs."""

import re
import tomllib
from itertools import zip_longest

import pytest

from learnblock.blocks.known import all_configurations
from learnblock.language import parse, to_workspace
from learnblock.running.examples import example_text, examples_folder
from places import ROOT

FOLDER = ROOT / "examples"
NAMES = sorted(path.relative_to(FOLDER).with_suffix("").as_posix() for path in FOLDER.rglob("*.bt"))
LANGUAGES = sorted(path.stem for path in (FOLDER / "words").glob("*.toml"))
#: A text with one of these is for people: values such as "red" have none.
FOR_PEOPLE = re.compile("[ !?]")


def words(language):
    return tomllib.loads((examples_folder() / "words" / f"{language}.toml").read_text("utf-8"))


def kinds(text):
    """The kinds of the blocks of a program; in a sentence, another language has another order."""
    workspace = to_workspace(parse(text, "example.bt"), all_configurations()).workspace
    return sorted(re.findall(r"type='([^']*)'", repr(workspace)))


@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize("name", NAMES)
def test_a_translated_example_is_the_same_program(name, language):
    text, translated = example_text(name), example_text(name, language)
    assert kinds(translated) == kinds(text)
    assert kinds(text)
    for before, after in zip_longest(text.split("\n"), translated.split("\n")):
        assert re.match(r"\s*", before)[0] == re.match(r"\s*", after)[0]


@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize("name", NAMES)
def test_every_comment_and_text_of_an_example_is_translated(name, language):
    known = words(language).get(name, {})
    text = example_text(name)
    comments = re.findall(r"# ?(.+)", text)
    texts = filter(FOR_PEOPLE.search, re.findall(r'"([^"\n]*)"', re.sub("#.*", "", text)))
    assert [word for word in (*comments, *texts) if word not in known] == []


@pytest.mark.parametrize("language", LANGUAGES)
def test_every_word_is_one_of_its_example(language):
    unused = [
        (name, word)
        for name, known in words(language).items()
        for word in known
        if word not in example_text(name)
    ]
    assert unused == []


@pytest.mark.parametrize("language", ["en", "fr", "../words/es", ""])
def test_a_language_without_words_gets_english(language):
    assert example_text("flower", language) == (FOLDER / "flower.bt").read_text("utf-8")


def test_skills_keep_their_names():
    assert "function.set_move(velocidad, giro)" in example_text("several/arrows", "es")
