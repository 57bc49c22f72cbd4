"""The examples in our docstrings."""

import doctest
from importlib import import_module

import pytest


@pytest.mark.parametrize(
    "name",
    [
        "learnblock.blocks.source.derivation",
        "learnblock.blocks.schema.loading",
        "learnblock.testing.clock",
        "learnblock.testing.robot",
    ],
)
def test_the_examples_of_a_module_s_documentation_work(name):
    flags = doctest.ELLIPSIS | doctest.NORMALIZE_WHITESPACE
    outcome = doctest.testmod(import_module(name), optionflags=flags)

    assert 0 == outcome.failed
    assert outcome.attempted > 0
