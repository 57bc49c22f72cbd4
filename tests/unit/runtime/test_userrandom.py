"""A program's random numbers are the same on every version of Python."""

import random

import pytest

from learnblock.runtime.userrandom import use_own_random


@pytest.mark.parametrize("limits", [(1, 6.0), (1.0, 6), (0.5, 1.5), (6 / 1, 9)])
@pytest.mark.parametrize("function", ["randint", "randrange"])
def test_a_limit_that_is_no_whole_number_is_refused_in_the_same_words(function, limits):
    restore = use_own_random()
    try:
        with pytest.raises(TypeError, match="'float' object cannot be interpreted as an integer"):
            getattr(random, function)(*limits)
    finally:
        restore()


def drawn(source):
    return [source.randint(1, 6) for _ in range(20)], source.choice("abc"), source.randrange(9)


def test_a_seed_gives_the_numbers_that_the_module_gives():
    restore = use_own_random()
    try:
        random.seed(7)
        own = drawn(random)
    finally:
        restore()
    assert own == drawn(random.Random(7))  # noqa: S311 - no secret
