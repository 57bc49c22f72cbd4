"""The benchmarks use names that exist: only some of them run in a test."""

import ast
from importlib import import_module, util
from pathlib import Path

import pytest

BENCHMARKS = Path(__file__).parents[2] / "benchmarks"


@pytest.mark.parametrize("file", sorted(BENCHMARKS.glob("*.py")), ids=lambda file: file.stem)
def test_what_a_benchmark_imports_of_learnblock_exists(file):
    missing = [
        f"{node.module}.{alias.name}"
        for node in ast.walk(ast.parse(file.read_text(encoding="utf-8")))
        if isinstance(node, ast.ImportFrom) and (node.module or "").startswith("learnblock")
        for alias in node.names
        if not exists(node.module, alias.name)
    ]
    assert missing == []


def exists(module, name):
    if util.find_spec(module) is None:
        return False
    return hasattr(import_module(module), name) or util.find_spec(f"{module}.{name}") is not None
