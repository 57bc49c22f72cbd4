"""Find misspelled names in Block-Text and blocks without a robot, also in their parts in Python."""

import ast
from collections.abc import Iterator

from learnblock.errors import nearest
from learnblock.language.blocktext import names
from learnblock.language.check.findings import Findings, unknown
from learnblock.language.check.python_checker import DYNAMIC, PYTHON_NAMES
from learnblock.language.tree.builtins import FUNCTIONS
from learnblock.language.tree.loads import bound_names, parsed
from learnblock.language.tree.nodes import (
    AnyPython,
    Call,
    Def,
    Expression,
    Item,
    Name,
    RawExpression,
    Span,
)
from learnblock.language.tree.traversal import all_expressions, set_by, targets

#: What is right elsewhere: in a class, as the palette's blocks have it, and in other programs.
_NO_SLIPS = frozenset(("self", "robot"))


def check_plain_names(findings: Findings) -> None:
    """Report the names that a program without a robot uses and sets nowhere."""
    checker = _Checker(findings)
    if not checker.may_set_others():
        checker.run()


class _Checker:
    def __init__(self, findings: Findings) -> None:
        self.findings = findings
        self.python = [tree for item in findings.everything for tree in _trees(item)]
        self.bound = {*findings.functions, *findings.whens}
        for item in findings.everything:
            self.bound.update(set_by(item), item.parameters if isinstance(item, Def) else ())
        # In Python, a name may have another spelling.
        self.bound.update([names.to_python(name) for name in self.bound])
        for tree in self.python:
            self.bound.update(bound_names(list(ast.walk(tree))))
        self.known = self.bound | PYTHON_NAMES | FUNCTIONS | _NO_SLIPS
        self.used = [use for item in findings.everything for use in _used(item)]
        self.seen: set[str] = set()

    def may_set_others(self) -> bool:
        """Whether the program may set names that cannot be found by reading it."""
        return (
            bool(self.findings.imported)
            or "*" in self.bound
            or any(not tree.body for tree in self.python)
            or any(name in DYNAMIC for name, _ in self.used)
        )

    def run(self) -> None:
        for name, node in self.used:
            known = name in self.known or names.to_python(name) in self.known
            if not known and name not in self.seen:
                self.seen.add(name)
                self.report(name, node)

    def report(self, name: str, node: Call | Span) -> None:
        is_called = isinstance(node, Call)
        near = nearest(name, [*self.bound, *(FUNCTIONS if is_called else ())])
        sort = "function" if is_called else "name"
        span = node.span if isinstance(node, Call) else node
        self.findings.report(f"unknown-{sort}", unknown(sort, name, near), span)


def _trees(item: Item) -> Iterator[ast.Module]:
    """The parts of a statement that are Python; a part that is not valid has no statements."""
    if isinstance(item, AnyPython):
        yield parsed(item.text.removeprefix("@"))
    for node in all_expressions(item):
        if isinstance(node, RawExpression):
            yield parsed(node.text.strip())


def _used(item: Item) -> Iterator[tuple[str, Call | Span]]:
    """The names that a statement reads, with their places, and those that it calls."""
    if isinstance(item, AnyPython):
        for name in _loaded(item.text.removeprefix("@")):
            yield name, item.span._replace(end_column=0)
    own = {id(target) for target in targets(item)}
    for node in all_expressions(item):
        if id(node) not in own:
            yield from _used_by(node)


def _used_by(node: Expression) -> Iterator[tuple[str, Call | Span]]:
    if isinstance(node, Name):
        yield node.name, node.span
    elif isinstance(node, Call):
        yield node.name, node
    elif isinstance(node, RawExpression):
        for name in _loaded(node.text.strip()):
            yield name, node.span


def _loaded(text: str) -> list[str]:
    return [
        node.id
        for node in ast.walk(parsed(text))
        if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Load)
    ]
