"""Parse statements of Block-Text.

A statement with an error is reported and left out, and parsing continues with the next line.
"""

from collections.abc import Callable
from dataclasses import replace
from typing import NamedTuple

from learnblock.i18n import Phrase
from learnblock.language.blocktext import slips
from learnblock.language.blocktext.block_parser import (
    STATEMENT_ENDS,
    STATEMENT_STARTS,
    TOP_LEVEL,
    BlockParser,
)
from learnblock.language.blocktext.expression_parser import OPERATORS, name_of, python_of
from learnblock.language.blocktext.lexer import LINE_ENDS, Token
from learnblock.language.blocktext.line_rewriter import is_in_function
from learnblock.language.blocktext.token_reader import from_to
from learnblock.language.tree import raw
from learnblock.language.tree.characters import write_instead
from learnblock.language.tree.nodes import (
    Activate,
    Assign,
    Branch,
    Break,
    Call,
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
    PythonBlock,
    PythonLine,
    PythonPart,
    Raw,
    Repeat,
    Return,
    SkillCall,
    Span,
    Statement,
    WaitUntil,
    While,
    is_further_part,
)

ASSIGNMENTS = frozenset(("=", "+=", "-=", "*=", "/=", "//=", "%=", "**="))
_WORDS: dict[str, type[Break | Continue | Pass]] = {
    "break": Break,
    "continue": Continue,
    "pass": Pass,
}
_MISSING: Expression = Constant(None)


class _Part(NamedTuple):
    """One branch of an ``if``; the ``else`` has no condition."""

    condition: Expression | None
    comment: str | None
    body: list[Statement]
    span: Span


class _Counted(NamedTuple):
    """The part of a ``for`` loop between ``for`` and the colon."""

    targets: tuple[Name, ...] = (Name("_"),)
    values: Expression | None = None
    start: Expression = _MISSING
    stop: Expression = _MISSING
    step: Expression | None = None


