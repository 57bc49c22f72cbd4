"""Read Python as a tree: generated Python and ordinary variants of it; the rest becomes raw Python.

This module reads the file as a whole; definitions, statements and expressions have their own
modules.
"""

import ast
import bisect
import re
from collections import Counter
from dataclasses import replace
from typing import NamedTuple

from learnblock.language.blocktext import names
from learnblock.language.blocktext.order import definitions_first
from learnblock.language.python.definition_reader import DefinitionReader
from learnblock.language.python.expression_reader import (
    Unlike,
    end_of,
    span_of,
    start_of,
)
from learnblock.language.python.generation import DEFAULT_ROBOT, canonical
from learnblock.language.python.parsing import parsed
from learnblock.language.python.robot_import import robot_import
from learnblock.language.python.skeleton import (
    Skeleton,
    is_when,
    skeleton_of,
)
from learnblock.language.python.statement_reader import acts, stripped
from learnblock.language.tree import markers
from learnblock.language.tree.builtins import MODULES
from learnblock.language.tree.layout import normalized, prologue_length
from learnblock.language.tree.nodes import (
    Blank,
    Branch,
    Comment,
    Compare,
    Def,
    If,
    Import,
    Item,
    Main,
    Name,
    Pass,
    Program,
    PythonLine,
    Raw,
    Setup,
    Span,
    String,
    When,
    WithoutRobot,
    is_only_raw,
)

_NOT_IN_MAIN = Def | When | Import | Setup | WithoutRobot


def from_python(text: str, filename: str = "program.py") -> Program:
    """Read a program in Python.

    If a file does not create its robot as generated programs do, all of it becomes one block of raw
    Python.
    `to_python` returns every such file byte for byte.

    Raises:
        ProgramError: the file is not valid Python.
    """
    tree = parsed(text, filename)
    try:
        program = _read(text, tree)
    except (Unlike, RecursionError):
        program = None
    if program is None:
        return Program((Raw(text, Span(1, 1, text.count("\n") + 1, 0)),))
    written = canonical(program, DEFAULT_ROBOT).text
    return program if written == text else replace(program, python=text)


def _read(text: str, tree: ast.Module) -> Program | None:
    skeleton = skeleton_of(tree)
    if skeleton is None or "\r" in text.replace("\r\n", ""):
        return None
    has_robot = skeleton.importing is not None
    if has_robot and any(
        isinstance(node, ast.ImportFrom) and node.module == "__future__" for node in tree.body
    ):
        return None
    plain = text.replace("\r\n", "\n") if text.count("\r\n") == text.count("\n") else text
    plain = plain.removeprefix("\ufeff")
    line = plain.count("\n", 0, match.start()) + 1 if (match := robot_import(plain)) else 0
    notes = markers.notes(plain)
    if line != (skeleton.importing.lineno if skeleton.importing else 0) or notes is None:
        return None
    defined = _Defined.by(skeleton)
    while True:
        reader = _Reader(plain, tree, skeleton, notes, defined)
        program = reader.program()
        kept = defined.kept_in(program, reader.whens)
        if kept == defined:
            return program
        # If a `when` stays raw Python, the rest of the program must not use it as a `when`; and if
        # a function does, a call of it must not become one of a library's function of that name.
        defined = kept


class _Defined(NamedTuple):
    """The definitions of a file that are definitions in Block-Text, too.

    Args:
        whens: the names of the ``when``s in Python.
        functions: the names of the other functions in Block-Text.
    """

    whens: frozenset[str]
    functions: frozenset[str]

    @classmethod
    def by(cls, skeleton: Skeleton) -> "_Defined":
        """All definitions; in Block-Text, two ``when``s of one name are none."""
        nodes = [node for node in skeleton.rest if isinstance(node, ast.FunctionDef)]
        times = Counter(node.name for node in nodes)
        events = filter(is_when, nodes) if skeleton.robot else ()
        whens = (node.name for node in events if times[node.name] == 1)
        functions = (names.from_python(node.name) for node in nodes if not node.decorator_list)
        return cls(frozenset(whens), frozenset(filter(None, functions)))

    def kept_in(self, program: Program, whens: dict[str, str]) -> "_Defined":
        """Those that a program has, with the ``when``s' names in Block-Text by those in Python."""
        kept = frozenset(name for name, plain in whens.items() if plain in program.whens)
        return _Defined(kept, self.functions & program.functions.keys())


