"""What a statement itself uses, without those inside it, and also in raw Python."""

import ast
from collections.abc import Iterator

from learnblock.language.findings import defined_names, python_error
from learnblock.language.markers import raw_names
from learnblock.language.nodes import (
    Call,
    Def,
    Expression,
    Item,
    Name,
    Raw,
    RawExpression,
    expressions,
    statements,
    within,
)
from learnblock.language.python_scopes import stored_names


def called_by(function: Def) -> Iterator[str]:
    """The names of the functions that a function calls."""
    for statement in statements((function,)):
        for node in expressions_in(statement):
            if isinstance(node, Call):
                yield node.name


def names_in(statement: Item) -> Iterator[tuple[Name | Raw | RawExpression, str]]:
    """The names in a statement itself, also those that its raw Python uses."""
    if isinstance(statement, Raw):
        for name in sorted(raw_names(statement.text)):
            yield statement, name
    for node in expressions_in(statement):
        if isinstance(node, Name):
            yield node, node.name
        elif isinstance(node, RawExpression):
            for name in sorted(raw_names(node.text.strip())):
                yield node, name


def set_by_python(text: str) -> set[str]:
    """What raw Python sets, defines and imports."""
    if python_error(text, "exec"):
        return set()
    return defined_names(text) | stored_names(ast.parse(text))


def expressions_in(statement: Item) -> Iterator[Expression]:
    """Every expression of a statement itself."""
    for expression in expressions(statement):
        yield from within(expression)
