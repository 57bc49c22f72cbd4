"""Statements of Block-Text into trees, and the blocks that they form.

A statement that cannot be read is reported and left out; the next line is read as if nothing had
happened. A block whose first line is wrong still has its body and its ``end``.
"""

from collections.abc import Callable
from typing import Any, NamedTuple, TypeVar

from learnblock.language import raw, slips
from learnblock.language.expression_parser import OPERATORS, ExpressionParser, name_of
from learnblock.language.lexer import Token, Tokens
from learnblock.language.nodes import (
    Activate,
    Assign,
    Blank,
    Body,
    Branch,
    Break,
    Call,
    Comment,
    Constant,
    Continue,
    Deactivate,
    Else,
    Expression,
    ForEach,
    ForRange,
    If,
    Index,
    Item,
    Main,
    Name,
    Pass,
    Perform,
    Raw,
    Repeat,
    Return,
    SkillCall,
    Span,
    Statement,
    While,
)
from learnblock.language.slips import Slip
from learnblock.language.token_reader import LINE_ENDS, from_to

# Deeper trees would not fit on Python's own stack when they are written out again.
MAX_BLOCKS = 120

ASSIGNMENTS = frozenset(("=", "+=", "-=", "*=", "/=", "//=", "%=", "**="))
TOP_LEVEL = frozenset(("import", "def", "when", "main"))
_LINE_END = "the end of the line"
_WORDS: dict[str, type[Break | Continue | Pass]] = {
    "break": Break,
    "continue": Continue,
    "pass": Pass,
}
_IF_PARTS = frozenset(("if", "elif", "else"))
_BLOCK_ENDS = frozenset(("end", "elif", "else"))
_STATEMENT_ENDS = _BLOCK_ENDS | LINE_ENDS
_MISSING: Expression = Constant(None)

Read = TypeVar("Read")


class _Part(NamedTuple):
    """One part of an ``if``; the ``else`` has no condition."""

    condition: Expression | None
    comment: str | None
    body: list[Statement]
    span: Span


class _Counted(NamedTuple):
    """What stands between ``for`` and its colon."""

    target: Name = Name("_")
    values: Expression | None = None
    start: Expression = _MISSING
    stop: Expression = _MISSING
    step: Expression | None = None


