"""Python as a tree: what `python` writes and ordinary variants of it; all else as raw Python."""

import ast
import bisect
import re
import warnings
from dataclasses import dataclass, field, replace
from typing import NoReturn

from learnblock.errors import Diagnostic, ProgramError
from learnblock.language import markers, names, ranges, raw
from learnblock.language.expression_parser import MAX_HEIGHT
from learnblock.language.layout import normalized, prologue_length
from learnblock.language.lexer import MAX_CHARACTERS
from learnblock.language.library import MODULES, TEMPLATES, is_builtin, recognized
from learnblock.language.nodes import (
    Activate,
    Assign,
    Binary,
    Blank,
    Body,
    Branch,
    Break,
    Call,
    Comment,
    Compare,
    Constant,
    Continue,
    Deactivate,
    Def,
    Else,
    Expression,
    ForEach,
    ForRange,
    If,
    Import,
    Index,
    Item,
    Keyword,
    List,
    Main,
    Name,
    Number,
    Pass,
    Perform,
    Program,
    Raw,
    RawExpression,
    Repeat,
    Return,
    Setup,
    SkillCall,
    Span,
    Statement,
    String,
    Unary,
    When,
    While,
)
from learnblock.language.python import (
    DEFAULT_ROBOT,
    ROBOT_IMPORT,
    canonical,
    global_names,
    state_of,
)

_BINARY: dict[type[ast.operator], str] = {
    ast.Add: "+",
    ast.Sub: "-",
    ast.Mult: "*",
    ast.Div: "/",
    ast.FloorDiv: "//",
    ast.Mod: "%",
    ast.Pow: "**",
}
_UNARY: dict[type[ast.unaryop], str] = {ast.Not: "not", ast.USub: "-", ast.UAdd: "+"}
_COMPARE: dict[type[ast.cmpop], str] = {
    ast.Eq: "==",
    ast.NotEq: "!=",
    ast.Lt: "<",
    ast.Gt: ">",
    ast.LtE: "<=",
    ast.GtE: ">=",
    ast.In: "in",
    ast.NotIn: "not in",
}
# Trees of this height still fit the parser's limit when they are written as Block-Text.
_MAX_HEIGHT = MAX_HEIGHT - 20


def from_python(text: str, filename: str = "program.py") -> Program:
    """The tree of a program in Python.

    A file that does not create a robot as ours do is one block of raw Python. `to_python` gives
    back every file byte for byte.

    Raises:
        ProgramError: it is not valid Python.
    """
    tree = _parsed(text, filename)
    try:
        program = _read(text, tree)
    except (_Unlike, RecursionError):
        program = None
    if program is None:
        return Program((Raw(text, Span(1, 1, text.count("\n") + 1, 0)),))
    written = canonical(program, DEFAULT_ROBOT).text
    return program if written == text else replace(program, python=text)


def _parsed(text: str, filename: str) -> ast.Module:
    if len(text) > MAX_CHARACTERS:
        message = f"a program of {len(text):,} characters is too long: at most {MAX_CHARACTERS:,}"
        raise ProgramError(filename, [Diagnostic("too-long", message)])
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            return ast.parse(text.removeprefix("\ufeff"))
    except SyntaxError as error:
        raise ProgramError(filename, [_syntax_error(error)], text) from None
    except (RecursionError, MemoryError):
        message = "this Python is nested too deeply: give a part of it a name of its own"
        raise ProgramError(filename, [Diagnostic("too-deep", message)], text) from None
    except (ValueError, OverflowError) as error:
        message = f"this is not Python: {error}"
        raise ProgramError(filename, [Diagnostic("python-syntax", message)]) from None


def _syntax_error(error: SyntaxError) -> Diagnostic:
    message = f"this is not Python: {error.msg}"
    end = (error.end_offset or 0) if error.end_lineno == error.lineno else 0
    return Diagnostic("python-syntax", message, error.lineno or 0, error.offset or 0, max(end, 0))


class _Unlike(Exception):  # noqa: N818 - no error: what is unlike ours is kept as raw Python
    """This Python has no form of its own in Block-Text."""


def _unlike() -> NoReturn:
    raise _Unlike


@dataclass(slots=True)
class _Skeleton:
    """Where a file imports and creates its robot.

    Args:
        importing: the statement that imports ``Robot``.
        creating: the statement ``robot = Robot(...)``.
        head: the other statements up to there.
        rest: those after it.
    """

    importing: ast.ImportFrom
    creating: ast.Assign
    creation: ast.Call
    head: list[ast.stmt] = field(default_factory=list)
    rest: list[ast.stmt] = field(default_factory=list)


