"""Find the names that a single statement uses, including those in its raw Python."""

import ast
from collections.abc import Iterator

from learnblock.language.check.findings import defined_names, python_error
from learnblock.language.python.scopes import stored_names
from learnblock.language.tree.markers import raw_names
from learnblock.language.tree.nodes import Call, Def, Item, Name, Raw, RawExpression
from learnblock.language.tree.traversal import all_expressions, statements


def called_by(function: Def) -> Iterator[str]:
    """The names of the functions that a function calls."""
    for statement in statements((function,)):
        for node in all_expressions(statement):
            if isinstance(node, Call):
                yield node.name


def names_in(statement: Item) -> Iterator[tuple[Name | Raw | RawExpression, str]]:
    """The names in a statement without its bodies, including those in its raw Python."""
    if isinstance(statement, Raw):
        for name in sorted(raw_names(statement.text)):
            yield statement, name
    for node in all_expressions(statement):
        if isinstance(node, Name):
            yield node, node.name
        elif isinstance(node, RawExpression):
            for name in sorted(raw_names(node.text.strip())):
                yield node, name


def set_by_python(text: str) -> set[str]:
    """The names that raw Python sets, defines and imports."""
    if python_error(text, "exec"):
        return set()
    return defined_names(text) | stored_names(ast.parse(text))
