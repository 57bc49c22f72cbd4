"""Read the comments, blank lines and marked raw Python between the statements of a Python file.

Python's syntax tree contains none of them, so they are read line by line, up to each statement.
"""

import ast

from learnblock.language.python.expression_reader import ExpressionReader, end_of, start_of
from learnblock.language.tree import markers
from learnblock.language.tree.nodes import Blank, Comment, Item, Raw, Span


class CommentReader(ExpressionReader):
    """Reads comments and blank lines; `line` is the next line to read."""

    def __init__(
        self,
        lines: list[str],
        notes: markers.Notes,
        whens: dict[str, str],
        functions: set[str],
    ) -> None:
        super().__init__(lines, whens, functions)
        self.comments, self.in_string = notes
        self.raw_ends = self.found_raw_ends()
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

    def found_raw_ends(self) -> dict[int, int]:
        """The line of the ``# end`` for the line of each ``# python`` of the same indentation."""
        found: dict[int, int] = {}
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
                found[number] = ends[comment.column]
        return found

    def inner_comments(self, node: ast.stmt) -> list[Item]:
        """The comments inside the brackets of a statement, which move above it in Block-Text."""
        found: list[Item] = []
        body = getattr(node, "body", None)
        end = start_of(body[0]) - 1 if isinstance(body, list) and body else end_of(node) - 1
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
        """The comment after the colon of a block that begins on line `start`."""
        for line in range(start, max(start_of(body[0]), start + 1)):
            comment = self.comment_of(line)
            if comment is not None and start_of(body[0]) > line:
                return comment
        return None

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

    def after_header(self, owner: int, first: int) -> int:
        """The line below the header of a block, which may span several lines."""
        line = first
        while line - 1 > owner and not self.lines[line - 2].strip():
            line -= 1
        while line - 1 > owner and (
            not self.lines[line - 2].strip()
            or ((c := self.comments.get(line - 1)) is not None and c.own_line and not c.inside)
        ):
            line -= 1
        return line
