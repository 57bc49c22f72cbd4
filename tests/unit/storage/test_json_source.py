import json

import pytest
from hypothesis import given
from hypothesis import strategies as st

from learnblock.errors import BlockConfigurationError
from learnblock.i18n import Phrase
from learnblock.storage.json_source import JsonDocument, TextPosition, parse

texts = st.text(st.characters(exclude_categories=["Cs"]), max_size=8)
scalars = (
    st.none() | st.booleans() | st.integers() | st.floats(allow_nan=False, allow_infinity=False)
)
values = st.recursive(
    scalars | texts,
    lambda inner: st.lists(inner, max_size=3) | st.dictionaries(texts, inner, max_size=3),
    max_leaves=8,
)


def text_at(source: str, place: TextPosition) -> str:
    line = source.splitlines()[place.line - 1]
    return line[place.column - 1 : place.end_column - 1]


def part(document: JsonDocument, path: tuple[str | int, ...]) -> object:
    value = document.value
    for step in path:
        value = value[step]  # type: ignore[index]
    return value


@given(values, st.sampled_from([None, 1]))
def test_every_value_is_read_back(value, indent):
    assert value == parse(json.dumps(value, indent=indent), "f").value


@given(values, st.sampled_from([None, 1]))
def test_every_part_has_its_position(value, indent):
    source = json.dumps(value, indent=indent)
    document = parse(source, "f")

    for path, place in document.values.items():
        written = text_at(source, place)
        found = part(document, path)
        assert written in {"{", "["} or json.loads(written) == found
    for path, place in document.keys.items():
        assert json.loads(text_at(source, place)) == path[-1]


@given(st.dictionaries(texts, values, min_size=1, max_size=3))
def test_the_outer_braces_may_be_left_out(value):
    whole = parse(json.dumps(value), "f")
    braceless = parse(json.dumps(value)[1:-1], "f")

    assert whole.value == braceless.value
    assert [*whole.keys] == [*braceless.keys]


@given(st.text(st.sampled_from('{}[]:,"\\ \nanulltrue01.-e'), max_size=30) | st.text(max_size=20))
def test_any_text_is_read_or_refused_with_our_own_error(text):
    try:
        parse(text, "f")
    except BlockConfigurationError as error:
        (diagnostic,) = error.diagnostics
        assert diagnostic.message
        assert diagnostic.line <= len(text.splitlines()) + 1


def test_a_repeated_key_is_reported_with_its_later_position():
    document = parse('{"a": 1,\n "b": {"a": 2}, "a": 3}', "f")

    assert (("a", TextPosition(2, 17, 20)),) == document.repeated


@pytest.mark.parametrize("text", ["1 2", '{"a": 1} {"b": 2}'])
def test_more_than_one_value_is_refused(text):
    with pytest.raises(BlockConfigurationError) as refused:
        parse(text, "f")
    (diagnostic,) = refused.value.diagnostics
    assert diagnostic.message == Phrase("json-several-values")
