"""Phrases by code, and their words in each language."""

import pickle
import subprocess
import sys

import msgspec
import pytest

from learnblock.errors import LearnBlockError, WorldError
from learnblock.i18n import Phrase, languages, translate

TOO_LARGE = Phrase("file-too-large", name="square.bt", limit=4)


def test_a_phrase_reads_as_english():
    assert "square.bt is too large: the limit is 4 MB." == str(TOO_LARGE)


def test_a_phrase_is_translated():
    text = translate(TOO_LARGE, "es")
    assert "square.bt es demasiado grande: el límite es 4 MB." == text


def test_a_language_without_the_words_falls_back_to_english():
    assert str(TOO_LARGE) == translate(TOO_LARGE, "xx")


def test_a_phrase_within_a_phrase_is_in_the_same_language():
    outer = Phrase("file-too-large", name=TOO_LARGE, limit=1)
    assert 2 == translate(outer, "es").count("es demasiado grande")


def test_a_tuple_is_shown_as_a_list():
    phrase = Phrase("file-too-large", name=("a.bt", "b.bt"), limit=1)
    assert "a.bt, b.bt is too large: the limit is 1 MB." == str(phrase)


@pytest.mark.parametrize("text", ["The battery is empty.", "unknown-code", "", "no"])
def test_text_that_is_not_a_code_is_shown_unchanged(text):
    assert text == translate(Phrase(text), "es")


def test_a_missing_value_is_a_mistake_of_the_caller():
    with pytest.raises(ValueError, match="file-too-large in en"):
        str(Phrase("file-too-large", name="square.bt"))


def test_english_is_the_first_language():
    assert languages()[0] == "en"
    assert len(languages()) > 1


@pytest.mark.parametrize("form", [msgspec.json, msgspec.msgpack])
def test_a_phrase_can_be_sent(form):
    phrase = Phrase("a-b", inner=TOO_LARGE, several=("x", TOO_LARGE), number=1.5)
    assert phrase == form.decode(form.encode(phrase), type=Phrase)


@pytest.mark.parametrize(
    "value",
    [TOO_LARGE, LearnBlockError("file-too-large", name="square.bt", limit=4)],
    ids=["phrase", "error"],
)
def test_it_survives_pickling(value):
    assert str(value) == str(pickle.loads(pickle.dumps(value)))  # noqa: S301 - our own bytes


def test_an_error_has_its_phrase():
    error = LearnBlockError("file-too-large", name="square.bt", limit=4)
    assert TOO_LARGE == error.phrase
    assert str(TOO_LARGE) == str(error)


def test_an_error_of_a_file_reads_as_its_diagnostics():
    assert "w.toml:0:0: too-large x" == str(WorldError("w.toml", [diagnostic("x")]))


def test_raising_an_error_loads_no_words():
    program = (
        "import sys, learnblock.errors as e\n"
        "e.LearnBlockError('file-too-large', name='a', limit=1)\n"
        "assert not [m for m in sys.modules if m.startswith(('fluent', 'babel'))]\n"
    )
    subprocess.run([sys.executable, "-c", program], check=True)


def diagnostic(message):
    from learnblock.errors import Diagnostic

    return Diagnostic("too-large", message)


def test_equal_phrases_have_equal_hashes():
    one, other = (Phrase("file-too-large", name="a", limit=4) for _ in range(2))
    assert {one} == {other}
