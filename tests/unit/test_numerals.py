"""A number is written so that the sentence about it is true."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from learnblock.numerals import shown

numbers = st.floats(-1e6, 1e6)


@pytest.mark.parametrize(
    ("value", "others", "text"),
    [
        (3, (), "3"),
        (0.1 + 0.2, (), "0.3"),
        (0.1 + 0.2, (0.3,), "0.30000000000000004"),
        (0.3, (0.3,), "0.3"),
        (99.99999, (100,), "99.99999"),
        (2.004, (2,), "2.004"),
        (2.004, (3,), "2"),
        (90.0, (), "90"),
        (float("nan"), (1.0,), "nan"),
        (float("inf"), (1.0,), "inf"),
    ],
)
def test_a_number_has_as_many_digits_as_tell_it_from_the_others(value, others, text):
    assert shown(value, *others) == text


@given(numbers, numbers)
def test_the_written_number_compares_as_the_number_does(value, other):
    written = float(shown(value, other))
    assert (written < other, written == other) == (value < other, value == other)
