"""Find what a Python program uses above the line that defines it."""

import ast
import builtins
from collections.abc import Iterator
from typing import NamedTuple

from learnblock.i18n import Phrase
from learnblock.language.tree.loads import Function, at_once

_BUILTINS = frozenset(dir(builtins))
_BLOCKS = (ast.If, ast.For, ast.While, ast.With)
#: Statements of which only a part runs.
_CHOICES = (ast.Try, ast.TryStar, ast.Match)


class EarlyUse(NamedTuple):
    """A use of a name above its definition, and the message about it."""

    node: ast.expr
    message: Phrase


def early_uses(tree: ast.Module) -> Iterator[EarlyUse]:
    """Find the first use of each name that is defined only further below."""
    yield from _Order(tree).block(tree.body)


class _Order:
    """Follows the statements of a file in the order in which they run.

    A name that is set in a branch counts as set: only what fails whenever it runs is found.
    """

    def __init__(self, tree: ast.Module) -> None:
        self.lines = dict(_definitions(tree.body))
        self.functions: dict[str, ast.FunctionDef] = {}
        self.known: set[str] = set()
        self.called: set[str] = set()
        self.whens: list[ast.FunctionDef] = []

    def block(self, body: list[ast.stmt]) -> Iterator[EarlyUse]:
        for statement in body:
            yield from self.statement(statement)

    def statement(self, node: ast.stmt) -> Iterator[EarlyUse]:
        if isinstance(node, _CHOICES):
            self.known.update(_bound(node))
        elif isinstance(node, _BLOCKS):
            for inner in ast.iter_child_nodes(node):
                yield from self.part(inner)
        else:
            yield from self.whole(node)

    def part(self, node: ast.AST) -> Iterator[EarlyUse]:
        """Follow a statement in a block, or what its first line evaluates and sets."""
        if isinstance(node, ast.stmt):
            yield from self.statement(node)
        else:
            yield from self.whole(node)

    def whole(self, node: ast.AST) -> Iterator[EarlyUse]:
        yield from self.uses(node)
        self.known.update(_bound(node))
        if isinstance(node, ast.FunctionDef):
            self.define(node)

    def define(self, node: ast.FunctionDef) -> None:
        if any("robot.when" in ast.unparse(one) for one in node.decorator_list):
            self.whens.append(node)
        else:
            self.functions[node.name] = node

    def uses(self, node: ast.AST, own: frozenset[str] = frozenset()) -> Iterator[EarlyUse]:
        """Find early uses in what runs at once, also through the functions that it calls."""
        for inner in at_once(node):
            match inner:
                case ast.Name(id=name, ctx=ast.Load()) if self.is_early(name) and name not in own:
                    self.known.add(name)
                    yield EarlyUse(inner, self.message(inner))
                case ast.Call(func=ast.Name(id=name)) if name in self.functions:
                    yield from self.call(self.functions[name])
                case ast.Call(func=ast.Attribute(value=ast.Name(id="robot"), attr="run")):
                    for when in self.whens:
                        yield from self.call(when)

    def call(self, function: ast.FunctionDef) -> Iterator[EarlyUse]:
        if function.name in self.called:
            return
        self.called.add(function.name)
        own = frozenset(_own_names(function))
        for statement in function.body:
            yield from self.uses(statement, own)

    def is_early(self, name: str) -> bool:
        return name in self.lines and name not in self.known and name not in _BUILTINS

    def message(self, node: ast.Name) -> Phrase:
        return Phrase("check-defined-below", name=node.id, line=str(self.lines[node.id]))


def _definitions(body: list[ast.stmt]) -> Iterator[tuple[str, int]]:
    """The functions, events and classes of the top level, each with its line."""
    for node in body:
        if isinstance(node, Function | ast.ClassDef):
            yield node.name, node.lineno


def _bound(node: ast.AST) -> Iterator[str]:
    """The names that a statement sets; branches count."""
    for inner in at_once(node):
        match inner:
            case ast.Name(id=name, ctx=ast.Store()):
                yield name
            case ast.FunctionDef(name=name) | ast.ClassDef(name=name):
                yield name
            case ast.AsyncFunctionDef(name=name):
                yield name
            case ast.alias(name=name, asname=other):
                yield (other or name).partition(".")[0]


def _own_names(function: ast.FunctionDef) -> Iterator[str]:
    """The parameters and local variables of a function."""
    shared: set[str] = set()
    own: set[str] = set()
    for node in ast.walk(function):
        match node:
            case ast.arg(arg=name) | ast.Name(id=name, ctx=ast.Store()):
                own.add(name)
            case ast.Global(names=names):
                shared.update(names)
    yield from own - shared
