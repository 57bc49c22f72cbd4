import json

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from learnblock.devices import Emotion
from learnblock.runtime.values import described, encodable, plain, shortened

anything = st.recursive(
    st.none()
    | st.booleans()
    | st.integers()
    | st.floats()
    | st.text(st.characters())
    | st.binary()
    | st.complex_numbers(),
    lambda inner: st.lists(inner) | st.tuples(inner) | st.dictionaries(st.text(), inner),
    max_leaves=10,
)


@given(anything)
def test_plain_values_stay_unchanged(value):
    once = plain(value)
    assert json.dumps(once) == json.dumps(plain(once))


@given(anything)
def test_plain_values_can_be_encoded_in_utf_8(value):
    json.dumps(plain(value), ensure_ascii=False).encode()


@pytest.mark.parametrize(
    ("value", "expected"),
    [
        (3, 3),
        (2.5, 2.5),
        (None, None),
        (True, True),
        ("word", "word"),
        (Emotion.JOY, "joy"),
        ((1, [2, "x"]), [1, [2, "x"]]),
        (2**63, "9223372036854775808"),
        ({1: 2}, "{1: 2}"),
        (np.float64(1.5), 1.5),
        (np.zeros((2, 2)), "<array of shape (2, 2)>"),
        ("x" * 300, "x" * 200 + "..."),
        ([[[[1]]]], [[["[1]"]]]),
        ("\ud800", "\\ud800"),
    ],
)
def test_values_become_plain(value, expected):
    assert plain(value) == expected


def test_an_address_in_memory_is_not_shown():
    assert described(object()) == "<object object>"


def test_a_description_that_fails_is_shown_as_such():
    class Shy:
        def __repr__(self):
            raise ValueError

    assert described(Shy()) == "<ValueError in its own description>"


def test_only_long_texts_are_shortened():
    assert shortened("abc", 3) == "abc"
    assert shortened("abcd", 3) == "abc..."


def test_ordinary_text_is_not_changed():
    assert encodable("año 😀") == "año 😀"
