"""Extract functions from a program for a library, with everything they need."""

import ast
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from functools import cached_property

from learnblock.errors import Diagnostic, LibraryError, UnknownNameError
from learnblock.i18n import Phrase
from learnblock.language.blocktext.format import format as format_program
from learnblock.language.blocktext.names import state_of
from learnblock.language.check.findings import python_error
from learnblock.language.edit.symbols import Symbols
from learnblock.language.python.scopes import stored_names
from learnblock.language.tree import markers
from learnblock.language.tree.builtins import FUNCTIONS
from learnblock.language.tree.markers import raw_names
from learnblock.language.tree.nodes import (
    Activate,
    AnyPython,
    Assign,
    Call,
    Comment,
    Deactivate,
    Def,
    Expression,
    Item,
    Name,
    Program,
    RawExpression,
    SkillCall,
    Span,
)
from learnblock.language.tree.traversal import all_expressions, set_by, statements, within


def with_needed(program: Program, names: Iterable[str]) -> tuple[str, ...]:
    """The names of functions and of the functions they call, in program order.

    Raises:
        UnknownNameError: the program has no such function.
    """
    functions = program.functions
    ahead, needed = list(names), set[str]()
    while ahead:
        name = ahead.pop()
        if name not in functions:
            raise UnknownNameError("function", name, functions)
        if name not in needed:
            needed.add(name)
            ahead += [call for call in _called_by(functions[name]) if call in functions]
    return tuple(name for name in functions if name in needed)


def extracted(program: Program, names: Iterable[str], filename: str) -> str:
    """Extract functions as Block-Text, with the functions they call and the variables they share.

    Args:
        program: the program that defines them.
        names: the names of the functions.
        filename: the name of the program, for errors.

    Raises:
        UnknownNameError: the program has no such function.
        LibraryError: they do not work without the rest of the program.
    """
    return format_program(
        Program(_Extraction(program, with_needed(program, names)).items(filename))
    )


