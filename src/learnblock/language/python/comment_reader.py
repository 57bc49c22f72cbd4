"""Read the comments, blank lines and marked raw Python between the statements of a Python file.

Python's syntax tree contains none of them, so they are read line by line, up to each statement.
"""

import ast
import bisect

from learnblock.language.python.expression_reader import ExpressionReader, end_of, start_of
from learnblock.language.tree import markers
from learnblock.language.tree.nodes import Blank, Comment, Item, Raw, Span

#: What may be between a statement and the comment at the end of its line.
_SEPARATORS = " \t\f;"


class CommentReader(ExpressionReader):
    """Reads comments and blank lines; `line` is the next line to read."""

    def __init__(
        self,
        lines: list[str],
        notes: markers.Notes,
        whens: dict[str, str],
        functions: frozenset[str],
    ) -> None:
        super().__init__(lines, whens, functions)
        self.comments = dict(notes.comments)
        self.in_string, self.line_ends = notes.in_string, notes.ends
        self.raw_ends = self.ends_of_raw()
        self.line = 1

    def notes(self, items: list[Item], limit: int, column: int, *, leave: bool = False) -> int:
        """Read the comments and blank lines of a body up to the line `limit`.

        Args:
            items: the list to add them to.
            limit: the line to stop at.
            column: the indentation of the body's statements.
            leave: stop also at a comment that is indented less.

        Returns:
            the line after a block of raw Python, if one was read; else 0.
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

    def ends_of_raw(self) -> dict[int, int]:
        """The line of the ``# end`` for the line of each ``# python`` of the same indentation."""
        raw_ends: dict[int, int] = {}
        ends: dict[int, int] = {}  # the next ``# end`` below, by column
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
                raw_ends[number] = ends[comment.column]
        return raw_ends

    def inner_comments(self, node: ast.stmt) -> list[Item]:
        """The comments in a statement that has no place for them, which move above it.

        They are inside its brackets, or at its decorators.
        """
        body = getattr(node, "body", None)
        last = self.header_end(node.lineno, body) if isinstance(body, list) else end_of(node)
        return self.comments_in(start_of(node), last)

    def comments_in(self, first: int, end: int) -> list[Item]:
        """Every comment on the lines from `first` up to, but not including, `end`."""
        return [self.own_comment(line) for line in range(first, end) if line in self.comments]

    def own_comment(self, line: int) -> Comment:
        """The comment of a line, moved to a line of its own."""
        comment = self.comments[line]
        return Comment(comment.text, Span(line, comment.column + 1))

    def comment_after(self, node: ast.stmt) -> str | None:
        """The comment at the end of a statement, if no other statement is between them."""
        line = end_of(node)
        comment = self.comments.get(line)
        if comment is None or comment.own_line or comment.inside:
            return None
        between = self.lines[line - 1][self.character(line, node.end_col_offset) : comment.column]
        return None if between.strip(_SEPARATORS) else comment.text

    def header_comment(self, start: int, body: list[ast.stmt]) -> str | None:
        """The comment after the colon of a block that begins on line `start`."""
        line = self.header_end(start, body)
        comment = self.comments.get(line)
        return None if comment is None or line == start_of(body[0]) else comment.text

    def header_end(self, start: int, body: list[ast.stmt]) -> int:
        """The line of the colon of a block that begins on line `start`, or of its body above it."""
        colon = self.line_ends[bisect.bisect_left(self.line_ends, start)]
        return min(colon, start_of(body[0]))

    def character(self, line: int, column: int | None) -> int:
        """The position in a line for a column of Python's tree, which counts bytes."""
        text = self.lines[line - 1]
        return (column or 0) if text.isascii() else len(text.encode()[:column].decode())

    def erase(self, node: ast.stmt) -> None:
        """Remove a statement that Block-Text implies; its comments get lines of their own."""
        for line in range(node.lineno, end_of(node) + 1):
            comment = self.comments.get(line)
            text = self.lines[line - 1]
            start = self.character(line, node.col_offset) if line == node.lineno else 0
            end = len(text) if comment is None else comment.column
            if line == end_of(node):
                end = self.character(line, node.end_col_offset)
            text = text[:start] + " " * (end - start) + text[end:]
            self.lines[line - 1] = text if text.strip(_SEPARATORS) else ""
            if comment is not None:
                self.comments[line] = comment._replace(inside=False)
                if not text[: comment.column].strip(_SEPARATORS):
                    self.comments[line] = _own_line(comment, node.col_offset)

    def notes_of_body(self, items: list[Item], column: int) -> None:
        """Read the comments below a body that are indented like the body."""
        while True:
            ahead = self.line
            while ahead <= len(self.lines) and not self.lines[ahead - 1].strip():
                ahead += 1
            comment = self.comments.get(ahead)
            if comment is None or not comment.own_line or comment.column < column:
                return
            self.notes(items, ahead + 1, column, leave=True)


def _own_line(comment: markers.NotedComment, column: int) -> markers.NotedComment:
    """A comment on a line of its own that isn't a marker."""
    return markers.NotedComment(column, markers.escaped(comment.text), own_line=True, inside=False)
