"""The parts of a Python tree that run at once, unlike the bodies of functions."""

import ast
from collections.abc import Iterator

Function = ast.FunctionDef | ast.AsyncFunctionDef


def parsed(text: str) -> ast.Module:
    """The tree of Python source; an empty one if it is not valid."""
    try:
        return ast.parse(text)
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        return ast.Module([], [])


def at_once(node: ast.AST) -> Iterator[ast.AST]:
    """The nodes that run when a statement or an expression runs, in source order."""
    ahead = [node]
    while ahead:
        found = ahead.pop()
        yield found
        ahead += reversed(list(_inner(found)))


def loaded_names(node: ast.AST) -> Iterator[str]:
    """The names whose values are needed when a statement or an expression runs."""
    for found in at_once(node):
        if isinstance(found, ast.Name) and isinstance(found.ctx, ast.Load):
            yield found.id


def _inner(node: ast.AST) -> Iterator[ast.AST]:
    match node:
        case ast.FunctionDef() | ast.AsyncFunctionDef():
            yield from node.decorator_list
            yield from _defaults(node.args)
        case ast.Lambda(args=arguments):
            yield from _defaults(arguments)
        case ast.Call(
            func=ast.Attribute(attr="wait_until") as called, args=[ast.Lambda() as until]
        ):
            yield called
            yield until.body
        case _:
            yield from ast.iter_child_nodes(node)


def _defaults(arguments: ast.arguments) -> Iterator[ast.AST]:
    yield from arguments.defaults
    yield from filter(None, arguments.kw_defaults)
