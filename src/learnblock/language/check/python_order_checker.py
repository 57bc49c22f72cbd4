"""Find what a Python program uses before the line that defines or sets it has run."""

import ast
import builtins
from collections import Counter
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from typing import NamedTuple

from learnblock.i18n import Phrase
from learnblock.language.check.walks import flattened
from learnblock.language.tree.loads import Function, at_once

_BUILTINS = frozenset((*dir(builtins), "__file__"))
#: Statements of which only a part runs.
_CHOICES = (ast.Try, ast.TryStar, ast.Match)
#: What sets names for a part of a statement only, or for its rest.
_COMPREHENSIONS = (ast.ListComp, ast.SetComp, ast.DictComp, ast.GeneratorExp)
_OWN_NAMES = (*_COMPREHENSIONS, ast.ClassDef, ast.NamedExpr)


class EarlyUse(NamedTuple):
    """A use of a name that has no value yet, and the message about it."""

    node: ast.expr
    message: Phrase


#: A walk through statements: its early uses, and the walks through the functions that they call.
_Uses = Iterator["EarlyUse | _Uses"]


def early_uses(tree: ast.Module, bound: Iterable[str]) -> Iterator[EarlyUse]:
    """Find the first early use of each of the names that are `bound` somewhere in a program."""
    yield from flattened(_Order(tree, frozenset(bound) - _BUILTINS).block(tree.body))


class _Order:
    """Follows the statements of a file in the order in which they run.

    A name that is set in a branch counts as set: only what fails whenever it runs is found.
    """

    def __init__(self, tree: ast.Module, bound: frozenset[str]) -> None:
        self.names = bound
        defined = [node for node in tree.body if isinstance(node, Function | ast.ClassDef)]
        self.lines = {node.name: node.lineno for node in defined}
        functions = [node for node in defined if isinstance(node, ast.FunctionDef)]
        self.functions = {
            node.name: node for node in functions if not any(map(_is_event, node.decorator_list))
        }
        self.known: set[str] = set()
        self.own: frozenset[str] = frozenset()  # the local names of the function that runs
        self.set_here: set[str] = set()  # those of them that are set
        self.in_loops: Counter[str] = Counter()  # as often as statements set them
        self.maybe: frozenset[str] = frozenset()  # what another branch may have set
        self.followed: set[tuple[str, bool]] = set()
        self.whens: list[ast.FunctionDef] = []

    # Statements.

    def block(self, body: Iterable[ast.stmt]) -> _Uses:
        for statement in body:
            yield from self.statement(statement)

    def statement(self, node: ast.stmt) -> _Uses:
        if isinstance(node, _CHOICES):
            self.bind(_bound(node))
        elif isinstance(node, ast.If):
            yield from self.uses(node.test)
            self.bind(_bound(node.test))
            for body in (node.body, node.orelse):
                yield from self.branch(body)
        elif isinstance(node, ast.For | ast.While):
            outer, self.in_loops = self.in_loops, self.in_loops + Counter(_bound(node))
            yield from self.parts(node)
            self.in_loops = outer
        elif isinstance(node, ast.With):
            yield from self.parts(node)
        else:
            yield from self.whole(node)

    def branch(self, body: list[ast.stmt]) -> _Uses:
        """Follow one of several bodies: the others may have run in an earlier round of the loop."""
        outer, others = self.maybe, self.in_loops - Counter(_bound_in(body))
        self.maybe = outer | others.keys()
        yield from self.block(body)
        self.maybe = outer

    def parts(self, node: ast.stmt) -> _Uses:
        """Follow the first line of a block, and the statements in it."""
        for inner in ast.iter_child_nodes(node):
            if isinstance(inner, ast.stmt):
                yield from self.statement(inner)
            else:
                yield from self.whole(inner)

    def whole(self, node: ast.AST) -> _Uses:
        yield from self.uses(node)
        self.bind(_bound(node))
        match node:
            case ast.FunctionDef(decorator_list=[decorator]) if _is_event(decorator):
                self.whens.append(node)
            case ast.FunctionDef(decorator_list=[_, *_]) | ast.ClassDef():
                # Something else may call it.
                self.known.update(_shared(node))

    def bind(self, names: Iterable[str]) -> None:
        for name in names:
            (self.set_here if name in self.own else self.known).add(name)

    # Uses.

    def uses(self, node: ast.AST) -> _Uses:
        """Find early uses in what runs at once, also through the functions that it calls."""
        nodes = list(at_once(node))
        inner_names = frozenset(_names_inside(nodes))
        called = {id(call.func) for call in nodes if isinstance(call, ast.Call)}
        for inner in nodes:
            match inner:
                case ast.Call(func=ast.Name(id=name)) if name in self.functions:
                    if name in self.known:
                        yield from self.call(self.functions[name])
                case ast.Call(func=ast.Attribute(value=ast.Name(id="robot"), attr="run")):
                    yield from self.events()
                case ast.Name(id=name, ctx=ast.Load()) if name in self.functions:
                    if id(inner) not in called:
                        self.known.update(_shared(self.functions[name]))
        for inner in nodes:
            match inner:
                case ast.Name(ctx=ast.Load()) | ast.AugAssign(target=ast.Name()):
                    read = inner.target if isinstance(inner, ast.AugAssign) else inner
                    if isinstance(read, ast.Name) and read.id not in inner_names:
                        yield from self.read(read)

    def read(self, node: ast.Name) -> _Uses:
        name = node.id
        is_known = name in (self.set_here if name in self.own else self.known)
        if is_known or name in self.maybe or name not in self.names:
            return
        self.bind([name])
        if name in self.lines and name not in self.own:
            line = str(self.lines[name])
            yield EarlyUse(node, Phrase("check-defined-below", name=name, line=line))
        else:
            yield EarlyUse(node, Phrase("check-read-before-set", name=name))

    def call(self, function: ast.FunctionDef, again: Counter[str] | None = None) -> _Uses:
        """Follow the first call of a function; later, at least as much is set."""
        key = (function.name, bool(self.maybe))
        if key not in self.followed:
            self.followed.add(key)
            with self.within(function, again or Counter()):
                yield self.block(function.body)

    def events(self) -> _Uses:
        whens, self.whens = self.whens, []
        for when in whens:
            if ast.unparse(when.decorator_list[0]) == "robot.when_start":
                yield from self.call(when)
        for when in whens:
            match when.decorator_list[0]:
                case ast.Call(args=[ast.Lambda(body=condition)]):
                    yield from self.uses(_certain(condition))
        known = self.known
        for when in whens:
            # Each runs again and again, after any other.
            self.known = known.union(
                *(self.shared_by(other) for other in whens if other is not when)
            )
            yield from self.call(when, Counter(_bound_in(when.body)))
        self.known = known

    def shared_by(self, function: ast.FunctionDef) -> set[str]:
        """The shared names that a function sets, also through those that it calls."""
        names: set[str] = set()
        seen: set[str] = set()
        ahead = [function]
        while ahead:
            inner = ahead.pop()
            names.update(_shared(inner))
            loaded = {node.id for node in ast.walk(inner) if isinstance(node, ast.Name)} - seen
            seen |= loaded
            ahead += (self.functions[name] for name in loaded & self.functions.keys())
        return names

    @contextmanager
    def within(self, function: ast.FunctionDef, again: Counter[str]) -> Iterator[None]:
        """Have the local names of a function; `again` are those that earlier runs of it set."""
        outer = self.own, self.set_here, self.in_loops
        self.own = frozenset(_own_names(function))
        self.set_here = {node.arg for node in ast.walk(function.args) if isinstance(node, ast.arg)}
        self.in_loops = again - Counter(self.own)
        yield
        self.own, self.set_here, self.in_loops = outer