class StatementParser(BlockParser):
    """Reads statements."""

    def stray(self, token: Token) -> None:
        self.index += 1
        if token.kind == "end":
            self.report("stray-end", Phrase("blocktext-stray-end"), token)
        else:
            message = Phrase("blocktext-stray-branch", word=token.kind)
            self.report("stray-" + token.kind, message, token)
        self.skip_line()

    def statement(self, token: Token) -> Statement | None:
        """Read one statement; return None if it belongs elsewhere."""
        self.nesting = 0
        read = _READERS.get(token.kind)
        if read is not None:
            return read(self, token)
        self.misplaced(token)
        return None

    def misplaced(self, token: Token) -> None:
        if token.kind in {"elif", "else"}:
            self.stray(token)
            return
        if token.kind not in TOP_LEVEL:
            raise slips.no_statement(token)
        message = Phrase("blocktext-nested", word=token.kind, opener=self.openers[-1].text)
        self.report("nested-" + token.kind, message, token)
        self.item([], token)

    def item(self, items: list[Item | Main], token: Token) -> None:
        """Read one item of the top level and add it to `items`."""
        raise NotImplementedError

    def name_statement(self, token: Token) -> Statement | None:
        following = self.kinds[self.index + 1]
        if following in ASSIGNMENTS:
            self.index += 1
            return self.assignment(token, name_of(token))
        if token.text in _SOFT and (read := self.soft_keyword(token, following)) is not None:
            return read(self, token)
        if following in {"(", "["}:
            return self.perform(token)
        if token.text in slips.HANDLERS and any(opener.text == "try" for opener in self.openers):
            # What is to be done about it has been said at the `try`.
            self.skip_line()
            return None
        slip = slips.odd_statement(token, *self.tokens[self.index + 1 : self.index + 3])
        if self.rewrite_line(self.openers):
            raise slips.Rewritten(slip.diagnostic)
        if not (slips.opens_block(token.text) and self.line_ends_in_colon()):
            raise slip
        self.leave(slip)
        return While(_MISSING, self.block(token), None, self.line_span(token))

    def soft_keyword(self, token: Token, following: str) -> "_Reader | None":
        """How to read a line whose first name is a keyword here; None if it is only a name."""
        match token.text:
            case "repeat" if following not in {"[", "."} and self.line_is_header():
                return StatementParser.repeat_loop
            case "forever" if following == ":" or following in LINE_ENDS:
                return StatementParser.forever_loop
            case "wait" if self.tokens[self.index + 1].text == "until":
                return StatementParser.wait_until
            case "local" if following == "name" and self.kinds[self.index + 2] == "=":
                # Elsewhere, the word of another language is left out.
                inside = is_in_function(self.openers)
                return StatementParser.local_variable if inside else None
        return None

    def assignment(self, start: Token, target: Name | Index) -> Assign:
        operator = self.tokens[self.index]
        self.index += 1
        value = self.expression()
        if self.kinds[self.index] == "=":
            raise self.slip("second-assignment", Phrase("blocktext-second-assignment"))
        return Assign(target, operator.text, value, *self.line_end(start))

    def local_variable(self, start: Token) -> Assign:
        self.index += 2
        target = name_of(self.tokens[self.index - 1])
        return replace(self.assignment(start, target), is_local=True)

    def perform(self, token: Token) -> Perform | Assign:
        call = self.postfix(token)
        if isinstance(call, Index) and self.kinds[self.index] in ASSIGNMENTS:
            return self.assignment(token, call)
        if self.kinds[self.index] in OPERATORS:
            raise self.slip("no-effect", Phrase("blocktext-unused-result"), token)
        if not isinstance(call, Call | SkillCall):
            raise self.slip("no-effect", Phrase("blocktext-unused-value"), token)
        if self.kinds[self.index] in ASSIGNMENTS:
            raise self.slip("call-as-target", Phrase("blocktext-call-as-target"))
        return Perform(call, *self.line_end(token))

    def word(self, token: Token) -> Break | Continue | Pass:
        self.index += 1
        return _WORDS[token.kind](*self.line_end(token))

    def activation(self, token: Token) -> Activate | Deactivate:
        self.index += 1
        name = self.expect("name", Phrase("blocktext-wanted-when", word=token.kind)).text
        node = Activate if token.kind == "activate" else Deactivate
        return node(name, *self.line_end(token))

    def return_statement(self, token: Token) -> Return:
        self.index += 1
        value = None
        if self.kinds[self.index] not in STATEMENT_ENDS:
            value = self.expression()
        return Return(value, *self.line_end(token))

    def raw_statement(self, token: Token) -> Raw:
        self.index += 1
        text = raw.read(token.text)
        span = Span(token.line, token.column, token.line + token.text.count("\n") + 1, 1)
        if self.kinds[self.index] == "end":
            self.index += 1
            if self.kinds[self.index] == "comment":
                # The comment stays on its own line.
                return Raw(text, span)
            self.line_end(token)
        return Raw(text, span)

    def python_statement(self, token: Token) -> PythonLine | PythonBlock:
        if self.kinds[self.index + 1] != ":":
            self.index += 1
            return PythonLine(python_of(token), *self.line_end(token))
        if is_further_part(python_of(token)):
            message = Phrase("blocktext-not-a-beginning", words=python_of(token))
            self.report("not-a-beginning", message, token)
        has_cases = PythonPart(python_of(token), ()).has_cases
        parts = self.match_parts(token) if has_cases else [self.python_part(token)]
        while self.kinds[self.index] == "raw":
            parts.append(self.python_part(self.token))
        last = list(parts[-1].body)
        self.close(token, last)
        parts[-1] = replace(parts[-1], body=tuple(last))
        return PythonBlock(tuple(parts), self.line_span(token))

    def match_parts(self, token: Token) -> list[PythonPart]:
        """The first line of a ``match``, and its first case with the comments above it."""
        self.index += 1
        _, comment = self.header(token, lambda: None, None)
        match = PythonPart(python_of(token), (), comment, self.line_span(token))
        above: list[Statement] = []
        while self.note(above):
            pass
        if self.token.kind == "name" and self.rewrite_line([*self.openers, token]):
            self.index = self.line_start()
        if self.kinds[self.index] == "raw" and is_further_part(self.token.text[1:]):
            case = self.python_part(self.token)
            return [match, replace(case, body=(*above, *case.body))]
        self.report("match-without-case", Phrase("blocktext-match-without-case"), token)
        if self.kinds[self.index] in STATEMENT_STARTS:
            self.body(token)
        return [match]

    def python_part(self, opener: Token) -> PythonPart:
        self.index += 1
        _, comment = self.header(opener, lambda: None, None)
        span = self.line_span(opener)
        return PythonPart(python_of(opener), tuple(self.body(opener)), comment, span)

    def if_chain(self, token: Token) -> If:
        parts = [self.part(token)]
        while self.kinds[self.index] in {"elif", "else"}:
            if parts[-1].condition is None:
                message = Phrase("blocktext-after-else", word=self.token.kind)
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
        self.report("else-if", write_instead("else if", "elif"), opener)
        self.index += 1
        return self.expression

    def while_loop(self, token: Token) -> While:
        self.index += 1
        condition, comment = self.header(token, self.expression, _MISSING)
        return While(condition, self.block(token), comment, self.line_span(token))

    def forever_loop(self, token: Token) -> While:
        self.index += 1
        _, comment = self.header(token, lambda: None, None)
        always = Constant(value=True, span=from_to(token, token))
        return While(always, self.block(token), comment, self.line_span(token))

    def wait_until(self, token: Token) -> WaitUntil:
        self.index += 2
        return WaitUntil(self.expression(), *self.line_end(token))

    def repeat_loop(self, token: Token) -> Repeat:
        self.index += 1
        count, comment = self.header(token, self.expression, _MISSING)
        return Repeat(count, self.block(token), comment, self.line_span(token))

    def line_is_header(self) -> bool:
        """Whether this line ends in a colon, or at least begins like a ``repeat`` loop."""
        return self.kinds[self.index + 1] != "(" or self.line_ends_in_colon()

    def for_loop(self, token: Token) -> ForEach | ForRange:
        self.index += 1
        counted, comment = self.header(token, self.counted, _Counted())
        body = self.block(token)
        span = self.line_span(token)
        targets, values, start, stop, step = counted
        if values is not None:
            return ForEach(targets, values, body, comment, span)
        return ForRange(targets[0], start, stop, step, body, comment, span)

    def counted(self) -> _Counted:
        target = self.loop_variable()
        targets = [target]
        while self.kinds[self.index] == ",":
            self.index += 1
            targets.append(self.loop_variable())
        if self.kinds[self.index] == "in":
            self.index += 1
            return _Counted(tuple(targets), self.expression())
        if len(targets) > 1:
            raise self.unexpected(Phrase("blocktext-wanted-in"))
        if self.kinds[self.index] == "=":
            raise self.slip("unexpected", Phrase("blocktext-for-equals", name=target.name))
        self.word_of_for("from", Phrase("blocktext-wanted-in-or-from"))
        start = self.expression()
        self.word_of_for("to", Phrase("blocktext-wanted-to"))
        stop = self.expression()
        step = None
        if self.token.text == "step":
            self.index += 1
            step = self.expression()
        return _Counted((target,), None, start, stop, step)

    def loop_variable(self) -> Name:
        return name_of(self.expect("name", Phrase("blocktext-wanted-loop-variable")))

    def word_of_for(self, word: str, wanted: Phrase) -> None:
        if self.token.text != word:
            raise self.unexpected(wanted)
        self.index += 1


_Reader = Callable[[StatementParser, Token], Statement | None]
#: Names that begin a statement of their own, if their line has its form.
_SOFT = frozenset(("repeat", "forever", "wait", "local"))
# One method for each of `STATEMENT_STARTS`.
_READERS: dict[str, _Reader] = {
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
    "raw": StatementParser.python_statement,
}