def _skeleton(tree: ast.Module) -> _Skeleton | None:
    importing: ast.ImportFrom | None = None
    head: list[ast.stmt] = []
    for index, statement in enumerate(tree.body):
        match statement:
            case ast.ImportFrom(names=[ast.alias(name="Robot", asname=None)], level=0):
                if importing is not None:
                    return None
                importing = statement
            case ast.Assign(
                targets=[ast.Name(id="robot")],
                value=ast.Call(func=ast.Name(id="Robot")) as creation,
            ):
                if importing is None:
                    return None
                rest = tree.body[index + 1 :]
                return _Skeleton(importing, statement, creation, head, rest)
            case ast.Import() | ast.ImportFrom() | ast.Expr(value=ast.Constant()):
                head.append(statement)
            case _:
                return None
    return None


def _read(text: str, tree: ast.Module) -> Program | None:
    skeleton = _skeleton(tree)
    if skeleton is None or "\r" in text.replace("\r\n", ""):
        return None
    if any(isinstance(node, ast.ImportFrom) and node.module == "__future__" for node in tree.body):
        return None
    plain = text.replace("\r\n", "\n") if text.count("\r\n") == text.count("\n") else text
    plain = plain.removeprefix("\ufeff")
    line = plain.count("\n", 0, match.start()) + 1 if (match := ROBOT_IMPORT.search(plain)) else 0
    notes = markers.notes(plain)
    if line != skeleton.importing.lineno or notes is None:
        return None
    return _Reader(plain, tree, skeleton, notes).program()


