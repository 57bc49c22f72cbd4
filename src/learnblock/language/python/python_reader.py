"""Read statements of Python that Block-Text has no words of its own for, each for itself."""

import ast
import re
from copy import copy

from learnblock.language.python.expression_reader import Unlike, span_of, start_of
from learnblock.language.python.scopes import SCOPES
from learnblock.language.python.skeleton import is_text
from learnblock.language.python.statement_reader import StatementReader
from learnblock.language.tree.nodes import (
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
)
_COMPOUND = (*_BLOCKS, ast.If, ast.Match)
#: A part of a block: where it begins, its header if that is known, and its statements.
_Part = tuple[int, str, list[ast.stmt]]


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
        found: list[Item] = []
        line = start_of(node)
        for decorator in getattr(node, "decorator_list", []):
            last = decorator.end_lineno or decorator.lineno
            found += self.comments_in(line, last)
            comment = self.comments.get(last)
            text = self.one_line(decorator)
            if isinstance(decorator, ast.Yield | ast.YieldFrom):
                text = f"({text})"  # its brackets are no part of it
            found.append(PythonLine("@" + text, comment and comment.text, span_of(decorator)))
            line = last + 1
        return [*found, *self.comments_in(line, self.header_end(node.lineno, _body(node)))]

    def python_block(self, node: ast.stmt) -> PythonBlock:
        outer = self.keeps_globals
        self.keeps_globals = outer or isinstance(node, SCOPES)
        try:
            parts = self.parts(node)
            read = [
                self.python_part(part, following)
                for part, following in zip(parts, [*parts[1:], None], strict=True)
            ]
        finally:
            self.keeps_globals = outer
        first = read[0]
        span = first.span._replace(end_line=first.span.line)
        read[0] = PythonPart(first.header, first.body, first.comment, span)
        return PythonBlock(tuple(read), span_of(node)._replace(line=node.lineno))

    def parts(self, node: ast.stmt) -> list[_Part]:
        """The parts of a block, each from its header on."""
        body = _body(node)
        found: list[_Part] = [(node.lineno, self.header(node), body)]
        handlers: list[ast.ExceptHandler] = getattr(node, "handlers", [])
        found += [(handler.lineno, self.header(handler), handler.body) for handler in handlers]
        for field, word in (("orelse", "else"), ("finalbody", "finally")):
            body = getattr(node, field, [])
            if body:
                found.append((self.word_line(word, start_of(body[0])), word, body))
        return found

    def header(self, node: ast.stmt | ast.ExceptHandler) -> str:
        """The first line of a part, without its colon."""
        body = _body(node)
        first = node.lineno
        if self.header_end(first, body) == first:
            line = self.lines[first - 1]
            end = len(line)
            if first == body[0].lineno:
                end = self.character(first, body[0].col_offset)
            elif (comment := self.comments.get(first)) is not None:
                end = comment.column
            text = line[self.character(first, node.col_offset) : end].rstrip()
            if text.endswith(":"):
                return text[:-1].rstrip()
        if isinstance(node, ast.Try | ast.TryStar):
            return "try"
        bare = copy(node)
        for field in ("body", "orelse", "decorator_list"):
            if hasattr(bare, field):
                setattr(bare, field, [ast.Pass()] if field == "body" else [])
        lines = ast.unparse(bare).split("\n")
        if len(lines) != 2:
            raise Unlike
        return lines[0].removesuffix(":")

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
        column = len(self.lines[line - 1]) - len(self.lines[line - 1].lstrip())
        return PythonPart(header, body or (Pass(),), comment, Span(line, column + 1, line))


def _body(node: ast.stmt | ast.ExceptHandler) -> list[ast.stmt]:
    body: list[ast.stmt] = getattr(node, "body", [])
    return body
