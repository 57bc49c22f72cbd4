"""Read statements of Python that Block-Text has no words of its own for, each for itself."""

import ast
import bisect
import re
from copy import copy
from dataclasses import replace

from learnblock.language.python.expression_reader import Unlike, span_of, start_of
from learnblock.language.python.scopes import SCOPES
from learnblock.language.python.skeleton import is_text
from learnblock.language.python.statement_reader import StatementReader, as_statement, stripped
from learnblock.language.tree.nodes import (
    Body,
    Item,
    Pass,
    PythonBlock,
    PythonLine,
    PythonPart,
    Span,
)

_BLOCKS = (
    *SCOPES,
    ast.For,
    ast.AsyncFor,
    ast.While,
    ast.With,
    ast.AsyncWith,
    ast.Try,
    ast.TryStar,
    ast.Match,
)
_COMPOUND = (*_BLOCKS, ast.If)
_Owner = ast.stmt | ast.ExceptHandler | ast.match_case
#: A part of a block: where it begins, its header if that is known, and its statements.
_Part = tuple[int, str, list[ast.stmt]]
#: A comment there is no marker, wherever it is.
_NO_COLUMN = -1


class PythonReader(StatementReader):
    """Reads what other readers find `Unlike` Block-Text."""

    def python_items(self, node: ast.stmt) -> list[Item]:
        if isinstance(node, _BLOCKS):
            return [*self.decorated(node), self.python_block(node)]
        if isinstance(node, _COMPOUND):
            raise Unlike
        if is_text(node) and node.end_lineno != node.lineno:
            # Its lines are the author's.
            raise Unlike
        line = PythonLine(self.one_line(node), self.comment_after(node), span_of(node))
        return [*self.inner_comments(node), line]

    def decorated(self, node: ast.stmt) -> list[Item]:
        """The decorators of a function or a class, a line for each, with the comments there."""
        items: list[Item] = []
        line = start_of(node)
        for decorator in getattr(node, "decorator_list", []):
            last = decorator.end_lineno or decorator.lineno
            items += self.comments_in(line, last)
            comment = self.comments.get(last)
            text = self.one_line(decorator)
            if isinstance(decorator, ast.Yield | ast.YieldFrom):
                text = f"({text})"  # its brackets are no part of it
            items.append(PythonLine("@" + text, comment and comment.text, span_of(decorator)))
            line = last + 1
        return [*items, *self.comments_in(line, self.header_end(node.lineno, _body(node)))]

    def python_block(self, node: ast.stmt) -> PythonBlock:
        outer = self.keeps_globals
        self.keeps_globals = outer or isinstance(node, SCOPES)
        try:
            read = self.python_parts(node)
        finally:
            self.keeps_globals = outer
        first = read[0]
        span = first.span._replace(end_line=first.span.line)
        read[0] = replace(first, span=span)
        return PythonBlock(tuple(read), span_of(node)._replace(line=node.lineno))

    def python_parts(self, node: ast.stmt) -> list[PythonPart]:
        parts = self.parts(node)
        read: list[PythonPart] = []
        above: Body = ()
        if isinstance(node, ast.Match):
            line, header, body = parts.pop(0)
            comment = self.header_comment(line, body)
            read.append(PythonPart(header, (), comment, self.place(line)))
            above = self.above_first_case(line, parts[0])
        for part, following in zip(parts, [*parts[1:], None], strict=True):
            reading = self.python_part(part, following)
            read.append(
                replace(reading, body=stripped((*above, *reading.body))) if above else reading
            )
            above = ()
        return read

    def above_first_case(self, line: int, case: _Part) -> Body:
        """The comments between the ``match`` on a line and the statements of its first case."""
        first, _, body = case
        self.line = self.header_end(line, body) + 1
        above: list[Item] = []
        self.notes(above, first, _NO_COLUMN)
        above += self.comments_in(first, self.header_end(first, body))
        return tuple(map(as_statement, above))

    def parts(self, node: ast.stmt) -> list[_Part]:
        """The parts of a block, each from its header on."""
        parts: list[_Part] = [(node.lineno, self.header(node, node.lineno), _body(node))]
        handlers: list[ast.ExceptHandler] = getattr(node, "handlers", [])
        parts += [
            (handler.lineno, self.header(handler, handler.lineno), handler.body)
            for handler in handlers
        ]
        for case in node.cases if isinstance(node, ast.Match) else ():
            line = self.first_line(case.pattern.lineno)
            parts.append((line, self.header(case, line), case.body))
        for field, word in (("orelse", "else"), ("finalbody", "finally")):
            body = getattr(node, field, [])
            if body:
                parts.append((self.word_line(word, start_of(body[0])), word, body))
        return parts

    def header(self, node: _Owner, first: int) -> str:
        """The first line of a part, without its colon."""
        body = _body(node)
        if self.header_end(first, body) == first:
            line = self.lines[first - 1]
            end = len(line)
            if first == body[0].lineno:
                end = self.character(first, body[0].col_offset)
            elif (comment := self.comments.get(first)) is not None:
                end = comment.column
            text = line[:end].strip()
            if text.endswith(":"):
                return text[:-1].rstrip()
        if isinstance(node, ast.Try | ast.TryStar):
            return "try"
        bare = copy(node)
        for field in ("body", "orelse", "decorator_list", "cases"):
            if hasattr(bare, field):
                setattr(bare, field, [ast.Pass()] if field == "body" else [])
        header, *rest = ast.unparse(bare).split("\n")
        if rest and rest != ["    pass"]:
            raise Unlike
        return header.removesuffix(":")

    def first_line(self, line: int) -> int:
        """The line on which the statement begins that goes on in a line."""
        place = bisect.bisect_left(self.line_ends, line)
        first = self.line_ends[place - 1] + 1 if place else 1
        while self.is_blank(first) or (first in self.comments and self.comments[first].own_line):
            first += 1
        return first

    def word_line(self, word: str, first: int) -> int:
        """The line of the word above the statements that begin on a line."""
        pattern = re.compile(rf"\s*{word}\s*[:\\]")
        line = first
        while line > 1 and not pattern.match(self.lines[line - 1]):
            line -= 1
        return line

    def python_part(self, part: _Part, following: _Part | None) -> PythonPart:
        line, header, nodes = part
        comment = self.header_comment(line, nodes)
        below = None
        if following is not None:
            below = following[0], self.header_end(following[0], following[2])
        body = self.part_body(line, nodes, below)
        return PythonPart(header, body or (Pass(),), comment, self.place(line))

    def place(self, line: int) -> Span:
        """The span of the header that begins on a line."""
        text = self.lines[line - 1]
        return Span(line, len(text) - len(text.lstrip()) + 1, line)


def _body(node: _Owner) -> list[ast.stmt]:
    """The statements of a part; of a ``match``, which has none, those of its first case."""
    if isinstance(node, ast.Match):
        return node.cases[0].body
    body: list[ast.stmt] = getattr(node, "body", [])
    return body