class _Reader:
    def __init__(
        self, text: str, tree: ast.Module, skeleton: _Skeleton, notes: markers.Notes
    ) -> None:
        self.lines = text.split("\n")
        if not self.lines[-1]:
            self.lines.pop()
        self.comments, self.in_string = notes
        self.skeleton = skeleton
        self.raw_ends = self.found_raw_ends()
        self.raw_lines = self.found_raw_lines()
        self.line = 1  # the next one whose comments are still to be read
        self.modules: set[str] = set()
        self.height = 0  # of the expression that is being read, so far
        self.clashes = names.clashes(_variables(tree))
        self.whens = self.declared_whens()
        self.when_names = {plain: name for name, plain in self.whens.items()}
        self.functions = {
            names.from_python(item.name)
            for item in skeleton.rest
            if isinstance(item, ast.FunctionDef) and not item.decorator_list
        }

    def declared_whens(self) -> dict[str, str]:
        """The ``when``s by their names in Python."""
        found: dict[str, str] = {}
        for item in self.skeleton.rest:
            if isinstance(item, ast.FunctionDef) and _is_when(item):
                plain = names.when_from_python(item.name, self.clashes)
                if plain is not None:
                    found[item.name] = plain
        return found

    # The top level.

    def program(self) -> Program:
        head = self.head()
        rest = list(self.skeleton.rest)
        self.remove_run(rest)
        main_line, end_line = self.main_marker(), self.end_marker(rest)
        items: list[Item | Main] = [*head]
        top = [node for node in rest if not main_line or node.lineno < main_line]
        items += self.block(top, 0, main_line or end_line or len(self.lines) + 1, top_level=True)
        main, late = self.main(rest, main_line, end_line)
        arranged = normalized([*items, *late, *([main] if main else [])])
        kept = tuple(item for item in arranged if not isinstance(item, Main))
        return Program(self.with_imports(kept, main), main, self.ending(end_line), span=self.span())

    def span(self) -> Span:
        return Span(1, 1, len(self.lines), len(self.lines[-1]) + 1 if self.lines else 1)

    def main(
        self, rest: list[ast.stmt], main_line: int, end_line: int
    ) -> tuple[Main | None, list[Item]]:
        """`main`, and what of it belongs to the top level after all."""
        if not main_line:
            return None, []
        self.line = main_line + 1
        nodes = [node for node in rest if node.lineno > main_line]
        read = self.block(nodes, 0, end_line or len(self.lines) + 1, top_level=True)
        late: list[Item] = [item for item in read if isinstance(item, Def | When | Import)]
        body = tuple(item for item in read if not isinstance(item, Def | When | Import | Setup))
        body = _stripped(body)
        span = Span(main_line, 1, self.line - 1, 1)
        return Main(body if any(map(_acts, body)) else (*body, Pass()), span), late

    def ending(self, end_line: int) -> tuple[Comment | Blank, ...]:
        if not end_line:
            return ()
        self.line = end_line + 1
        read = normalized(self.block([], 0, len(self.lines) + 1))
        return tuple(item for item in read if isinstance(item, Comment | Blank))

    def remove_run(self, rest: list[ast.stmt]) -> None:
        """The last line of a program with ``when``s says what Block-Text leaves unsaid."""
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
                    self.blank_lines(run)
                    rest.pop()

    def blank_lines(self, node: ast.stmt) -> None:
        for number in range(node.lineno, _end(node) + 1):
            self.lines[number - 1] = ""

    def main_marker(self) -> int:
        """The line of the comment below which stands `main`, or 0."""
        rest = self.skeleton.rest
        starts = [_start(node) for node in rest]
        for line, comment in sorted(self.comments.items()):
            if comment[:3] != (0, markers.MAIN, True) or line in self.raw_lines:
                continue
            before = bisect.bisect(starts, line) - 1
            inside = before >= 0 and line <= _end(rest[before])
            if line > self.skeleton.creating.lineno and not inside:
                return line
        return 0

    def end_marker(self, rest: list[ast.stmt]) -> int:
        """The line of the comment below which stands what comes after `main`, or 0."""
        last = max([_end(node) for node in rest], default=self.skeleton.creating.lineno)
        after = [
            line
            for line, comment in self.comments.items()
            if line > last and comment[:3] == (0, markers.END, True) and line not in self.raw_lines
        ]
        return min(after, default=0)

    def found_raw_ends(self) -> dict[int, int]:
        """For each ``# python`` with an ``# end`` at the same indentation, the lines of the two."""
        found: dict[int, int] = {}
        ends: dict[int, int] = {}  # the next ``# end`` below, by its column
        for number in range(len(self.lines), 0, -1):
            text = self.lines[number - 1]
            indent = len(text) - len(text.lstrip())
            if not text.strip() or number in self.in_string:
                continue
            if any(column > indent for column in ends):
                ends = {column: line for column, line in ends.items() if column <= indent}
            comment = self.comments.get(number)
            if comment is None or not comment.own_line:
                continue
            if comment.text == markers.END:
                ends[comment.column] = number
            elif comment.text == markers.PYTHON and comment.column in ends:
                found[number] = ends[comment.column]
        return found

    def found_raw_lines(self) -> set[int]:
        """The lines of the blocks of raw Python at the margin, without their first."""
        found: set[int] = set()
        last = 0
        for line, end in sorted(self.raw_ends.items()):
            if line > last and self.comments[line].column == 0:
                found.update(range(line + 1, end + 1))
                last = end
        return found

    def head(self) -> list[Item]:
        """What stands above the line that creates the robot, and that line if it says something."""
        skeleton = self.skeleton
        others: list[ast.stmt] = []
        for node in skeleton.head:
            module = _own_import(node)
            if module is None:
                others.append(node)
            else:
                self.modules.add(module)
                self.blank_lines(node)
        line = skeleton.importing.lineno
        above = self.head_part([node for node in others if node.lineno < line], line)
        if above and not isinstance(above[-1], Import):
            above.append(Blank())
        self.line = _end(skeleton.importing) + 1
        below = [node for node in others if node.lineno > line]
        below_items = self.head_part(below, skeleton.creating.lineno)
        self.line = _end(skeleton.creating) + 1
        return self.with_setup([*above, *below_items])

    def head_part(self, nodes: list[ast.stmt], limit: int) -> list[Item]:
        return self.block(nodes, 0, limit, top_level=True)

    def with_setup(self, items: list[Item]) -> list[Item]:
        """The robot's setup stands above all that is more than a comment or an import."""
        plain = [item for item in items if isinstance(item, Comment | Blank | Import)]
        others = [item for item in items if not isinstance(item, Comment | Blank | Import)]
        setup = self.setup()
        described = bool(plain) and isinstance(plain[-1], Comment)
        if setup.arguments or setup.keywords or setup.comment is not None or described:
            return [*plain, setup, *others]
        return [*plain, *others]

    def setup(self) -> Setup:
        node = self.skeleton.creation
        arguments, keywords = self.arguments(node, names.attribute_from_python)
        creating = self.skeleton.creating
        return Setup(arguments, keywords, self.comment_of(_end(creating)), _span(creating))

    def with_imports(self, items: tuple[Item, ...], main: Main | None) -> tuple[Item, ...]:
        """The items, and as raw Python those imports that only raw Python can need."""
        text = canonical(Program(items, main), DEFAULT_ROBOT).text if self.modules else ""
        unused = [
            module
            for module in MODULES
            if module in self.modules and not re.search(rf"^import {module}$", text, re.MULTILINE)
        ]
        if not unused:
            return items
        raw = Raw("".join(f"import {module}\n" for module in unused))
        setup = next((i + 1 for i, item in enumerate(items) if isinstance(item, Setup)), 0)
        place = setup or prologue_length(items)
        return (*items[:place], raw, *items[place:])

    # Bodies.

    def block(
        self, nodes: list[ast.stmt], column: int, limit: int, *, top_level: bool = False
    ) -> list[Item]:
        """The statements `nodes`, which begin at `column`, and the comments up to line `limit`."""
        items: list[Item] = []
        index = 0
        while index < len(nodes):
            node = nodes[index]
            raw = self.notes(items, _start(node), column)
            if raw:
                while index < len(nodes) and nodes[index].lineno < raw:
                    index += 1
                continue
            index = self.add(items, nodes, index, top_level=top_level)
        while self.notes(items, limit, column, leave=True):
            pass
        return items

    def notes(self, items: list[Item], limit: int, column: int, *, leave: bool = False) -> int:
        """Read the comments and blank lines of a body up to the line `limit`.

        Args:
            items: what is read is added to it.
            limit: the line to stop at.
            column: where the body's statements begin.
            leave: stop at a comment left of them too.

        Returns:
            the line after a block of raw Python that was met and read; else 0.
        """
        while self.line < limit:
            number = self.line
            comment = self.comments.get(number)
            if comment is not None and comment.own_line and not comment.inside:
                if leave and comment.column < column:
                    return 0
                end = self.raw_ends.get(number, 0)
                if end and comment.column == column:
                    items.append(self.marked(number, end))
                    self.line = end + 1
                    return end + 1
                span = Span(number, comment.column + 1, number, len(self.lines[number - 1]) + 1)
                items.append(Comment(markers.unescaped(comment.text), span))
            elif self.is_blank(number) and items and not isinstance(items[-1], Blank):
                items.append(Blank())
            self.line += 1
        return 0

    def is_blank(self, line: int) -> bool:
        return line <= len(self.lines) and not self.lines[line - 1].strip()

    def marked(self, start: int, end: int) -> Raw:
        indent = self.lines[start - 1][: self.comments[start].column]
        text = markers.raw_text(self.lines[start : end - 1], start + 1, indent, self.in_string)
        return Raw(text, Span(start, len(indent) + 1, end, 1))

    def add(self, items: list[Item], nodes: list[ast.stmt], index: int, *, top_level: bool) -> int:
        """Read one statement, or with those after it what is raw; return where to go on."""
        node = nodes[index]
        saved = self.line
        if isinstance(node, ast.Global) and index == 0 and not top_level:
            self.line = _end(node) + 1
            return index + 1
        try:
            inner = self.inner_comments(node)
            item = self.item(node) if top_level else self.statement(node)
        except _Unlike:
            self.line = saved
            return self.add_raw(items, nodes, index)
        items.extend(inner)
        items.append(item)
        self.line = max(self.line, _end(node) + 1)
        return index + 1

    def add_raw(self, items: list[Item], nodes: list[ast.stmt], index: int) -> int:
        first = nodes[index]
        last = index
        # Statements that share a line go together.
        while last + 1 < len(nodes) and _start(nodes[last + 1]) <= _end(nodes[last]):
            last += 1
        start, end = _start(first), _end(nodes[last])
        if self.line > start:
            raise _Unlike
        before = items[-1] if items else None
        joined = isinstance(before, Raw) and before.span.end_line == start - 1
        indent = self.lines[start - 1][: first.col_offset]
        text = markers.raw_text(self.lines[start - 1 : end], start, indent, self.in_string)
        span = Span(start, first.col_offset + 1, end, 1)
        if joined and isinstance(before, Raw):
            items.pop()
            text = before.text + text
            span = Span(before.span.line, before.span.column, end, 1)
        items.append(Raw(text, span))
        self.line = end + 1
        return last + 1

    def inner_comments(self, node: ast.stmt) -> list[Item]:
        """The comments inside the brackets of a statement, which stand above it in Block-Text."""
        found: list[Item] = []
        body = getattr(node, "body", None)
        end = _start(body[0]) - 1 if isinstance(body, list) and body else _end(node) - 1
        for number in range(node.lineno, end + 1):
            comment = self.comments.get(number)
            if comment is not None and (comment.inside or not isinstance(body, list)):
                found.append(Comment(comment.text, Span(number, comment.column + 1)))
        return found

    def comment_of(self, line: int) -> str | None:
        """The comment at the end of a line."""
        comment = self.comments.get(line)
        if comment is None or comment.own_line or comment.inside:
            return None
        return comment.text

    def header_comment(self, start: int, body: list[ast.stmt]) -> str | None:
        """The comment behind the colon of a block that begins in line `start`."""
        for line in range(start, max(_start(body[0]), start + 1)):
            comment = self.comment_of(line)
            if comment is not None and _start(body[0]) > line:
                return comment
        return None

    def body(self, owner: int, nodes: list[ast.stmt], limit: int) -> Body:
        first = _start(nodes[0])
        if first == owner:
            self.line = first
        else:
            self.line = self.after_header(owner, first)
        return _stripped(
            tuple(_statement(item) for item in self.block(nodes, nodes[0].col_offset, limit))
        )

    def after_header(self, owner: int, first: int) -> int:
        """The line below a block's header, which may run over several lines."""
        line = first
        while line - 1 > owner and not self.lines[line - 2].strip():
            line -= 1
        while line - 1 > owner and (
            not self.lines[line - 2].strip()
            or ((c := self.comments.get(line - 1)) is not None and c.own_line and not c.inside)
        ):
            line -= 1
        return line

    # Items and statements.

    def item(self, node: ast.stmt) -> Item:
        match node:
            case ast.ImportFrom(module=str(module), names=[ast.alias(name="*")], level=0):
                return Import(module, self.comment_of(_end(node)), _span(node))
            case ast.FunctionDef():
                return self.function(node)
            case _:
                return self.statement(node)

    def function(self, node: ast.FunctionDef) -> Def | When:
        arguments = node.args
        if node.returns or getattr(node, "type_params", None) or _unusual(arguments):
            _unlike()
        comment = self.header_comment(node.lineno, node.body)
        if node.decorator_list:
            return self.when(node, comment)
        name = names.from_python(node.name)
        parameters = tuple(self.called(argument.arg) for argument in arguments.args)
        if name is None:
            _unlike()
        body = self.function_body(node, parameters)
        return Def(name, parameters, body, comment, _span(node))

    def when(self, node: ast.FunctionDef, comment: str | None) -> When:
        name = self.whens.get(node.name)
        if name is None or node.args.args:
            _unlike()
        condition: Expression | None = None
        match node.decorator_list[0]:
            case ast.Call(args=[ast.Lambda(body=test)]):
                condition = self.expression(test)
            case ast.Attribute(attr="when_start") if name != "start":
                _unlike()
            case ast.Attribute(attr="when") if name == "start":
                _unlike()
        body = self.function_body(node, ())
        return When(name, condition, body, comment, _span(node))

    def function_body(self, node: ast.FunctionDef, parameters: tuple[str, ...]) -> Body:
        body = self.body(node.lineno, node.body, _end(node) + 1)
        body = self.trailing(body, node)
        first = node.body[0]
        declared = first.names if isinstance(first, ast.Global) else []
        if sorted(declared) != global_names(body, parameters, self.when_names.keys()):
            _unlike()
        return body if any(map(_acts, body)) else (*body, Pass())

    def trailing(self, body: Body, node: ast.stmt) -> Body:
        """A body with the comments below its last statement that are indented as it is."""
        items: list[Item] = list(body)
        column = node.body[0].col_offset  # type: ignore[attr-defined]
        if self.line <= len(self.lines):
            self.notes_of_body(items, column)
        return _stripped(tuple(_statement(item) for item in items))

    def notes_of_body(self, items: list[Item], column: int) -> None:
        """Comments below a body: they are its own as long as they are indented as it is."""
        while True:
            ahead = self.line
            while ahead <= len(self.lines) and not self.lines[ahead - 1].strip():
                ahead += 1
            comment = self.comments.get(ahead)
            if comment is None or not comment.own_line or comment.column < column:
                return
            self.notes(items, ahead + 1, column, leave=True)

    def statement(self, node: ast.stmt) -> Statement:  # noqa: PLR0911 - one a kind
        comment = self.comment_of(_end(node))
        span = _span(node)
        match node:
            case ast.Expr(value=value):
                return self.perform(value, comment, span)
            case ast.Assign(targets=[target], value=value):
                return Assign(self.target(target), "=", self.expression(value), comment, span)
            case ast.AugAssign(target=target, op=operator, value=value):
                return self.augmented(target, operator, value, comment, span)
            case ast.Return(value=value):
                result = None if value is None else self.expression(value)
                return Return(result, comment, span)
            case ast.Pass():
                return Pass(comment, span)
            case ast.Break():
                return Break(comment, span)
            case ast.Continue():
                return Continue(comment, span)
            case _:
                return self.compound(node)

    def compound(self, node: ast.stmt) -> Statement:
        span = _span(node)
        match node:
            case ast.If():
                return self.if_chain(node)
            case ast.While(test=test, body=body, orelse=[]):
                condition = self.expression(test)
                return While(condition, *self.own_body(node, body), span)
            case ast.For(
                target=ast.Name(id="_"),
                iter=ast.Call(func=ast.Name(id="range"), args=[count], keywords=[]),
                body=body,
                orelse=[],
            ):
                return Repeat(self.expression(count), *self.own_body(node, body), span)
            case ast.For(target=target, iter=values, body=body, orelse=[]):
                return self.for_loop(node, target, values, body)
            case _:
                _unlike()

    def own_body(self, node: ast.stmt, body: list[ast.stmt]) -> tuple[Body, str | None]:
        comment = self.header_comment(node.lineno, body)
        read = self.trailing(self.body(node.lineno, body, _end(node) + 1), node)
        return (read if any(map(_acts, read)) else (*read, Pass())), comment

    def for_loop(
        self, node: ast.For, target: ast.expr, values: ast.expr, body: list[ast.stmt]
    ) -> ForEach | ForRange:
        name = self.target(target)
        if not isinstance(name, Name):
            _unlike()
        span = _span(node)
        match values:
            case ast.Call(func=ast.Name(id="range"), args=bounds, keywords=[]):
                start, stop, step = self.bounds(bounds)
                return ForRange(name, start, stop, step, *self.own_body(node, body), span)
        return ForEach(name, self.expression(values), *self.own_body(node, body), span)

    def bounds(self, bounds: list[ast.expr]) -> tuple[Expression, Expression, Expression | None]:
        read = [self.expression(bound) for bound in bounds[:1]]
        if len(bounds) == 1:
            return Number("0"), _last(read[0], 1), None
        if len(bounds) == 2:
            return read[0], _last(self.expression(bounds[1]), 1), None
        if len(bounds) != 3:
            _unlike()
        step = self.expression(bounds[2])
        direction = ranges.direction(step)
        if direction:
            return read[0], _last(self.expression(bounds[1]), direction), step
        match bounds[1]:
            case ast.BinOp(
                left=stop,
                op=ast.Add(),
                right=ast.IfExp(
                    test=ast.Compare(
                        left=tested, ops=[ast.Gt()], comparators=[ast.Constant(value=0)]
                    ),
                    body=ast.Constant(value=1),
                    orelse=ast.UnaryOp(op=ast.USub(), operand=ast.Constant(value=1)),
                ),
            ) if self.expression(tested) == step:
                return read[0], self.expression(stop), step
        _unlike()

    def if_chain(self, node: ast.If) -> If:
        branches: list[Branch] = []
        part: ast.If = node
        while True:
            condition = self.expression(part.test)
            first = part is node
            comment = self.header_comment(part.lineno, part.body)
            body = self.part_body(part.lineno, part.body)
            span = _span(part) if first else Span(part.lineno, node.col_offset + 1)
            branches.append(Branch(condition, body, comment, span._replace(end_line=part.lineno)))
            if not part.orelse:
                return If(tuple(branches), None, _span(node))
            following = part.orelse[0]
            if len(part.orelse) == 1 and isinstance(following, ast.If) and self.is_elif(following):
                part = following
                continue
            return If(tuple(branches), self.otherwise(part, node), _span(node))

    def is_elif(self, node: ast.If) -> bool:
        return self.lines[node.lineno - 1][node.col_offset :].startswith("elif")

    def otherwise(self, part: ast.If, node: ast.If) -> Else:
        line = self.else_line(_start(part.orelse[0]))
        comment = self.header_comment(line, part.orelse)
        body = self.part_body(line, part.orelse)
        return Else(body, comment, Span(line, node.col_offset + 1, line, node.col_offset + 6))

    def else_line(self, first: int) -> int:
        line = first
        while line > 1 and not self.lines[line - 1].lstrip().startswith("else"):
            line -= 1
        return line

    def part_body(self, line: int, nodes: list[ast.stmt]) -> Body:
        read: list[Item] = list(self.body(line, nodes, _end(nodes[-1]) + 1))
        self.notes_of_body(read, nodes[0].col_offset)
        body = _stripped(tuple(_statement(item) for item in read))
        return body if any(map(_acts, body)) else (*body, Pass())

    def perform(self, call: ast.expr, comment: str | None, span: Span) -> Statement:
        match call:
            case ast.Call(
                func=ast.Attribute(
                    value=ast.Name(id=name), attr="activate" | "deactivate" as method
                ),
                args=[],
                keywords=[],
            ) if name != "robot":
                plain = self.whens.get(name) or self.called(name)
                node = Activate if method == "activate" else Deactivate
                return node(plain, comment, span)
        value = self.exact(call)
        if not isinstance(value, Call | SkillCall):
            _unlike()
        return Perform(value, comment, span)

    def augmented(
        self,
        target: ast.expr,
        operator: ast.operator,
        value: ast.expr,
        comment: str | None,
        span: Span,
    ) -> Assign:
        symbol = _BINARY.get(type(operator))
        if symbol is None:
            _unlike()
        return Assign(self.target(target), symbol + "=", self.expression(value), comment, span)

    def target(self, node: ast.expr) -> Name | Index:
        if isinstance(node, ast.Name | ast.Attribute | ast.Subscript):
            read = self.exact(node)
            root: Expression = read
            while isinstance(root, Index):
                root = root.value
            if isinstance(read, Name | Index) and isinstance(root, Name | Call | SkillCall):
                return read
        _unlike()

    def called(self, name: str) -> str:
        """The name in Block-Text of a function."""
        plain = names.from_python(name)
        if plain is None or name in self.whens:
            _unlike()
        return plain

    def identifier(self, name: str) -> str:
        plain = names.from_python(name)
        if plain is None or name in self.whens or state_of(plain, self.when_names.keys()):
            _unlike()
        return plain

    # Expressions.

    def expression(self, node: ast.expr) -> Expression:
        self.height += 1
        try:
            return self.exact(node) if self.height < _MAX_HEIGHT else self.raw(node)
        except _Unlike:
            return self.raw(node)
        finally:
            self.height -= 1

    def exact(self, node: ast.expr) -> Expression:  # noqa: PLR0911 - one a kind
        span = _span(node)
        match node:
            case ast.Constant():
                return self.constant(node, span)
            case ast.Name(id=name):
                return Name(self.identifier(name), span)
            case ast.BinOp(left=left, op=operator, right=right) if type(operator) in _BINARY:
                symbol = _BINARY[type(operator)]
                return Binary(symbol, self.expression(left), self.expression(right), span)
            case ast.BoolOp(op=operator, values=values):
                return self.logic("and" if isinstance(operator, ast.And) else "or", values)
            case ast.UnaryOp(op=operator, operand=operand) if type(operator) in _UNARY:
                return Unary(_UNARY[type(operator)], self.expression(operand), span)
            case ast.Compare():
                return self.comparison(node, span)
            case ast.List(elts=items):
                return List(tuple(self.argument(item) for item in items), span)
            case _:
                return self.access(node, span)

    def access(self, node: ast.expr, span: Span) -> Expression:
        match node:
            case ast.Attribute(value=ast.Name(id=name), attr="active" | "time" as attribute) if (
                name in self.whens
            ):
                prefix = "state_" if attribute == "active" else "time_"
                return Name(prefix + self.whens[name], span)
            case ast.Call(func=ast.Attribute(value=ast.Name(id="robot"), attr=name)):
                return self.skill_call(node, name, span)
            case ast.Subscript(value=value, slice=index) if not isinstance(
                index, ast.Slice | ast.Tuple
            ):
                return Index(self.expression(value), self.expression(index), span)
        return self.library_call(node, span) or self.call(node, span)

    def constant(self, node: ast.Constant, span: Span) -> Expression:
        value = node.value
        if value is None or isinstance(value, bool):
            return Constant(value, span)
        if isinstance(value, str):
            return String(value, span)
        if isinstance(value, int | float):
            return Number(self.segment(node), span)
        _unlike()

    def logic(self, operator: str, values: list[ast.expr]) -> Expression:
        if self.height + len(values) > _MAX_HEIGHT:
            _unlike()
        result = self.expression(values[0])
        for value in values[1:]:
            right = self.expression(value)
            first, last = result.span, right.span
            span = Span(first.line, first.column, last.end_line, last.end_column)
            result = Binary(operator, result, right, span)
        return result

    def comparison(self, node: ast.Compare, span: Span) -> Compare:
        operators = [_COMPARE.get(type(operator)) for operator in node.ops]
        known = tuple(operator for operator in operators if operator is not None)
        if len(known) < len(operators):
            _unlike()
        operands = (node.left, *node.comparators)
        return Compare(known, tuple(self.expression(operand) for operand in operands), span)

    def skill_call(self, node: ast.Call, name: str, span: Span) -> Call | SkillCall:
        arguments, keywords = self.arguments(node, names.attribute_from_python)
        if name == "elapsedTime":
            if name in self.functions:
                _unlike()
            return Call(name, arguments, keywords, span)
        return SkillCall(names.attribute_from_python(name), arguments, keywords, span)

    def library_call(self, node: ast.expr, span: Span) -> Expression | None:
        found = recognized(node)
        if found is None:
            return None
        template, parts = found
        if template.name in self.functions:
            _unlike()
        return Call(template.name, tuple(self.expression(part) for part in parts), (), span)

    def call(self, node: ast.expr, span: Span) -> Call:
        if not isinstance(node, ast.Call) or not isinstance(node.func, ast.Name):
            _unlike()
        python_name = node.func.id
        if is_builtin(python_name, len(node.args)):
            if python_name in self.functions:
                _unlike()
            arguments, keywords = self.arguments(node, names.attribute_from_python)
            return Call(python_name, arguments, keywords, span)
        name = self.called(python_name)
        arguments, keywords = self.arguments(node, names.keyword_from_python)
        if name not in self.functions and self.means_another(name, arguments, keywords):
            _unlike()
        return Call(name, arguments, keywords, span)

    @staticmethod
    def means_another(
        name: str, arguments: tuple[Expression, ...], keywords: tuple[Keyword, ...]
    ) -> bool:
        """Whether Block-Text would take a call of `name` for one of the library's functions."""
        if name == "elapsedTime" or is_builtin(name, len(arguments)):
            return True
        return not keywords and (name, len(arguments)) in TEMPLATES

    def arguments(self, node: ast.Call, rename):  # type: ignore[no-untyped-def]
        arguments = tuple(self.argument(argument) for argument in node.args)
        keywords = tuple(
            Keyword(rename(keyword.arg), self.expression(keyword.value), _span(keyword))
            if keyword.arg is not None
            else _unlike()
            for keyword in node.keywords
        )
        return arguments, keywords

    def argument(self, node: ast.expr) -> Expression:
        if isinstance(node, ast.Starred):
            _unlike()
        return self.expression(node)

    def raw(self, node: ast.expr) -> RawExpression:
        text = self.segment(node)
        if isinstance(node, ast.Yield | ast.YieldFrom | ast.NamedExpr):
            # Python's tree leaves out their brackets, which they must have in most places.
            text = f"({text})"
        return RawExpression(text, _span(node))

    def segment(self, node: ast.expr) -> str:
        """The text of an expression that stands on one line."""
        end = node.end_col_offset
        if node.end_lineno != node.lineno or end is None:
            _unlike()
        line = self.lines[node.lineno - 1]
        if line.isascii():
            return line[node.col_offset : end]
        return line.encode()[node.col_offset : end].decode()


