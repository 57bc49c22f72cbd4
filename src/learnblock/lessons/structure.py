"""How a program is built: what it uses, and how many blocks it has."""

from collections.abc import Callable, Iterator, Mapping
from typing import Any

from learnblock.language.tree.flow import is_endless, is_loop
from learnblock.language.tree.nodes import (
    Assign,
    Blank,
    Call,
    Comment,
    Def,
    Expression,
    If,
    Import,
    Item,
    List,
    Main,
    Name,
    Pass,
    Program,
    Repeat,
    Return,
    SkillCall,
    When,
)
from learnblock.language.tree.traversal import expressions, statements, within
from learnblock.lessons.checks import Construct, Uses

Node = Item | Main | Expression

#: Statements and items that have no block of their own.
_NO_BLOCKS = (Blank, Comment, Def, Import, Main, Pass)


def count(program: Program, check: Uses) -> int:
    """How often a program uses what a check asks for."""
    if check.skill is not None:
        return sum(_calls(node, SkillCall, check.skill) for node in nodes(program))
    if check.function is not None:
        return sum(_calls(node, Call, check.function) for node in nodes(program))
    is_one = _CONSTRUCTS[check.construct or "loop"]
    return sum(is_one(node) for node in nodes(program))


def size(program: Program) -> int:
    """How many statement blocks a program has, without the heads of functions."""
    return sum(not isinstance(node, _NO_BLOCKS) for node in every_statement(program))


def every_statement(program: Program) -> Iterator[Item | Main]:
    """Each statement, in the order of the source."""
    yield from statements(program.items)
    if program.main is not None:
        yield program.main
        yield from statements(program.main.body)


def nodes(program: Program) -> Iterator[Node]:
    """Each statement and each expression."""
    for statement in every_statement(program):
        yield statement
        for expression in expressions(statement):
            yield from within(expression)


def _calls(node: Node, kind: type[Call | SkillCall], name: str) -> bool:
    return isinstance(node, kind) and node.name == name


def _has_else(node: Any) -> bool:
    return isinstance(node, If) and (node.otherwise is not None or len(node.branches) > 1)


def _sets_variable(node: Any) -> bool:
    return isinstance(node, Assign) and isinstance(node.target, Name)


def _calls_function(*names: str) -> Callable[[Any], bool]:
    return lambda node: isinstance(node, Call) and node.name in names


#: Whether a node is one of the parts that a check can ask for.
_CONSTRUCTS: Mapping[Construct, Callable[[Any], bool]] = {
    "loop": is_loop,
    "repeat": lambda node: isinstance(node, Repeat),
    "forever": is_endless,
    "if": lambda node: isinstance(node, If),
    "else": _has_else,
    "when": lambda node: isinstance(node, When),
    "function": lambda node: isinstance(node, Def),
    "parameter": lambda node: isinstance(node, Def) and bool(node.parameters),
    "return": lambda node: isinstance(node, Return) and node.value is not None,
    "variable": _sets_variable,
    "list": lambda node: isinstance(node, List),
    "print": _calls_function("print"),
    "input": _calls_function("input"),
}
