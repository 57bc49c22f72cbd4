"""Whether a statement repeats, waits or asks is said by the tree, not by whoever reads it."""

import ast

import pytest

from learnblock.language.blocktext.parser import parse
from learnblock.language.tree.flow import (
    bounds,
    condition_of,
    conditions,
    is_counted,
    is_endless,
    is_loop,
    is_waiting,
)
from places import ROOT

ASKED = (is_loop, is_counted, is_endless, is_waiting)
FLOW = {"While", "Repeat", "ForEach", "ForRange", "WaitUntil"}


def statement(text):
    return parse(f"main:\n{text}\nend\n").main.body[0]


@pytest.mark.parametrize(
    ("text", "is_so"),
    [
        ("while x < 3:\npass\nend", {is_loop}),
        ("forever:\npass\nend", {is_loop, is_endless}),
        ("repeat 3:\npass\nend", {is_loop, is_counted}),
        ("for x in [1]:\npass\nend", {is_loop, is_counted}),
        ("for x from 1 to 3:\npass\nend", {is_loop, is_counted}),
        ("wait until x < 3", {is_waiting}),
        ("if x < 3:\npass\nend", set()),
        ("x = 3", set()),
    ],
)
def test_the_tree_says_what_a_statement_does(text, is_so):
    node = statement(text)
    assert {ask for ask in ASKED if ask(node)} == is_so


def test_an_if_asks_in_each_of_its_branches_and_others_once():
    branching = statement("if x < 3:\npass\nelif x < 5:\npass\nelse:\npass\nend")
    waiting = statement("wait until x < 3")
    assert condition_of(branching) is None
    assert len(list(conditions(branching))) == 2
    assert list(conditions(waiting)) == [waiting.condition]
    assert list(conditions(statement("x = 3"))) == []


def test_a_loop_that_names_numbers_is_bound_by_them():
    counted = statement("for x from 1 to 3:\npass\nend")
    assert bounds(counted) == (counted.start, counted.stop)
    assert bounds(statement("forever:\npass\nend")) == ()


def test_hints_know_no_kind_of_loop():
    named = [
        (file.name, name)
        for file in sorted((ROOT / "src/learnblock/lessons/hints").glob("*.py"))
        for node in ast.walk(ast.parse(file.read_text("utf-8")))
        if isinstance(node, ast.ImportFrom)
        for name in {alias.name for alias in node.names} & FLOW
    ]
    assert named == []