def _own_import(node: ast.stmt) -> str | None:
    """The module of an import that generated Python writes where it is needed."""
    match node:
        case ast.Import(names=[ast.alias(name=name, asname=None)]) if name in MODULES:
            return name
    return None


def _unusual(arguments: ast.arguments) -> bool:
    return bool(
        arguments.posonlyargs
        or arguments.kwonlyargs
        or arguments.vararg
        or arguments.kwarg
        or arguments.defaults
        or any(argument.annotation for argument in arguments.args)
    )


def _is_when(node: ast.FunctionDef) -> bool:
    match node.decorator_list:
        case [ast.Attribute(value=ast.Name(id="robot"), attr="when" | "when_start")]:
            return True
        case [
            ast.Call(
                func=ast.Attribute(value=ast.Name(id="robot"), attr="when"),
                args=[ast.Lambda(args=arguments)],
                keywords=[],
            )
        ]:
            return not (arguments.args or _unusual(arguments))
    return False


def _variables(tree: ast.Module) -> set[str]:
    """The names in Block-Text of all that is no ``when``."""
    functions = [node for node in tree.body if isinstance(node, ast.FunctionDef)]
    whens = {node.name for node in functions if _is_when(node)}
    found = markers.variable_names(tree, whens)
    found |= {node.name for node in functions if not node.decorator_list}
    return {plain for name in found if (plain := names.from_python(name)) is not None}


