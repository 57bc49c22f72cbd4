"""Find the variables that Python functions have for themselves, and where each is first set."""

import ast
from collections.abc import Iterator

from learnblock.language.tree.loads import matched_names

#: The statements that have variables of their own.
SCOPES = (ast.FunctionDef, ast.AsyncFunctionDef, ast.ClassDef)
_WITH_LAMBDAS = (*SCOPES, ast.Lambda)


def first_of_locals(function: ast.FunctionDef) -> frozenset[ast.stmt]:
    """The assignments that are the first, from above, to set a local variable.

    Parameters and the variables of loops are local in every notation: no statement has to say it.
    """
    nodes = list(_own_nodes(function))
    known = {node.arg for node in ast.walk(function.args) if isinstance(node, ast.arg)}
    for node in nodes:
        if isinstance(node, ast.Global | ast.Nonlocal):
            known.update(node.names)
        elif isinstance(node, ast.For) and not node.orelse:
            known |= stored_names(node.target)
    firsts: list[ast.stmt] = []
    for node in nodes:
        match node:
            case ast.Assign(targets=[ast.Name(id=name)]) if name not in known:
                known.add(name)
                firsts.append(node)
    return frozenset(firsts)


def _own_nodes(node: ast.AST) -> Iterator[ast.AST]:
    """The nodes inside a function from top to bottom, without those of inner functions."""
    for inner in ast.iter_child_nodes(node):
        yield inner
        if not isinstance(inner, _WITH_LAMBDAS):
            yield from _own_nodes(inner)


def stored_names(node: ast.AST) -> set[str]:
    """The variables that a syntax tree sets or deletes."""
    names: set[str] = set()
    for inner in ast.walk(node):
        if isinstance(inner, ast.Name) and not isinstance(inner.ctx, ast.Load):
            names.add(inner.id)
        else:
            names.update(matched_names(inner))
    return names
