"""Which variables belong to a function, and which to the program, by its Python."""

import ast
from collections.abc import Iterator


def locals_in(source: str, line: int) -> frozenset[str]:
    """The variables of the function that begins in a line: it writes them, and shares none.

    Args:
        source: the program.
        line: that of the function's ``def``.
    """
    for node in ast.walk(ast.parse(source)):
        if isinstance(node, ast.FunctionDef) and node.lineno == line:
            shared = {name for names in _declared(node, ast.Global, ast.Nonlocal) for name in names}
            return frozenset({*_stored(node)} - shared)
    return frozenset()


def globals_by_line(source: str) -> dict[int, frozenset[str]]:
    """By the line of a function: the names that it declares as global."""
    try:
        tree = ast.parse(source)
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        return {}
    return {
        node.lineno: frozenset(name for names in _declared(node, ast.Global) for name in names)
        for node in ast.walk(tree)
        if isinstance(node, ast.FunctionDef)
    }


def _declared(
    function: ast.FunctionDef, *kinds: type[ast.Global | ast.Nonlocal]
) -> Iterator[list[str]]:
    """The names in each declaration of some kinds."""
    for node in ast.walk(function):
        if isinstance(node, kinds):
            yield node.names


def _stored(function: ast.FunctionDef) -> Iterator[str]:
    """The variables that a function writes."""
    for node in ast.walk(function):
        if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Store):
            yield node.id
        elif isinstance(node, ast.ExceptHandler | ast.MatchAs | ast.MatchStar) and node.name:
            yield node.name
        elif isinstance(node, ast.MatchMapping) and node.rest:
            yield node.rest
