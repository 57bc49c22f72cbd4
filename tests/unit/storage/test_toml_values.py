"""TOML from anyone is read in time linear in its size."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from learnblock.storage.toml_values import loads, written

DEEP = [
    "a." * 40_000 + "b = 1",
    "[" + "a . " * 40_000 + "b]",
    "x = {" + "'a'." * 99 + "b=1}",
    '"a b".' * 40_000 + "b = 1",
    '"a\\"b".' * 30_000 + "b = 1",
]


@pytest.mark.parametrize("source", DEEP)
def test_a_key_of_very_many_parts_is_refused(source):
    with pytest.raises(RecursionError):
        loads(source)


def test_a_number_of_very_many_digits_is_refused_at_once():
    with pytest.raises(ValueError, match="digits"):
        loads("x = " + "9" * 240_000)


@given(st.integers(1, 31))
def test_a_key_of_fewer_parts_is_read(parts):
    value = loads(".".join("a" * parts) + " = 1")
    for _ in range(parts):
        value = value["a"]
    assert value == 1


def test_a_value_is_written_as_toml_writes_it_and_what_is_long_is_left_out():
    value = [True, "a", 0.5, {"b": 1}, (1, 2)]
    assert written(value) == '[true, "a", 0.5, {...}, [1, 2]]'
    assert written(list(range(20))) == "[0, 1, 2, 3, 4, 5, 6, 7]"
    assert written((1.0, 0.25), "{:g}".format) == "[1, 0.25]"
