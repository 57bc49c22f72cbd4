"""How much of Python as people write it is blocks: scores of files, and what is left grey."""

import ast
import turtledemo
from collections import Counter
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field
from pathlib import Path

from learnblock.language import format as format_program
from learnblock.language import from_python, parse, to_python
from learnblock.language.tree.nodes import Program, Raw, RawExpression
from learnblock.language.tree.traversal import all_expressions, statements

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
    found = Scores()
    for path in paths:
        try:
            text = path.read_bytes().decode()
            tree = ast.parse(text)
        except (SyntaxError, ValueError, RecursionError):
            continue
        _add(found, text, tree)
    return found


def _add(scores: Scores, text: str, tree: ast.Module) -> None:
    program = from_python(text)
    body = program.items + (program.main.body if program.main else ())
    raw = [item for item in statements(body) if isinstance(item, Raw)]
    values = [value for item in statements(body) for value in all_expressions(item)]
    grey_values = [value for value in values if isinstance(value, RawExpression)]
    every = [node for node in ast.walk(tree) if isinstance(node, ast.stmt)]
    spans = [(item.span.line, item.span.end_line) for item in raw]
    grey = [node for node in every if any(a <= node.lineno <= b for a, b in spans)]
    scores.files += 1
    scores.ungrey += not grey and not grey_values
    scores.kept += to_python(program, None).text == text
    scores.same += _comes_back(program, tree)
    scores.statements += len(every)
    scores.grey += len(grey)
    scores.sockets += len(values)
    scores.grey_sockets += len(grey_values)
    scores.left.update(_names(raw, grey_values))


def _comes_back(program: Program, tree: ast.Module) -> bool:
    again = to_python(parse(format_program(program)), None).text
    return ast.dump(ast.parse(again)) == ast.dump(tree)


def _names(raw: list[Raw], values: list[RawExpression]) -> Iterator[str]:
    for item in raw:
        try:
            yield from (type(node).__name__ for node in ast.parse(item.text).body)
        except SyntaxError:
            yield "part of a statement"
    for value in values:
        yield type(ast.parse(value.text.strip(), mode="eval").body).__name__ + " as a value"