class _Reader(DefinitionReader):
    """Reads a whole file; of its functions, those that are `defined` are definitions."""

    def __init__(
        self,
        text: str,
        tree: ast.Module,
        skeleton: Skeleton,
        notes: markers.Notes,
        defined: _Defined,
    ) -> None:
        clashes = names.clashes(_variables(tree, defined.whens))
        super().__init__(
            text.removesuffix("\n").split("\n"),
            notes,
            _declared_whens(defined.whens, clashes),
            defined.functions,
        )
        self.skeleton = skeleton
        self.robot = skeleton.robot
        self.is_own_style = skeleton.importing is None
        if self.raw_ends:
            begins = _begins(tree, sorted(self.raw_ends.values()))
            # A marker that was moved into a statement by hand has no meaning.
            self.raw_ends = {
                line: end for line, end in self.raw_ends.items() if begins.get(end, 0) < line
            }
        self.raw_lines = self.lines_of_raw()
        self.modules: set[str] = set()

    def program(self) -> Program:
        head = self.head()
        rest = list(self.skeleton.rest)
        while rest and not self.is_own_style and self.is_own_import(rest[0]):
            del rest[0]
        self.remove_run(rest)
        main_line = self.main_marker()
        end_line = self.end_marker(rest) if main_line else 0
        top = [node for node in rest if not main_line or node.lineno < main_line]
        items = self.block(top, 0, main_line or len(self.lines) + 1, top_level=True)
        main, late = self.main(rest, main_line, end_line)
        if not main_line and self.is_own_style:
            items, main = _with_main(items)
        whole = self.with_imports((*head, *items, *late), main)
        arranged = normalized(definitions_first([*whole, *([main] if main else [])]))
        kept = tuple(item for item in arranged if not isinstance(item, Main))
        if main is None and is_only_raw(kept):
            # Without its setup the block would be a whole file, and the robot would be lost.
            kept = (Setup(), *kept)
        return Program(kept, main, self.ending(end_line), span=self.span())

    def span(self) -> Span:
        return Span(1, 1, len(self.lines), len(self.lines[-1]) + 1 if self.lines else 1)

    def main(
        self, rest: list[ast.stmt], main_line: int, end_line: int
    ) -> tuple[Main | None, list[Item]]:
        """`main`, and the items below its marker that belong to the top level."""
        if not main_line:
            return None, []
        self.line = main_line + 1
        nodes = [node for node in rest if node.lineno > main_line]
        read = self.block(nodes, 0, end_line or len(self.lines) + 1, top_level=True)
        late: list[Item] = [item for item in read if isinstance(item, Def | When | Import)]
        body = tuple(item for item in read if not isinstance(item, _NOT_IN_MAIN))
        body = stripped(body)
        span = Span(main_line, 1, self.line - 1, 1)
        return Main(body if any(map(acts, body)) else (*body, Pass()), span), late

    def ending(self, end_line: int) -> tuple[Comment | Blank, ...]:
        if not end_line:
            return ()
        self.line = end_line + 1
        self.raw_ends = {}  # below `main` are only comments, so that a marker is one, too
        read = normalized(self.block([], 0, len(self.lines) + 1))
        return tuple(item for item in read if isinstance(item, Comment | Blank))

    def remove_run(self, rest: list[ast.stmt]) -> None:
        """Remove ``robot.run()`` at the end of a program with ``when``s: Block-Text implies it."""
        if self.whens and rest:
            match rest[-1]:
                case (
                    ast.Expr(
                        value=ast.Call(
                            func=ast.Attribute(value=ast.Name(id="robot"), attr="run"),
                            args=[],
                            keywords=[],
                        )
                    ) as run
                ):
                    self.erase(run)
                    rest.pop()

    def main_marker(self) -> int:
        """The line of the comment that marks `main`, or 0."""
        rest = self.skeleton.rest
        starts = [start_of(node) for node in rest]
        for line, comment in sorted(self.comments.items()):
            if comment[:3] != (0, markers.MAIN, True) or line in self.raw_lines:
                continue
            before = bisect.bisect(starts, line) - 1
            inside = before >= 0 and line <= end_of(rest[before])
            if line > self.skeleton.robot_line and not inside:
                return line
        return 0

    def end_marker(self, rest: list[ast.stmt]) -> int:
        """The line of the comment that marks the end of `main`, or 0."""
        last = max([end_of(node) for node in rest], default=self.skeleton.robot_line)
        after = [
            line
            for line, comment in self.comments.items()
            if line > last and comment[:3] == (0, markers.END, True) and line not in self.raw_lines
        ]
        return min(after, default=0)

    def lines_of_raw(self) -> set[int]:
        """The lines of the unindented blocks of raw Python, without the first of each."""
        lines: set[int] = set()
        last = 0
        for line, end in sorted(self.raw_ends.items()):
            if line > last and self.comments[line].column == 0:
                lines.update(range(line + 1, end + 1))
                last = end
        return lines

    def head(self) -> list[Item]:
        """The items above the line that creates the robot, and a `Setup` if that needs one."""
        skeleton = self.skeleton
        if skeleton.importing is None or skeleton.creating is None:
            return [WithoutRobot()]
        self.check_lines()
        others = [node for node in skeleton.head if not self.is_own_import(node)]
        line = skeleton.importing.lineno
        above = self.head_part([node for node in others if node.lineno < line], line)
        if above and not isinstance(above[-1], Import):
            above.append(Blank())
        self.erase(skeleton.importing)
        self.line = line
        below = [node for node in others if node.lineno > line]
        below_items = self.head_part(below, skeleton.creating.lineno)
        self.line = end_of(skeleton.creating) + 1
        return self.with_setup([*above, *below_items, *self.inner_comments(skeleton.creating)])

    def check_lines(self) -> None:
        """Leave a file as it is whose other statements share a line with the robot's."""
        skeleton = self.skeleton
        own = (skeleton.importing and skeleton.importing.lineno, skeleton.robot_line)
        if any(node.lineno in own or end_of(node) in own for node in skeleton.head):
            raise Unlike

    def is_own_import(self, node: ast.stmt) -> bool:
        """Whether a statement is an import that generated Python adds; if so, record it."""
        if node.lineno in self.raw_lines:
            return False
        match node:
            case ast.Import(names=[ast.alias(name=module, asname=None)]) if (
                module in MODULES and module not in self.modules
            ):
                if self.lines[node.lineno - 1].strip() == f"import {module}":
                    self.modules.add(module)
                    self.lines[node.lineno - 1] = ""
                    return True
        return False

    def head_part(self, nodes: list[ast.stmt], limit: int) -> list[Item]:
        return self.block(nodes, 0, limit, top_level=True)

    def with_setup(self, items: list[Item]) -> list[Item]:
        """Insert the robot's setup above everything except comments and imports."""
        plain = [item for item in items if isinstance(item, Comment | Blank | Import)]
        others = [item for item in items if not isinstance(item, Comment | Blank | Import)]
        setup = self.setup()
        described = bool(plain) and isinstance(plain[-1], Comment)
        if setup.arguments or setup.keywords or setup.comment is not None or described:
            return [*plain, setup, *others]
        return [*plain, *others]

    def setup(self) -> Setup:
        node, creating = self.skeleton.creation, self.skeleton.creating
        if node is None or creating is None:
            raise Unlike
        arguments, keywords = self.arguments(node, names.attribute_from_python)
        return Setup(arguments, keywords, self.comment_after(creating), span_of(creating))

    def with_imports(self, items: tuple[Item, ...], main: Main | None) -> tuple[Item, ...]:
        """The items, with imports that only Python between backticks can need."""
        text = canonical(Program(items, main), DEFAULT_ROBOT).text if self.modules else ""
        unused = [
            module
            for module in MODULES
            if module in self.modules and not re.search(rf"^import {module}$", text, re.MULTILINE)
        ]
        if not unused:
            return items
        lines = tuple(PythonLine(f"import {module}") for module in unused)
        setup = next((i + 1 for i, item in enumerate(items) if isinstance(item, Setup)), 0)
        place = setup or prologue_length(items)
        return (*items[:place], *lines, *items[place:])