def _is_event(decorator: ast.expr) -> bool:
    return ast.unparse(decorator).startswith("robot.when")


def _certain(condition: ast.expr) -> ast.expr:
    """The part of a condition that is evaluated in any case."""
    while True:
        match condition:
            case ast.BoolOp(values=[first, *_]) | ast.IfExp(test=first):
                condition = first
            case _:
                return condition


def _bound_in(body: Iterable[ast.stmt]) -> Iterator[str]:
    for statement in body:
        yield from _bound(statement)


def _bound(node: ast.AST) -> Iterator[str]:
    """The names that a statement sets; branches count."""
    for inner in at_once(node):
        match inner:
            case ast.Name(id=name, ctx=ast.Store()):
                yield name
            case ast.FunctionDef() | ast.AsyncFunctionDef() | ast.ClassDef():
                yield inner.name
            case ast.alias(name=name, asname=other):
                yield (other or name).partition(".")[0]
            case ast.ExceptHandler(name=str(name)):
                yield name
            case ast.MatchAs(name=str(name)) | ast.MatchStar(name=str(name)):
                yield name
            case ast.MatchMapping(rest=str(name)):
                yield name


def _names_inside(nodes: Iterable[ast.AST]) -> Iterator[str]:
    """The names that comprehensions, classes and ``:=`` set for the rest of a statement."""
    for node in nodes:
        if isinstance(node, _OWN_NAMES):
            yield from _bound(node)


def _shared(node: ast.AST) -> Iterator[str]:
    """The names that the functions in a statement share with the file."""
    for inner in ast.walk(node):
        if isinstance(inner, ast.Global):
            yield from inner.names


def _own_names(function: ast.FunctionDef) -> Iterator[str]:
    """The parameters and local names of a function."""
    own = {node.arg for node in ast.walk(function.args) if isinstance(node, ast.arg)}
    own.update(*(_bound(statement) for statement in function.body))
    own.update(name for node in ast.walk(function) for name in _names_inside([node]))
    yield from own - set(_shared(function))
