"""Parse the blocks of Block-Text, from a header to its ``end``.

A block whose first line has an error keeps its body and its ``end``.
"""

from collections.abc import Callable
from typing import Any, TypeVar

from learnblock.i18n import Phrase
from learnblock.language.blocktext.lexer import LINE_ENDS, Token, Tokens
from learnblock.language.blocktext.line_rewriter import LineRewriter
from learnblock.language.blocktext.slips import Rewritten, Slip
from learnblock.language.blocktext.token_reader import from_to
from learnblock.language.tree import raw
from learnblock.language.tree.characters import write_instead
from learnblock.language.tree.nodes import (
    Blank,
    Body,
    Comment,
    Raw,
    Span,
    Statement,
    is_further_part,
)

# Writing a deeper tree would overflow the stack of Python.
MAX_BLOCKS = 120

TOP_LEVEL = frozenset(("import", "def", "when", "main"))
STATEMENT_STARTS = frozenset(
    [
        "name",
        "function",
        "if",
        "while",
        "for",
        "activate",
        "deactivate",
        "break",
        "continue",
        "pass",
        "return",
        "python",
        "raw",
    ]
)
BLOCK_ENDS = frozenset(("end", "elif", "else"))
STATEMENT_ENDS = BLOCK_ENDS | LINE_ENDS
_IF_PARTS = frozenset(("if", "elif", "else"))
_LINE_END = Phrase("blocktext-end-of-line")

Read = TypeVar("Read")


