"""The parts of a Python tree that run at once, unlike the bodies of functions."""

import ast
from collections.abc import Iterable, Iterator

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
        inner = ahead.pop()
        yield inner
        ahead += reversed(list(_inner(inner)))


def loaded_names(node: ast.AST) -> Iterator[str]:
    """The names whose values are needed when a statement or an expression runs."""
    for inner in at_once(node):
        if isinstance(inner, ast.Name) and isinstance(inner.ctx, ast.Load):
            yield inner.id


def bound_names(nodes: Iterable[ast.AST]) -> Iterator[str]:
    """Every name that a program sets anywhere."""
    for node in nodes:
        match node:
            case ast.Name(id=name, ctx=ast.Store() | ast.Del()):
                yield name
            case ast.FunctionDef() | ast.AsyncFunctionDef() | ast.ClassDef():
                yield node.name
            case ast.arg(arg=name):
                yield name
            case ast.alias(name=name, asname=other):
                yield (other or name).partition(".")[0]
            case ast.ExceptHandler(name=str(name)):
                yield name
            case ast.Global(names=names) | ast.Nonlocal(names=names):
                yield from names
            case ast.pattern():
                yield from matched_names(node)


def matched_names(node: ast.AST) -> Iterator[str]:
    """The names that a part of a pattern itself sets."""
    match node:
        case (
            ast.MatchAs(name=str(name))
            | ast.MatchStar(name=str(name))
            | ast.MatchMapping(rest=str(name))
        ):
            yield name


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