@dataclass(frozen=True)
class _Extraction:
    """The part of a program to extract.

    Args:
        program: the whole program.
        names: the names of all functions to extract.
    """

    program: Program
    names: tuple[str, ...]

    def items(self, filename: str) -> tuple[Item, ...]:
        problems = list(self.problems())
        if problems:
            raise LibraryError(filename, problems)
        return tuple(self.kept())

    @cached_property
    def functions(self) -> tuple[Def, ...]:
        return tuple(self.symbols.functions[name] for name in self.names)

    @cached_property
    def symbols(self) -> Symbols:
        return Symbols(self.program)

    @cached_property
    def beginnings(self) -> dict[str, Assign]:
        """The first assignment of each variable at the top level."""
        beginnings: dict[str, Assign] = {}
        for item in self.program.items:
            if isinstance(item, Assign) and isinstance(item.target, Name) and item.operator == "=":
                beginnings.setdefault(item.target.name, item)
        return beginnings

    @cached_property
    def shared(self) -> dict[str, Span]:
        """The variables that the functions share with the program, and each one's first use."""
        spans: dict[str, Span] = {}
        ahead = [(name, span) for function in self.functions for name, span in self.used(function)]
        for name, span in ahead:
            if name not in spans:
                spans[name] = span
                if name in self.beginnings:
                    ahead += self.used(self.beginnings[name])
        return spans

    def used(self, item: Item) -> Iterator[tuple[str, Span]]:
        """The variables of the whole program that an item uses."""
        own = self.symbols.own(item)
        for statement in statements((item,)):
            for node, used in _names_in(statement):
                if used not in own and used in self.symbols.variables:
                    yield used, node.span

    def kept(self) -> Iterator[Item]:
        """The functions, the assignments of the variables, and the comments directly above them."""
        chosen = {id(function) for function in self.functions}
        chosen |= {id(self.beginnings[name]) for name in self.shared if name in self.beginnings}
        comments: list[Comment] = []
        for item in self.program.items:
            if isinstance(item, Comment):
                comments.append(item)
                continue
            if id(item) in chosen:
                yield from comments
                yield item
            comments.clear()

    # Reasons why functions may not work without the rest.

    def problems(self) -> Iterator[Diagnostic]:
        for function in self.functions:
            yield from self.events(function)
            yield from self.calls(function)
            yield from self.python(function)
        for name, span in self.shared.items():
            yield from self.variable(name, span)

    def events(self, function: Def) -> Iterator[Diagnostic]:
        for statement in statements((function,)):
            used = [(name, node.span) for node, name in _names_in(statement) if self.is_state(name)]
            if isinstance(statement, Activate | Deactivate):
                used.append((statement.name, statement.span))
            for name, span in used:
                message = Phrase("edit-event-in-library", function=function.name, name=name)
                yield _problem("event-in-library", message, span)

    def is_state(self, name: str) -> bool:
        return state_of(name, self.symbols.whens.keys()) is not None

    def calls(self, function: Def) -> Iterator[Diagnostic]:
        for statement in statements((function,)):
            for node in all_expressions(statement):
                if isinstance(node, Call) and not self.is_known(node.name):
                    message = Phrase("edit-call-in-library", function=function.name, name=node.name)
                    yield _problem("unknown-function", message, node.span)

    def is_known(self, function: str) -> bool:
        return function in self.symbols.functions or function in FUNCTIONS

    def python(self, function: Def) -> Iterator[Diagnostic]:
        """Report raw Python that would have to pass the robot on, or needs other raw Python."""
        own = self.symbols.own(function)
        for statement in statements((function,)):
            for node, name in _names_in(statement):
                if name in own:
                    continue
                if name in self.symbols.functions:
                    message = Phrase(
                        "edit-function-without-call", function=function.name, name=name
                    )
                    yield _problem("python-in-library", message, node.span)
                elif name in self.set_in_python and not isinstance(node, Name):
                    message = Phrase("edit-set-in-python", function=function.name, name=name)
                    yield _problem("python-in-library", message, node.span)

    @cached_property
    def set_in_python(self) -> set[str]:
        """The names that raw Python outside of functions sets, defines and imports."""
        outside = (item for item in self.symbols.items if not isinstance(item, Def))
        texts = (
            statement.text
            for statement in statements(tuple(outside))
            if isinstance(statement, AnyPython)
        )
        return {name for text in texts for name in _set_by_python(text)}

    def variable(self, name: str, span: Span) -> Iterator[Diagnostic]:
        elsewhere = self.set_elsewhere.get(name)
        if elsewhere is not None:
            message = Phrase("edit-shared-variable", name=name, line=str(elsewhere.line))
            yield _problem("shared-variable", message, span)
        beginning = self.beginnings.get(name)
        if beginning is not None and any(map(self.asks, within(beginning.value))):
            message = Phrase("edit-variable-from-robot", name=name)
            yield _problem("shared-variable", message, beginning.span)

    def asks(self, node: Expression) -> bool:
        """Whether a value needs the robot or another function."""
        return isinstance(node, SkillCall) or (
            isinstance(node, Call)
            and (node.name in {"elapsedTime", "input"} or node.name not in FUNCTIONS)
        )

    @cached_property
    def set_elsewhere(self) -> dict[str, Span]:
        """Where the rest of the program first sets each variable, which a library would not do."""
        taken = {id(body) for body in (*self.functions, *self.beginnings.values())}
        spans: dict[str, Span] = {}
        for item in self.symbols.items:
            if id(item) in taken:
                continue
            own = self.symbols.own(item)
            for statement in statements((item,)):
                for name in _set_in(statement):
                    if name not in own:
                        spans.setdefault(name, statement.span)
        return spans


def _set_in(statement: Item) -> Iterator[str]:
    if isinstance(statement, AnyPython):
        yield from raw_names(statement.text)
    else:
        yield from set_by(statement)


def _problem(code: str, message: Phrase, span: Span) -> Diagnostic:
    return Diagnostic(code, message, span.line, span.column)


def _called_by(function: Def) -> Iterator[str]:
    """The names of the functions that a function calls."""
    for statement in statements((function,)):
        for node in all_expressions(statement):
            if isinstance(node, Call):
                yield node.name


def _names_in(statement: Item) -> Iterator[tuple[Name | AnyPython | RawExpression, str]]:
    """The names in a statement without its bodies, including those in its raw Python."""
    if isinstance(statement, AnyPython):
        for name in sorted(raw_names(statement.text)):
            yield statement, name
    for node in all_expressions(statement):
        if isinstance(node, Name):
            yield node, node.name
        elif isinstance(node, RawExpression):
            for name in sorted(raw_names(node.text.strip())):
                yield node, name


def _set_by_python(text: str) -> set[str]:
    """The names that raw Python sets, defines and imports."""
    if python_error(text, "exec"):
        return set()
    return markers.defined_names(text) | stored_names(ast.parse(text))
