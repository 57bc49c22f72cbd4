"""Skills as methods of a stub file."""

import ast

import pytest

from learnblock.stubs.methods import methods_of


def written(source: str) -> tuple[str, frozenset[str]]:
    (method,) = methods_of(source, "own.py")
    ast.parse(f"class Robot:\n{method.text}")
    return method.text, method.imports


@pytest.mark.parametrize(
    ("head", "method"),
    [
        ("def f(robot): pass", "def f(self) -> None:"),
        ("def f(robot): return 1", "def f(self):"),
        ("def f(robot, a, b=2): pass", "def f(self, a, b=2) -> None:"),
        ("def f(robot, a: 'int' = 2) -> 'bool': pass", "def f(self, a: int = 2) -> bool:"),
        ("def f(robot, /, a, *more, b, **c): pass", "def f(self, /, a, *more, b, **c) -> None:"),
        ("def f(robot, a, /, *, b=()): pass", "def f(self, a, /, *, b=()) -> None:"),
        ("def f(robot, a=sum([])): pass", "def f(self, a=...) -> None:"),
        ("SPEED = 'x'\ndef f(robot, a=SPEED): pass", 'def f(self, a="x") -> None:'),
    ],
)
def test_the_robot_becomes_self_and_the_rest_stays(head, method):
    text, imports = written(head)
    assert f"    {method}\n        ..." == text
    assert frozenset() == imports


def test_a_hint_brings_its_import():
    text, imports = written("from learnblock.fields import Angle\ndef f(robot, a: Angle): pass")
    assert "a: Angle" in text
    assert {"from learnblock.fields import Angle"} == imports


@pytest.mark.parametrize("hint", ["Mine", "'Mine'", "'not a hint'", "list[Mine]"])
def test_a_hint_that_only_its_file_knows_is_any(hint):
    text, imports = written(f"class Mine: ...\ndef f(robot, a: {hint}): pass")
    assert "a: Any" in text
    assert {"from typing import Any"} == imports


def test_a_long_head_has_a_line_for_each_parameter():
    names = [f"parameter_number_{number}" for number in range(8)]
    text, _ = written(f"def f(robot, {', '.join(names)}): pass")
    assert ["    def f(", "        self,", "        parameter_number_0,"] == text.split("\n")[:3]


def test_the_docstring_is_kept_with_its_lines_and_quotes():
    text, _ = written("def f(robot):\n    r'''Say \\d \"\"\".\n\n    More.\n    '''")
    (function,) = ast.parse(f"class Robot:\n{text}").body[0].body
    assert 'Say \\d """.\n\nMore.' == ast.get_docstring(function)
