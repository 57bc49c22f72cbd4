"""How much of Python as people write it is blocks: scores of files, and what is left grey."""

import ast
import turtledemo
from collections import Counter
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field, fields
from pathlib import Path

from learnblock.language import format as format_program
from learnblock.language import from_python, parse, to_python
from learnblock.language.python.forms import Split, header_form, line_form, value_form
from learnblock.language.tree.markers import is_long_text
from learnblock.language.tree.nodes import (
    Expression,
    Item,
    Program,
    PythonBlock,
    PythonLine,
    Raw,
    RawExpression,
)
from learnblock.language.tree.traversal import all_expressions, statements, within
from learnblock.language.workspace.python_shapes import Sockets

TURTLEDEMO = Path(turtledemo.__file__).parent


@dataclass
class Scores:
    """The counts of some files.

    Args:
        files: the files that are valid Python.
        ungrey: those without a grey block or socket.
        kept: those that come back byte for byte.
        same: those whose statements mean the same when they come back by way of Block-Text.
        statements: their statements.
        grey: the statements in grey blocks.
        sockets: the values of the other statements.
        grey_sockets: the grey ones of them.
        left: what is grey, by its name in Python's syntax tree.
    """

    files: int = 0
    ungrey: int = 0
    kept: int = 0
    same: int = 0
    statements: int = 0
    grey: int = 0
    sockets: int = 0
    grey_sockets: int = 0
    left: Counter[str] = field(default_factory=Counter)

    def __add__(self, other: "Scores") -> "Scores":
        """The counts of the files of both."""
        counts = {each.name: getattr(self, each.name) for each in fields(self)}
        return Scores(**{name: count + getattr(other, name) for name, count in counts.items()})

    @property
    def in_blocks(self) -> float:
        """The share of statements in blocks, in percent."""
        return 100 * (1 - self.grey / self.statements) if self.statements else 100.0

    @property
    def sockets_in_blocks(self) -> float:
        """The share of values in blocks among those of statements in blocks, in percent."""
        return 100 * (1 - self.grey_sockets / self.sockets) if self.sockets else 100.0


def scores_of(paths: Iterable[Path]) -> Scores:
    """The scores of all files that are valid Python in UTF-8."""
    scores = Scores()
    for path in paths:
        try:
            text = path.read_bytes().decode()
            tree = ast.parse(text)
        except (SyntaxError, ValueError, RecursionError):
            continue
        _add(scores, text, tree)
    return scores


def _add(scores: Scores, text: str, tree: ast.Module) -> None:
    program = from_python(text)
    body = program.items + (program.main.body if program.main else ())
    items = list(statements(body))
    # A text on several lines, such as a docstring, is a note; a line without a form is grey.
    raw = [item for item in items if isinstance(item, Raw) and not is_long_text(item.text)]
    lines = [item for item in items if isinstance(item, PythonLine) and not line_form(item.text)]
    values = [value for item in items for value in all_expressions(item)]
    values += [value for item in items for value in _values_of(item)]
    values = [part for value in values for part in (value, *_values_in(value))]
    grey_values = [
        value for value in values if isinstance(value, RawExpression) and not value_form(value.text)
    ]
    every = [node for node in ast.walk(tree) if isinstance(node, ast.stmt)]
    spans = [(item.span.line, item.span.end_line) for item in [*raw, *lines]]
    grey = [node for node in every if any(a <= node.lineno <= b for a, b in spans)]
    scores.files += 1
    scores.ungrey += not grey and not grey_values
    scores.kept += to_python(program, None).text == text
    scores.same += _comes_back(program, tree)
    scores.statements += len(every)
    scores.grey += len(grey)
    scores.sockets += len(values)
    scores.grey_sockets += len(grey_values)
    scores.left.update(_names([*raw, *lines], grey_values))


def _values_of(item: Item) -> Iterator[Expression]:
    """The values in the sockets of a line of Python, and of the first lines of a block of it."""
    if isinstance(item, PythonLine):
        yield from _split(item.text, line_form)
    elif isinstance(item, PythonBlock):
        for part in item.parts:
            yield from _split(part.header, header_form)


def _values_in(value: Expression) -> Iterator[Expression]:
    """The values in the sockets of an expression that stays Python, at any depth."""
    if isinstance(value, RawExpression):
        for part in _split(value.text, value_form):
            yield part
            yield from _values_in(part)


def _split(text: str, split: Split) -> list[Expression]:
    form = split(text)
    if form is None:
        return []
    expressions = Sockets(Program()).values(text, form)
    return [part for value in expressions for part in within(value)]


def _comes_back(program: Program, tree: ast.Module) -> bool:
    again = to_python(parse(format_program(program)), None).text
    return meaning(ast.parse(again)) == meaning(tree)


def meaning(tree: ast.Module) -> str:
    """What is left of a file that is read and written again by way of Block-Text."""
    return ast.dump(_Plain().visit(tree))


class _Plain(ast.NodeTransformer):
    """Leaves out what means nothing, and what Block-Text leaves out.

    It is the ``u`` of a text, the 0 of ``range(0, n)``, and the brackets of ``(a and b) and c``.
    """

    def visit_Constant(self, node: ast.Constant) -> ast.Constant:
        node.kind = None
        return node

    def visit_BoolOp(self, node: ast.BoolOp) -> ast.BoolOp:
        self.generic_visit(node)
        match node.values[0]:
            case ast.BoolOp(op=op, values=values) if type(op) is type(node.op):
                node.values[:1] = values
        return node

    def visit_Call(self, node: ast.Call) -> ast.Call:
        self.generic_visit(node)
        match node:
            case ast.Call(func=ast.Name(id="range"), args=[ast.Constant(value=0), _]):
                del node.args[0]
        return node


def _names(raw: list[Raw | PythonLine], values: list[RawExpression]) -> Iterator[str]:
    for item in raw:
        try:
            yield from (type(node).__name__ for node in ast.parse(item.text).body)
        except SyntaxError:
            yield "part of a statement"
    for value in values:
        node = ast.parse(f"({value.text.strip()})", mode="eval").body
        yield type(node).__name__ + " as a value"