def _declared_whens(whens: frozenset[str], clashes: dict[str, int]) -> dict[str, str]:
    """The names in Block-Text of the ``when``s, by their names in Python."""
    plain_names = {name: names.when_from_python(name, clashes) for name in sorted(whens)}
    return {name: plain for name, plain in plain_names.items() if plain is not None}


def _with_main(items: list[Item]) -> tuple[list[Item], Main | None]:
    """The items, and the main program that the last ``if __name__ == "__main__":`` is."""
    last = max((i for i, item in enumerate(items) if not isinstance(item, Blank)), default=0)
    match items[last : last + 1]:
        case [
            If(
                branches=(
                    Branch(Compare(("==",), (Name("__name__"), String("__main__"))), body, None),
                ),
                otherwise=None,
            ) as test
        ]:
            return items[:last], Main(body, test.span)
    return items, None


def _begins(tree: ast.Module, lines: list[int]) -> dict[int, int]:
    """For each of the sorted `lines` inside a statement, the start of the innermost statement."""
    begins: dict[int, int] = {}
    for node in ast.walk(tree):
        if isinstance(node, ast.stmt):
            first, end = bisect.bisect(lines, start_of(node)), bisect.bisect(lines, end_of(node))
            for line in lines[first:end]:
                begins[line] = max(begins.get(line, 0), start_of(node))
    return begins


def _variables(tree: ast.Module, whens: frozenset[str]) -> set[str]:
    """The names in Block-Text of everything except ``when``s."""
    functions = [node for node in tree.body if isinstance(node, ast.FunctionDef)]
    variables = markers.variable_names(tree, whens)
    variables |= {node.name for node in functions if not node.decorator_list}
    return {plain for name in variables if (plain := names.from_python(name)) is not None}
