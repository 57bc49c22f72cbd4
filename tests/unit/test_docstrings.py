"""Every example in a docstring runs."""

import doctest
import importlib
import pkgutil

import pytest

import learnblock


def modules():
    """Return every module with a session at Python's prompt."""
    for found in pkgutil.walk_packages(learnblock.__path__, "learnblock."):
        # Importing it would run it.
        if not found.name.endswith("__main__"):
            yield found.name


def test_the_table_of_contents_names_existing_modules():
    assert [name for name in learnblock.__all__ if not hasattr(learnblock, name)] == []
    assert sorted(learnblock.__all__) == learnblock.__all__


@pytest.mark.parametrize("name", ["learnblock", *modules()])
def test_the_examples_of_a_module_run(name):
    failures, _ = doctest.testmod(importlib.import_module(name), optionflags=doctest.ELLIPSIS)
    assert failures == 0