class StatementParser(ExpressionParser):
    """Reads statements and blocks."""

    def __init__(self, tokens: Tokens) -> None:
        super().__init__(tokens)
        self.openers: list[Token] = []  # first tokens of the blocks that are open
        self.stopped = False  # too deep: nothing more is read, and nothing more reported
        self.suspects: list[Token] = []  # blocks whose `end` stands under an outer block

    def leave(self, slip: Slip) -> None:
        """Report what keeps a statement from being read, and go on below it."""
        self.diagnostics.append(slip.diagnostic)
        self.skip_line()

    def note(self, items: list[Any]) -> bool:
        """Read what is no statement: a line end, blank lines, a comment on a line of its own."""
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

    def stray(self, token: Token) -> None:
        self.index += 1
        if token.kind == "end":
            message = "this `end` closes nothing: remove it, or look for a block that begins above"
            self.report("stray-end", message, token)
        else:
            message = f"this `{token.kind}` belongs to no `if` that is still open"
            self.report("stray-" + token.kind, message, token)
        self.skip_line()

    def line_end(self, start: Token) -> tuple[str | None, Span]:
        """The comment at the end of a statement's line, and the statement's span."""
        span = from_to(start, self.tokens[self.index - 1])
        kind = self.kinds[self.index]
        if kind == "newline":
            self.index += 1
        elif kind == "comment":
            self.index += 2
            return comment_text(self.tokens[self.index - 2]), span
        elif kind not in _BLOCK_ENDS:
            raise self.second_statement() if kind in _STARTS else self.unexpected(_LINE_END)
        return None, span

    def line_span(self, start: Token) -> Span:
        """From `start` to the last token of the line that has just been left."""
        index = self.index - 1
        while self.kinds[index] in LINE_ENDS:
            index -= 1
        return from_to(start, self.tokens[index])

    def second_statement(self) -> Slip:
        message = f"one statement a line: start a new line before `{self.token.text}`"
        return self.slip("two-statements", message)

    # Blocks.

    def header(
        self, opener: Token, read: Callable[[], Read], instead: Read
    ) -> tuple[Read, str | None]:
        """What a block's first line says, and the comment behind its colon.

        A slip in it is reported and passed over, so that the body is still read as a body.
        """
        self.nesting = 0
        try:
            value = read()
            return value, self.colon(opener)
        except Slip as slip:
            self.leave(slip)
            self.index += 1
            return instead, None

    def colon(self, opener: Token) -> str | None:
        kind = self.kinds[self.index]
        if kind == ":":
            self.index += 1
        elif kind in LINE_ENDS:
            message = f"`{opener.text}` needs a `:` at the end of the line"
            last = self.before
            place = last._replace(column=last.column + len(last.text), text="")
            self.report("missing-colon", message, place)
        elif self.token.text in {"then", "do"}:
            raise self.slip("missing-colon", f"write `:` instead of `{self.token.text}`")
        else:
            raise self.unexpected(f"a `:` for `{opener.text}`")
        kind = self.kinds[self.index]
        if kind == "comment":
            self.index += 2
            return comment_text(self.tokens[self.index - 2])
        if kind == "newline":
            self.index += 1
        return None

    def block(self, opener: Token) -> Body:
        """A body and its ``end``."""
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
            if token.kind not in _STARTS or self.hoisted:
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
            message = f"this `{opener.text}` does nothing: write `pass` where nothing is to be done"
            self.report("empty-block", message, opener)
        return body

    def check_depth(self, opener: Token) -> None:
        if len(self.openers) >= MAX_BLOCKS and not self.stopped:
            message = f"more than {MAX_BLOCKS} blocks inside each other: use a function of your own"
            self.report("too-deep", message, opener)
            self.stopped = True
            self.index = len(self.tokens) - 1

    def body_ends(self, token: Token) -> bool:
        if token.kind in TOP_LEVEL:
            # One that is indented as if it were part of the block is no end of it.
            return token.column <= self.openers[-1].column
        if token.kind in {"elif", "else"}:
            return any(opener.kind in _IF_PARTS for opener in self.openers)
        return token.kind in {"end", "eof"}

    def close(self, opener: Token, body: list[Statement]) -> None:
        """Read the ``end`` of a block; a comment behind it becomes the body's last line."""
        token = self.token
        if token.kind != "end":
            self.unclosed(opener)
            return
        if token.column < opener.column and any(
            outer.column == token.column for outer in self.openers
        ):
            self.suspects.append(opener)
        self.index += 1
        if self.kinds[self.index] in _STATEMENT_ENDS:
            comment, _ = self.line_end(token)
            if comment is not None:
                body.append(Comment(comment, Span(token.line, token.column + 4)))
            return
        self.diagnostics.append(self.unexpected(_LINE_END).diagnostic)
        self.skip_line()

    def unclosed(self, opener: Token) -> None:
        if self.stopped:
            return
        blamed = self.suspects.pop(0) if self.suspects else opener
        message = (
            f"this `{blamed.text}` has no `end`: write `end` on a line of its own below its block"
        )
        self.report("missing-end", message, blamed)

    # Statements.

    def statement(self, token: Token) -> Statement | None:
        """Read one statement, or something that belongs elsewhere."""
        self.nesting = 0
        start = _STARTS.get(token.kind)
        if start is not None:
            return start(self, token)
        self.misplaced(token)
        return None

    def misplaced(self, token: Token) -> None:
        if token.kind in {"elif", "else"}:
            self.stray(token)
            return
        if token.kind not in TOP_LEVEL:
            raise slips.no_statement(token)
        message = f"a `{token.kind}` belongs at the top level, outside of `{self.openers[-1].text}`"
        self.report("nested-" + token.kind, message, token)
        self.item([], token)

    def item(self, items: list[Item | Main], token: Token) -> None:
        """Read one item of the top level and add it."""
        raise NotImplementedError

    def name_statement(self, token: Token) -> Statement:
        following = self.kinds[self.index + 1]
        if following in ASSIGNMENTS:
            self.index += 1
            return self.assignment(token, name_of(token))
        if token.text == "repeat" and following not in {"[", "."} and self.line_is_header():
            return self.repeat_loop(token)
        if following in {"(", "["}:
            return self.perform(token)
        slip = slips.odd_statement(token, *self.tokens[self.index + 1 : self.index + 3])
        if not (slips.opens_block(token.text) and self.line_ends_in_colon()):
            raise slip
        self.leave(slip)
        return While(_MISSING, self.block(token), None, self.line_span(token))

    def assignment(self, start: Token, target: Name | Index) -> Assign:
        operator = self.tokens[self.index]
        self.index += 1
        value = self.expression()
        if self.kinds[self.index] == "=":
            raise self.slip("second-assignment", "set one variable a line: `=` stands only once")
        return Assign(target, operator.text, value, *self.line_end(start))

    def perform(self, token: Token) -> Perform | Assign:
        call = self.postfix(token)
        if isinstance(call, Index) and self.kinds[self.index] in ASSIGNMENTS:
            return self.assignment(token, call)
        if self.kinds[self.index] in OPERATORS:
            message = "this value is used nowhere: set a variable with it, or write the call alone"
            raise self.slip("no-effect", message, token)
        if not isinstance(call, Call | SkillCall):
            raise self.slip(
                "no-effect", "this value is used nowhere: set a variable with it", token
            )
        if self.kinds[self.index] in ASSIGNMENTS:
            raise self.slip(
                "call-as-target", "a call cannot be set: write a variable before the `=`"
            )
        return Perform(call, *self.line_end(token))

    def word(self, token: Token) -> Break | Continue | Pass:
        self.index += 1
        return _WORDS[token.kind](*self.line_end(token))

    def activation(self, token: Token) -> Activate | Deactivate:
        self.index += 1
        name = self.expect("name", f"the name of a `when` after `{token.kind}`").text
        node = Activate if token.kind == "activate" else Deactivate
        return node(name, *self.line_end(token))

    def return_statement(self, token: Token) -> Return:
        self.index += 1
        value = None
        if self.kinds[self.index] not in _STATEMENT_ENDS:
            value = self.expression()
        return Return(value, *self.line_end(token))

    def raw_statement(self, token: Token) -> Raw:
        self.index += 1
        text = raw.read(token.text)
        span = Span(token.line, token.column, token.line + token.text.count("\n") + 1, 1)
        if self.kinds[self.index] == "end":
            self.index += 1
            if self.kinds[self.index] == "comment":
                # It stays where it is, on a line of its own.
                return Raw(text, span)
            self.line_end(token)
        return Raw(text, span)

    def if_chain(self, token: Token) -> If:
        parts = [self.part(token)]
        while self.kinds[self.index] in {"elif", "else"}:
            if parts[-1].condition is None:
                message = f"this `{self.token.kind}` comes after `else`, which must be the last"
                self.report("stray-" + self.token.kind, message, self.token)
            parts.append(self.part(self.token))
        self.close(token, parts[-1].body)
        branches = tuple(
            Branch(part.condition, tuple(part.body), part.comment, part.span)
            for part in parts
            if part.condition is not None
        )
        last = parts[-1]
        otherwise = (
            Else(tuple(last.body), last.comment, last.span) if last.condition is None else None
        )
        return If(branches, otherwise, self.line_span(token))

    def part(self, opener: Token) -> _Part:
        self.index += 1
        instead: Expression | None = _MISSING
        condition, comment = self.header(opener, self.condition_of(opener), instead)
        span = self.line_span(opener)
        return _Part(condition, comment, self.body(opener), span)

    def condition_of(self, opener: Token) -> Callable[[], Expression | None]:
        if opener.kind != "else":
            return self.expression
        if self.kinds[self.index] != "if":
            return lambda: None
        self.report("else-if", "`else if` is written `elif`", opener)
        self.index += 1
        return self.expression

    def while_loop(self, token: Token) -> While:
        self.index += 1
        condition, comment = self.header(token, self.expression, _MISSING)
        return While(condition, self.block(token), comment, self.line_span(token))

    def repeat_loop(self, token: Token) -> Repeat:
        self.index += 1
        count, comment = self.header(token, self.expression, _MISSING)
        return Repeat(count, self.block(token), comment, self.line_span(token))

    def line_is_header(self) -> bool:
        """Whether this line ends in a colon, or at least begins as a ``repeat`` loop would."""
        return self.kinds[self.index + 1] != "(" or self.line_ends_in_colon()

    def for_loop(self, token: Token) -> ForEach | ForRange:
        self.index += 1
        counted, comment = self.header(token, self.counted, _Counted())
        body = self.block(token)
        span = self.line_span(token)
        target, values, start, stop, step = counted
        if values is not None:
            return ForEach(target, values, body, comment, span)
        return ForRange(target, start, stop, step, body, comment, span)

    def counted(self) -> _Counted:
        target = name_of(self.expect("name", "the name of a variable after `for`"))
        if self.kinds[self.index] == "in":
            self.index += 1
            return _Counted(target, self.expression())
        if self.kinds[self.index] == "=":
            raise self.slip("unexpected", f"write `for {target.name} from 1 to 10:`, without `=`")
        self.word_of_for("from", "`in` and a list, or `from` and a number,")
        start = self.expression()
        self.word_of_for("to", "`to` and the last number")
        stop = self.expression()
        step = None
        if self.token.text == "step":
            self.index += 1
            step = self.expression()
        return _Counted(target, None, start, stop, step)

    def word_of_for(self, word: str, wanted: str) -> None:
        if self.token.text != word:
            raise self.unexpected(wanted)
        self.index += 1


_STARTS: dict[str, Callable[[StatementParser, Token], Statement]] = {
    "name": StatementParser.name_statement,
    "function": StatementParser.perform,
    "if": StatementParser.if_chain,
    "while": StatementParser.while_loop,
    "for": StatementParser.for_loop,
    "activate": StatementParser.activation,
    "deactivate": StatementParser.activation,
    "break": StatementParser.word,
    "continue": StatementParser.word,
    "pass": StatementParser.word,
    "return": StatementParser.return_statement,
    "python": StatementParser.raw_statement,
}


def comment_of(token: Token) -> Comment:
    """A comment on a line of its own."""
    return Comment(comment_text(token), from_to(token, token))


def comment_text(token: Token) -> str:
    return token.text[1:].strip()
