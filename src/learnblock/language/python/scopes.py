"""Find out which local variables of Python functions could be shared by the whole program.

In Block-Text all variables are shared. A function does the same with shared variables if no other
code uses their names and the function is not recursive.
"""

import ast
from functools import cached_property

_KEEPS_VARIABLES = (
    ast.FunctionDef,
    ast.AsyncFunctionDef,
    ast.ClassDef,
    ast.Lambda,
    ast.Nonlocal,
    ast.Yield,
    ast.YieldFrom,
    ast.Await,
)


class Scopes:
    """The uses of the names in a file."""

    def __init__(self, tree: ast.Module) -> None:
        self.tree = tree

    @cached_property
    def users(self) -> dict[str, set[ast.stmt]]:
        """For each name, the statements of the top level that use it."""
        users: dict[str, set[ast.stmt]] = {}
        for statement in self.tree.body:
            for name in _names(statement):
                users.setdefault(name, set()).add(statement)
        return users

    @cached_property
    def mentioned(self) -> dict[str, set[str]]:
        """For each function, the names that it uses."""
        mentioned: dict[str, set[str]] = {}
        for statement in self.tree.body:
            if isinstance(statement, ast.FunctionDef):
                mentioned.setdefault(statement.name, set()).update(_names(statement))
        return mentioned

    def may_be_shared(self, own: set[str], function: ast.FunctionDef) -> bool:
        """Whether a function's `own` variables could be shared without changing its meaning."""
        if not own:
            return True
        inner = (node for node in ast.walk(function) if node is not function)
        return (
            all(self.users.get(name) == {function} for name in own)
            and not any(isinstance(node, _KEEPS_VARIABLES) for node in inner)
            and not self.is_recursive(function.name)
        )

    def is_recursive(self, function: str) -> bool:
        """Whether a function may call itself, directly or through others."""
        reached: set[str] = set()
        ahead = {function}
        while ahead:
            found = self.mentioned.get(ahead.pop(), set()) & self.mentioned.keys()
            ahead |= found - reached
            reached |= found
        return function in reached


def stored_names(node: ast.AST) -> set[str]:
    """The variables that a syntax tree sets or deletes."""
    return {
        inner.id
        for inner in ast.walk(node)
        if isinstance(inner, ast.Name) and not isinstance(inner.ctx, ast.Load)
    }


def _names(node: ast.AST) -> set[str]:
    found: set[str] = set()
    for inner in ast.walk(node):
        if isinstance(inner, ast.Name):
            found.add(inner.id)
        elif isinstance(inner, ast.Global):
            found.update(inner.names)
    if isinstance(node, ast.FunctionDef) and not node.args.defaults:
        found -= {argument.arg for argument in node.args.args}
    return found