def _start(node: ast.stmt) -> int:
    decorators = getattr(node, "decorator_list", None)
    return min([node.lineno, *(one.lineno for one in decorators)]) if decorators else node.lineno


def _end(node: ast.stmt) -> int:
    return node.end_lineno or node.lineno


def _span(node: ast.stmt | ast.expr | ast.keyword) -> Span:
    start = _start(node) if isinstance(node, ast.stmt) else node.lineno
    end, column = node.end_lineno or start, node.end_col_offset or 0
    return Span(start, node.col_offset + 1, end, column + 1)


def _last(end: Expression, direction: int) -> Expression:
    found = ranges.last(end, direction)
    return _unlike() if found is None else found


def _statement(item: Item) -> Statement:
    if isinstance(item, Def | When | Import | Setup):
        _unlike()
    return item


def _stripped(body: Body) -> Body:
    """A body without blank lines at its ends."""
    start, end = 0, len(body)
    while start < end and isinstance(body[start], Blank):
        start += 1
    while start < end and isinstance(body[end - 1], Blank):
        end -= 1
    return body[start:end]


def _acts(item: Statement) -> bool:
    """Whether a body that holds this statement is no empty one."""
    if isinstance(item, Raw):
        return raw.code_lines(item.text)
    return not isinstance(item, Comment | Blank)
