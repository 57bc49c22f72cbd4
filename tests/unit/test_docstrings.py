"""Every example in a docstring runs."""

import doctest
import importlib
from pathlib import Path

import pytest

import learnblock

PACKAGE = Path(learnblock.__file__).parent


def modules():
    """Yield the name of every module with a session at Python's prompt."""
    for file in sorted(PACKAGE.rglob("*.py")):
        if ">>> " in file.read_text(encoding="utf-8"):
            parts = file.relative_to(PACKAGE.parent).with_suffix("").parts
            yield ".".join(parts).removesuffix(".__init__")


def test_the_table_of_contents_names_existing_modules():
    assert [name for name in learnblock.__all__ if not hasattr(learnblock, name)] == []
    assert sorted(learnblock.__all__) == learnblock.__all__


@pytest.mark.parametrize("name", [*modules()])
def test_the_examples_of_a_module_run(name):
    failures, tried = doctest.testmod(importlib.import_module(name), optionflags=doctest.ELLIPSIS)
    assert failures == 0
    assert tried