class BlockParser(LineRewriter):
    """Reads blocks; a subclass reads their statements."""

    def __init__(self, tokens: Tokens) -> None:
        super().__init__(tokens)
        self.openers: list[Token] = []  # first tokens of the open blocks
        self.stopped = False  # nested too deeply: the rest of the file is skipped
        self.suspects: list[Token] = []  # blocks whose `end` is indented like an outer block

    def leave(self, slip: Slip) -> None:
        """Report why a statement cannot be read, and continue with the next line.

        If the line could be rewritten, read it again instead.
        """
        if isinstance(slip, Rewritten) or self.rewrite_line(self.openers):
            self.index = self.line_start()
            return
        if self.token.line not in self.rewritten:
            self.diagnostics.append(slip.diagnostic)
        self.skip_line()

    def note(self, items: list[Any]) -> bool:
        """Read a line end, blank lines or a comment; return False for anything else."""
        index = self.index
        if index in self.hoisted:
            items.extend(map(comment_of, self.hoisted.pop(index)))
        kind = self.kinds[index]
        if kind == "comment":
            items.append(comment_of(self.tokens[index]))
        elif kind == "blank":
            if items and type(items[-1]) is not Blank:
                items.append(Blank())
        elif kind != "newline":
            return False
        self.index = index + 1
        return True

    def line_end(self, start: Token) -> tuple[str | None, Span]:
        """The comment at the end of a statement's line, and the statement's span."""
        span = from_to(start, self.tokens[self.index - 1])
        kind = self.kinds[self.index]
        if kind == "newline":
            self.index += 1
        elif kind == "comment":
            self.index += 2
            return comment_text(self.tokens[self.index - 2]), span
        elif kind not in BLOCK_ENDS:
            raise self.more_on_line(kind)
        return None, span

    def more_on_line(self, kind: str) -> Slip:
        if kind in STATEMENT_STARTS:
            return self.second_statement()
        if kind in {")", "]", "}"}:
            message = Phrase("blocktext-closes-nothing", found=kind)
            return self.slip("unexpected", message)
        return self.unexpected(_LINE_END)

    def line_span(self, start: Token) -> Span:
        """The span from `start` to the last token of the previous line."""
        index = self.index - 1
        while self.kinds[index] in LINE_ENDS:
            index -= 1
        return from_to(start, self.tokens[index])

    def second_statement(self) -> Slip:
        message = Phrase("blocktext-two-statements", word=self.token.text)
        return self.slip("two-statements", message)

    def header(
        self, opener: Token, read: Callable[[], Read], instead: Read
    ) -> tuple[Read, str | None]:
        """Read the first line of a block; return its content and the comment after its colon.

        A slip in it is reported and replaced by `instead`, so that the body is still read.
        """
        self.nesting = 0
        try:
            value = read()
            return value, self.colon(opener)
        except Slip as slip:
            return self.header_again(opener, read, instead, slip)

    def header_again(
        self, opener: Token, read: Callable[[], Read], instead: Read, slip: Slip
    ) -> tuple[Read, str | None]:
        """Report a slip in the first line of a block, and read the line as it should be."""
        if self.rewrite_line(self.openers):
            self.index = self.line_start()
            if self.token.text != opener.text:
                raise Rewritten(slip.diagnostic)
            self.index += 1
            return self.header(opener, read, instead)
        self.leave(slip)
        self.index += 1
        return instead, None

    def colon(self, opener: Token) -> str | None:
        kind = self.kinds[self.index]
        if kind == ":":
            self.index += 1
        elif kind in LINE_ENDS:
            message = Phrase("blocktext-missing-colon", word=opener.text)
            last = self.before
            place = last._replace(column=last.column + len(last.text), text="")
            self.report("missing-colon", message, place)
        elif self.token.text in {"then", "do"}:
            raise self.slip("missing-colon", write_instead(self.token.text, ":"))
        elif opener.kind == "else" and self.line_ends_in_colon():
            raise self.else_with_condition(opener)
        else:
            raise self.unexpected(Phrase("blocktext-wanted-colon", word=opener.text))
        kind = self.kinds[self.index]
        if kind == "comment":
            self.index += 2
            return comment_text(self.tokens[self.index - 2])
        if kind == "newline":
            self.index += 1
        return None

    def else_with_condition(self, opener: Token) -> Slip:
        line = self.code_of(opener.line, self.line_end_index())
        written = line[opener.column - 1 :].strip()
        instead = "elif" + written.removeprefix("else")
        message = Phrase("blocktext-else-with-condition", found=written, instead=instead)
        return self.slip("else-with-condition", message, opener)

    def block(self, opener: Token) -> Body:
        """Read a body and its ``end``."""
        body = self.body(opener)
        self.close(opener, body)
        return tuple(body)

    def body(self, opener: Token) -> list[Statement]:
        self.check_depth(opener)
        self.openers.append(opener)
        body: list[Statement] = []
        empty = True
        while True:
            token = self.tokens[self.index]
            if token.kind == "raw" and self.is_python_part():
                break
            if token.kind not in STATEMENT_STARTS or self.hoisted:
                if self.note(body):
                    continue
                if self.body_ends(token):
                    break
            try:
                statement = self.statement(token)
            except Slip as slip:
                self.leave(slip)
                empty = False
                continue
            if statement is not None:
                body.append(statement)
            empty = empty and type(statement) is Raw and not raw.code_lines(statement.text)
        self.openers.pop()
        while body and type(body[-1]) is Blank:
            body.pop()
        if empty and not self.stopped:
            message = Phrase("blocktext-empty-block", word=opener.text)
            self.report("empty-block", message, opener)
        return body

    def is_python_part(self) -> bool:
        """Whether a further part of the innermost block in Python begins here."""
        return (
            self.openers[-1].kind == "raw"
            and self.kinds[self.index + 1] == ":"
            and is_further_part(self.token.text[1:])
        )

    def check_depth(self, opener: Token) -> None:
        if len(self.openers) >= MAX_BLOCKS and not self.stopped:
            message = Phrase("blocktext-too-many-blocks", limit=MAX_BLOCKS)
            self.report("too-deep", message, opener)
            self.stopped = True
            self.index = len(self.tokens) - 1

    def body_ends(self, token: Token) -> bool:
        if token.kind in TOP_LEVEL:
            # An `end` that is indented like a part of the block does not close it.
            return token.column <= self.openers[-1].column
        if token.kind in {"elif", "else"}:
            return any(opener.kind in _IF_PARTS for opener in self.openers)
        return token.kind in {"end", "eof"}

    def close(self, opener: Token, body: list[Statement]) -> None:
        """Read the ``end`` of a block; a comment after it becomes the last line of the body."""
        token = self.token
        if token.kind != "end":
            self.unclosed(opener)
            return
        if token.column < opener.column and any(
            outer.column == token.column for outer in self.openers
        ):
            self.suspects.append(opener)
        self.index += 1
        if self.kinds[self.index] in STATEMENT_ENDS:
            comment, _ = self.line_end(token)
            if comment is not None:
                body.append(Comment(comment, Span(token.line, token.column + 4)))
            return
        if self.rewrite_line(self.openers):
            self.index = self.line_start()
            self.close(opener, body)
            return
        self.diagnostics.append(self.unexpected(_LINE_END).diagnostic)
        self.skip_line()

    def unclosed(self, opener: Token) -> None:
        if self.stopped:
            return
        blamed = self.suspects.pop(0) if self.suspects else opener
        message = Phrase("blocktext-missing-end", word=blamed.text)
        self.report("missing-end", message, blamed)

    def statement(self, token: Token) -> Statement | None:
        """Read one statement; return None if it belongs elsewhere."""
        raise NotImplementedError


def comment_of(token: Token) -> Comment:
    """A comment on its own line."""
    return Comment(comment_text(token), from_to(token, token))


def comment_text(token: Token) -> str:
    return token.text[1:].strip()
