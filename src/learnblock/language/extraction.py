"""Functions taken out of a program, to live in a library: with all that they need and no more."""

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from functools import cached_property

from learnblock.errors import Diagnostic, LibraryError, UnknownNameError
from learnblock.language.format import format as format_program
from learnblock.language.library import FUNCTIONS
from learnblock.language.markers import raw_names
from learnblock.language.names import state_of
from learnblock.language.nodes import (
    Activate,
    Assign,
    Call,
    Comment,
    Deactivate,
    Def,
    Expression,
    Item,
    Name,
    Program,
    Raw,
    SkillCall,
    Span,
    set_by,
    statements,
    within,
)
from learnblock.language.symbols import Symbols
from learnblock.language.uses import called_by, expressions_in, names_in, set_by_python


def with_needed(program: Program, names: Iterable[str]) -> tuple[str, ...]:
    """Functions by name, and those that they call, in the order of the program.

    Raises:
        UnknownNameError: the program has no such function.
    """
    functions = program.functions
    ahead, found = list(names), set[str]()
    while ahead:
        name = ahead.pop()
        if name not in functions:
            raise UnknownNameError("function", name, functions)
        if name not in found:
            found.add(name)
            ahead += [call for call in called_by(functions[name]) if call in functions]
    return tuple(name for name in functions if name in found)


def extracted(program: Program, names: Iterable[str], filename: str) -> str:
    """Block-Text of functions, with those that they call and the variables that they share.

    Args:
        program: what they stand in.
        names: of the functions.
        filename: the program's, for errors.

    Raises:
        UnknownNameError: the program has no such function.
        LibraryError: they cannot be without the rest of the program.
    """
    return format_program(
        Program(_Extraction(program, with_needed(program, names)).items(filename))
    )


@dataclass(frozen=True)
class _Extraction:
    """What is taken out of a program.

    Args:
        program: which.
        names: of all functions that are taken.
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
        """Where the program first sets each variable above everything else."""
        found: dict[str, Assign] = {}
        for item in self.program.items:
            if isinstance(item, Assign) and isinstance(item.target, Name) and item.operator == "=":
                found.setdefault(item.target.name, item)
        return found

    @cached_property
    def shared(self) -> dict[str, Span]:
        """The program's variables that the functions need, and where each is needed first."""
        found: dict[str, Span] = {}
        ahead = [(name, span) for one in self.functions for name, span in self.used(one)]
        for name, span in ahead:
            if name not in found:
                found[name] = span
                if name in self.beginnings:
                    ahead += self.used(self.beginnings[name])
        return found

    def used(self, item: Item) -> Iterator[tuple[str, Span]]:
        """The variables of the whole program in an item."""
        own = self.symbols.own(item)
        for statement in statements((item,)):
            for node, used in names_in(statement):
                if used not in own and used in self.symbols.variables:
                    yield used, node.span

    def kept(self) -> Iterator[Item]:
        """The functions, what sets the variables, and the comments right above these."""
        chosen = {id(one) for one in self.functions}
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

    # What keeps them from being without the rest.

    def problems(self) -> Iterator[Diagnostic]:
        for function in self.functions:
            yield from self.events(function)
            yield from self.calls(function)
            yield from self.python(function)
        for name, span in self.shared.items():
            yield from self.variable(name, span)

    def events(self, function: Def) -> Iterator[Diagnostic]:
        for statement in statements((function,)):
            used = [(name, one.span) for one, name in names_in(statement) if self.is_state(name)]
            if isinstance(statement, Activate | Deactivate):
                used.append((statement.name, statement.span))
            for name, span in used:
                message = (
                    f"`{function.name}` uses the event `{name}`; a library has no `when`: give what"
                    " it must know as an argument"
                )
                yield _problem("event-in-library", message, span)

    def is_state(self, name: str) -> bool:
        return state_of(name, self.symbols.whens.keys()) is not None

    def calls(self, function: Def) -> Iterator[Diagnostic]:
        for statement in statements((function,)):
            for node in expressions_in(statement):
                if isinstance(node, Call) and not self.is_known(node.name):
                    message = (
                        f"`{function.name}` calls `{node.name}`, which is no function of this"
                        " program: a library holds all that it calls"
                    )
                    yield _problem("unknown-function", message, node.span)

    def is_known(self, function: str) -> bool:
        return function in self.symbols.functions or function in FUNCTIONS

    def python(self, function: Def) -> Iterator[Diagnostic]:
        """Raw Python that would have to hand the robot on, or that needs other raw Python."""
        own = self.symbols.own(function)
        for statement in statements((function,)):
            for node, name in names_in(statement):
                if name in own:
                    continue
                if name in self.symbols.functions:
                    message = (
                        f"`{function.name}` names the function `{name}` without calling it in"
                        " Block-Text: a library could not hand the robot on"
                    )
                    yield _problem("python-in-library", message, node.span)
                elif name in self.set_in_python and not isinstance(node, Name):
                    message = (
                        f"the Python in `{function.name}` uses `{name}`, which other Python of the"
                        " program sets: set or import it inside the function"
                    )
                    yield _problem("python-in-library", message, node.span)

    @cached_property
    def set_in_python(self) -> set[str]:
        """What raw Python outside of all functions sets, defines and imports."""
        outside = (one for one in self.symbols.items if not isinstance(one, Def))
        found = (one.text for one in statements(tuple(outside)) if isinstance(one, Raw))
        return {name for text in found for name in set_by_python(text)}

    def variable(self, name: str, span: Span) -> Iterator[Diagnostic]:
        elsewhere = self.set_elsewhere.get(name)
        if elsewhere is not None:
            message = (
                f"the functions use `{name}`, which line {elsewhere.line} sets as well: give it"
                " as an argument, since a library's variables are its own"
            )
            yield _problem("shared-variable", message, span)
        beginning = self.beginnings.get(name)
        if beginning is not None and any(map(self.asks, within(beginning.value))):
            message = (
                f"`{name}` begins with what the robot or a function answers, and a library has no"
                " robot before it is called: give it as an argument"
            )
            yield _problem("shared-variable", message, beginning.span)

    def asks(self, node: Expression) -> bool:
        """Whether a value is not there before the robot is, or needs another function."""
        return isinstance(node, SkillCall) or (
            isinstance(node, Call)
            and (node.name in {"elapsedTime", "input"} or node.name not in FUNCTIONS)
        )

    @cached_property
    def set_elsewhere(self) -> dict[str, Span]:
        """Where what is not taken sets each variable first, which a library would not notice."""
        taken = {id(one) for one in (*self.functions, *self.beginnings.values())}
        found: dict[str, Span] = {}
        for item in self.symbols.items:
            if id(item) in taken:
                continue
            own = self.symbols.own(item)
            for statement in statements((item,)):
                for name in _set_in(statement):
                    if name not in own:
                        found.setdefault(name, statement.span)
        return found


def _set_in(statement: Item) -> Iterator[str]:
    if isinstance(statement, Raw):
        yield from raw_names(statement.text)
    elif name := set_by(statement):
        yield name


def _problem(code: str, message: str, span: Span) -> Diagnostic:
    return Diagnostic(code, message, span.line, span.column)
