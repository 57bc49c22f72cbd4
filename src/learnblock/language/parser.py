"""Block-Text into a tree: recursive descent by hand, which goes on after an error.

A statement that cannot be read is reported and left out; the next line is read as if nothing had
happened. A block whose first line is wrong still has its body and its ``end``.
"""

import re
from collections.abc import Callable
from typing import Any, NamedTuple, TypeVar

from learnblock.errors import Diagnostic, ProgramError, did_you_mean
from learnblock.language import raw
from learnblock.language.layout import normalized
from learnblock.language.lexer import KEYWORDS, Token, Tokens, tokenize
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
from learnblock.language.strings import unquote

# Deeper trees would not fit on Python's own stack when they are written out again.
MAX_BLOCKS = 120
MAX_HEIGHT = 200
MAX_DIGITS = 1000
MAX_DIAGNOSTICS = 100

_LEVELS = {
    "or": 1,
    "and": 2,
    "not": 4,  # of `not in`
    "in": 4,
    "==": 4,
    "!=": 4,
    "<": 4,
    ">": 4,
    "<=": 4,
    ">=": 4,
    "+": 5,
    "-": 5,
    "*": 6,
    "/": 6,
    "//": 6,
    "%": 6,
    "**": 8,
}
_NOT, _COMPARE, _SIGN, _POWER = 3, 4, 7, 8
_ASSIGNMENTS = frozenset(("=", "+=", "-=", "*=", "/=", "//=", "%=", "**="))
_CONSTANTS = {"True": True, "False": False, "None": None}
_TOP_LEVEL = frozenset(("import", "def", "when", "main", "eof"))
_NUMBER = re.compile(
    r"0[xX](?:_?[0-9a-fA-F])+|0[bB](?:_?[01])+|0[oO](?:_?[0-7])+"
    r"|0(?:_?0)*|[1-9](?:_?[0-9])*"
    r"|(?:[0-9](?:_?[0-9])*)?\.[0-9](?:_?[0-9])*(?:[eE][-+]?[0-9](?:_?[0-9])*)?"
    r"|[0-9](?:_?[0-9])*\.(?:[eE][-+]?[0-9](?:_?[0-9])*)?"
    r"|[0-9](?:_?[0-9])*[eE][-+]?[0-9](?:_?[0-9])*"
)
_MODULE = re.compile(r"[^\W\d]\w*(?:\.[^\W\d]\w*)*")

_CHARACTERS = {
    "“": 'write a straight quote `"`',
    "”": 'write a straight quote `"`',
    "„": 'write a straight quote `"`',
    "«": 'write a straight quote `"`',
    "»": 'write a straight quote `"`',
    "‘": "write a straight quote `'`",
    "’": "write a straight quote `'`",
    "≤": "write `<=`",
    "≥": "write `>=`",
    "≠": "write `!=`",
    "×": "write `*`",
    "÷": "write `/`",
    "–": "write `-`",
    "—": "write `-`",
    "−": "write `-`",
    "&": "write `and`",
    "|": "write `or`",
    "!": "write `not`",
    "^": "a power is written `**`",
    ";": "write each statement on a line of its own",
    "{": "a block begins with `:` and closes with `end`",
    "}": "a block begins with `:` and closes with `end`",
    "@": "remove it",
}
_OTHER_LANGUAGES = {
    "elseif": "write `elif`",
    "elsif": "write `elif`",
    "switch": "write `if` and `elif`",
    "function": "write `def`",
    "func": "write `def`",
    "var": "write the name, `=` and the value",
    "let": "write the name, `=` and the value",
    "loop": "write `while True:` or `repeat`",
    "foreach": "write `for x in values:`",
    "endif": "a block closes with `end`",
    "endwhile": "a block closes with `end`",
    "fi": "a block closes with `end`",
    "done": "a block closes with `end`",
    "from": 'write `import "name"`',
    "class": "Block-Text has no classes: use a `python:` block",
    "try": "use a `python:` block",
    "with": "use a `python:` block",
    "global": "all variables are global: leave it out",
}
_OPENING_WORDS = (
    "if",
    "elif",
    "else",
    "while",
    "repeat",
    "for",
    "when",
    "main",
    "def",
    "end",
    "return",
    "break",
    "continue",
    "pass",
    "activate",
    "deactivate",
    "import",
    "function",
)
# Words with which a block begins, here or in another language.
_BLOCK_WORDS = frozenset(
    [
        "if",
        "while",
        "for",
        "repeat",
        "def",
        "when",
        "main",
        "switch",
        "loop",
        "foreach",
        "function",
        "func",
        "class",
        "try",
        "with",
        "until",
        "unless",
        "forever",
    ]
)
_UNEXPECTED = {
    "=": ("assignment-in-condition", "`=` sets a variable: to compare, write `==`"),
    "is": ("unknown-word", "`is` is not a word of Block-Text: to compare, write `==`"),
    "then": ("unknown-word", "`then` is not a word of Block-Text: write `:`"),
    "&": ("unknown-word", "`&` is not an operator: write `and`"),
    "|": ("unknown-word", "`|` is not an operator: write `or`"),
}
_LINE_END = "the end of the line"
_COMPARES = "`==` compares: to set `{0}`, write `{0} = ...`"
_WORDS: dict[str, type[Break | Continue | Pass]] = {
    "break": Break,
    "continue": Continue,
    "pass": Pass,
}
_IF_PARTS = frozenset(("if", "elif", "else"))
_AFTER_NAME = frozenset((".", "string"))
_MISSING: Expression = Constant(None)

Read = TypeVar("Read")


def parse(text: str, filename: str = "program.bt") -> Program:
    """The tree of a program in Block-Text.

    Raises:
        ProgramError: with every error of the file.
    """
    program, diagnostics = recover(text)
    if diagnostics:
        raise ProgramError(filename, diagnostics, text)
    return program


def recover(text: str) -> tuple[Program, tuple[Diagnostic, ...]]:
    """What can be read of a program in Block-Text, and all that is wrong with it. Never raises."""
    parser = _Parser(tokenize(text))
    try:
        program = parser.program()
    except RecursionError:
        # Our limits are far below Python's, so this takes a caller who has used up the stack.
        return Program(), (_too_deep(parser.token),)
    found = sorted(parser.diagnostics, key=lambda diagnostic: (diagnostic.line, diagnostic.column))
    return program, tuple(dict.fromkeys(found))[:MAX_DIAGNOSTICS]


class _Slip(Exception):  # noqa: N818 - it is not an error of the program's, it unwinds to the statement
    def __init__(self, diagnostic: Diagnostic) -> None:
        self.diagnostic = diagnostic


# Twice as fast as Span(...).
_new = tuple.__new__


def _at(token: Token, code: str, message: str) -> Diagnostic:
    width = max(len(token.text.split("\n", 1)[0]), 1)
    return Diagnostic(code, message, token.line, token.column, token.column + width)


def _too_deep(token: Token) -> Diagnostic:
    message = "this is nested too deeply: give a part of it a name of its own"
    return _at(token, "too-deep", message)


def _described(token: Token) -> str:
    if token.kind in {"newline", "blank", "comment"}:
        return "the end of the line"
    if token.kind == "eof":
        return "the end of the program"
    return f"`{token.text}`"


class _Parser:
    """Reads one list of tokens; `index` is the token that comes next."""

    def __init__(self, tokens: Tokens) -> None:
        self.tokens, self.kinds = tokens.tokens, tokens.kinds
        self.hoisted = tokens.hoisted
        self.diagnostics = tokens.diagnostics
        self.index = 0
        self.height = 0  # of the expression read last
        self.nesting = 0  # of brackets
        self.openers: list[Token] = []  # first tokens of the blocks that are open
        self.stopped = False  # too deep: nothing more is read, and nothing more reported
        self.suspects: list[Token] = []  # blocks whose `end` stands under an outer block

    @property
    def token(self) -> Token:
        return self.tokens[self.index]

    def report(self, code: str, message: str, token: Token) -> None:
        self.diagnostics.append(_at(token, code, message))

    def slip(self, code: str, message: str, token: Token | None = None) -> _Slip:
        return _Slip(_at(token or self.token, code, message))

    def unexpected(self, wanted: str) -> _Slip:
        token = self.token
        if token.kind == "bad":
            return self.bad_character(token)
        if token.kind == "=" and self.kinds[self.index - 1] in KEYWORDS:
            return self.reserved(self.tokens[self.index - 1])
        advice = _UNEXPECTED.get(token.text)
        if advice:
            return self.slip(*advice)
        message = f"{wanted} is needed here, not {_described(token)}"
        return self.slip("unexpected", message)

    def reserved(self, token: Token) -> _Slip:
        message = f"`{token.text}` is a word of the language: choose another name"
        return self.slip("reserved-word", message, token)

    def bad_character(self, token: Token) -> _Slip:
        mark = token.text[0]
        if mark in "\"'`":
            message = f"no closing {mark} on this line: write {mark} where the text ends"
            return self.slip("missing-quote", message, token)
        advice = _CHARACTERS.get(token.text, "it has no meaning in Block-Text: remove it")
        return self.slip("bad-character", f"`{token.text}`: {advice}", token)

    def expect(self, kind: str, wanted: str) -> Token:
        if self.kinds[self.index] != kind:
            raise self.unexpected(wanted)
        self.index += 1
        return self.tokens[self.index - 1]

    def skip_line(self) -> None:
        kinds, index = self.kinds, self.index
        while kinds[index] not in {"newline", "eof"}:
            index += 1
        self.index = index

    def span(self, start: Token) -> Span:
        """From `start` to the token read last."""
        last = self.tokens[self.index - 1]
        if last.kind == "newline":
            return Span(start.line, start.column, last.line, last.column)
        return Span(start.line, start.column, last.line, last.column + len(last.text))

    def program(self) -> Program:
        items: list[Item | Main] = []
        while self.kinds[self.index] != "eof":
            if not self.note(items):
                self.item(items, self.token)
        return _arranged(items, Span(1, 1, self.token.line, self.token.column))

    def item(self, items: list[Item | Main], token: Token) -> None:
        """Read one item of the top level and add it."""
        read = _TOPS.get(token.kind, _Parser.statement)
        if token.text == "robot" and self.sets_up(items):
            read = _Parser.setup
        try:
            if token.kind in _TOPS and self.kinds[self.index + 1] in _ASSIGNMENTS:
                raise self.reserved(token)
            item = read(self, token)
        except _Slip as slip:
            self.leave(slip)
            return
        if isinstance(item, Main) and any(isinstance(other, Main) for other in items):
            self.report("second-main", "a program has one `main`: join the two", token)
        elif item is not None:
            items.append(item)

    def leave(self, slip: _Slip) -> None:
        """Report what keeps a statement from being read, and go on below it."""
        self.diagnostics.append(slip.diagnostic)
        self.skip_line()

    def note(self, items: list[Any]) -> bool:
        """Read what is no statement: a line end, blank lines, a comment on a line of its own."""
        index = self.index
        if index in self.hoisted:
            items.extend(map(_comment, self.hoisted.pop(index)))
        kind = self.kinds[index]
        if kind == "comment":
            items.append(_comment(self.tokens[index]))
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

    def line_end(self) -> str | None:
        """The comment at the end of a statement's line, and on to the next line."""
        kind = self.kinds[self.index]
        comment = None
        if kind == "comment":
            comment = _comment_text(self.token)
            self.index += 1
            kind = "newline"
        if kind == "newline":
            self.index += 1
        elif kind not in {"end", "elif", "else"}:
            raise self.second_statement() if kind in _STARTS else self.unexpected(_LINE_END)
        return comment

    def second_statement(self) -> _Slip:
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
        except _Slip as slip:
            self.leave(slip)
            self.index += 1
            return instead, None

    def colon(self, opener: Token) -> str | None:
        kind = self.kinds[self.index]
        if kind == ":":
            self.index += 1
        elif kind in {"newline", "comment"}:
            message = f"`{opener.text}` needs a `:` at the end of the line"
            last = self.tokens[self.index - 1]
            place = last._replace(column=last.column + len(last.text), text="")
            self.report("missing-colon", message, place)
        elif self.token.text in {"then", "do"}:
            raise self.slip("missing-colon", f"write `:` instead of `{self.token.text}`")
        else:
            raise self.unexpected(f"a `:` for `{opener.text}`")
        kind = self.kinds[self.index]
        if kind == "comment":
            self.index += 2
            return _comment_text(self.tokens[self.index - 2])
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
            if self.note(body):
                continue
            index = self.index
            if self.body_ends():
                break
            if index != self.index:
                empty = False  # something that belongs elsewhere has been read
                continue
            token = self.tokens[index]
            try:
                statement = self.statement(token)
            except _Slip as slip:
                self.leave(slip)
                empty = False
                continue
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

    def body_ends(self) -> bool:
        token = self.tokens[self.index]
        kind = token.kind
        if kind in _TOP_LEVEL:
            return not self.nested_definition(token)
        if kind not in {"elif", "else"}:
            return kind == "end"
        if any(opener.kind in _IF_PARTS for opener in self.openers):
            return True
        self.stray(token)
        return False

    def nested_definition(self, token: Token) -> bool:
        """Read a ``def`` where none may be, if it is indented as if it were part of the block."""
        opener = self.openers[-1]
        if token.kind == "eof" or token.column <= opener.column:
            return False
        message = f"a `{token.kind}` belongs at the top level, outside of `{opener.text}`"
        self.report("nested-" + token.kind, message, token)
        self.item([], token)
        return True

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
        if self.kinds[self.index] in {"newline", "comment", "end", "elif", "else"}:
            comment = self.line_end()
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

    def statement(self, token: Token) -> Statement:
        self.nesting = 0
        start = _STARTS.get(token.kind)
        if start is None:
            raise self.not_a_statement(token)
        return start(self, token)

    def not_a_statement(self, token: Token) -> _Slip:
        if token.kind == "bad":
            return self.bad_character(token)
        message = f"a statement cannot begin with {_described(token)}"
        return self.slip("unexpected", message, token)

    def name_statement(self, token: Token) -> Statement:
        following = self.kinds[self.index + 1]
        if following in _ASSIGNMENTS:
            self.index += 1
            return self.assignment(token, self.name_of(token))
        if token.text == "repeat" and following not in {"[", "."} and self.line_is_header():
            return self.repeat_loop(token)
        if following in {"(", "["}:
            return self.perform(token)
        slip = self.odd_statement(token, self.tokens[self.index + 1])
        if not self.opens_block(token):
            raise slip
        self.leave(slip)
        return While(_MISSING, self.block(token), None, self.line_span(token))

    def opens_block(self, token: Token) -> bool:
        """Whether a line that begins with an unknown word still begins a block."""
        word = token.text.lower()
        if word not in _BLOCK_WORDS:
            word = did_you_mean(token.text, _OPENING_WORDS).removeprefix("did you mean `")[:-2]
        if word not in _BLOCK_WORDS:
            return False
        index = self.index
        while self.kinds[index] not in {"newline", "comment"}:
            index += 1
        return self.kinds[index - 1] == ":"

    def odd_statement(self, token: Token, following: Token) -> _Slip:  # noqa: PLR0911 - one a slip
        """What was meant by a name that begins neither a call nor an assignment?"""
        name = token.text
        if name in _OTHER_LANGUAGES:
            message = f"`{name}` is not a word of Block-Text: {_OTHER_LANGUAGES[name]}"
            return self.slip("unknown-word", message, token)
        if following.kind == "bad":
            return self.bad_character(following)
        if following.kind == ".":
            return self.dotted(token, self.tokens[self.index + 2].text)
        if following.kind == "==":
            return self.slip("comparison-as-statement", _COMPARES.format(name), following)
        if following.kind in {"name", "number", "string", "not", ":"} or following.kind in KEYWORDS:
            return self.misspelled(token, following)
        if following.kind in {"+", "-"} and self.kinds[self.index + 2] == following.kind:
            message = f"to count, write `{name} {following.kind}= 1`"
            return self.slip("unexpected", message, following)
        if following.kind in {"newline", "comment"}:
            message = f"`{name}` alone does nothing: to call it, write `{name}()`"
            return self.slip("no-effect", message, token)
        message = f"`{name}` must be followed by `(` for a call or by `=` to set it"
        return self.slip("unexpected", message, following)

    def dotted(self, token: Token, skill: str) -> _Slip:
        if token.text in {"robot", "functions", "fuction", "funtion", "Function"}:
            message = f"`{token.text}.{skill}`: a skill is called `function.{skill}(...)`"
        else:
            message = (
                f"`{token.text}.{skill}`: Block-Text has no `.` except in `function.`; "
                "put Python between backticks or in a `python:` block"
            )
        return self.slip("unknown-dot", message, token)

    def misspelled(self, token: Token, following: Token) -> _Slip:
        name = token.text
        lowered = name.lower()
        if lowered in _OPENING_WORDS:
            return self.slip("unknown-word", f"`{name}` is written `{lowered}`", token)
        hint = did_you_mean(name, _OPENING_WORDS)
        if following.kind in {"string", "number", "name"} and not hint:
            message = f"to call `{name}`, write its arguments in brackets: `{name}(...)`"
            return self.slip("missing-brackets", message, following)
        return self.slip(
            "unknown-word", f"`{name}` begins no statement" + (hint and f"; {hint}"), token
        )

    def assignment(self, start: Token, target: Name | Index) -> Assign:
        operator = self.tokens[self.index]
        self.index += 1
        value = self.expression()
        if self.kinds[self.index] == "=":
            raise self.slip("second-assignment", "set one variable a line: `=` stands only once")
        comment = self.line_end()
        return Assign(target, operator.text, value, comment, self.line_span(start))

    def line_span(self, start: Token) -> Span:
        """From `start` to the last token of the line that has just been left."""
        index = self.index - 1
        while self.kinds[index] in {"newline", "comment"}:
            index -= 1
        last = self.tokens[index]
        return _new(Span, (start.line, start.column, last.line, last.column + len(last.text)))

    def perform(self, token: Token) -> Perform | Assign:
        call = self.postfix(token)
        if isinstance(call, Index) and self.kinds[self.index] in _ASSIGNMENTS:
            return self.assignment(token, call)
        if self.kinds[self.index] in _LEVELS:
            message = "this value is used nowhere: set a variable with it, or write the call alone"
            raise self.slip("no-effect", message, token)
        if not isinstance(call, Call | SkillCall):
            raise self.slip(
                "no-effect", "this value is used nowhere: set a variable with it", token
            )
        if self.kinds[self.index] in _ASSIGNMENTS:
            raise self.slip(
                "call-as-target", "a call cannot be set: write a variable before the `=`"
            )
        return Perform(call, self.line_end(), self.line_span(token))

    def word(self, token: Token) -> Break | Continue | Pass:
        self.index += 1
        comment = self.line_end()
        return _WORDS[token.kind](comment, self.line_span(token))

    def activation(self, token: Token) -> Activate | Deactivate:
        self.index += 1
        name = self.expect("name", f"the name of a `when` after `{token.kind}`").text
        comment = self.line_end()
        node = Activate if token.kind == "activate" else Deactivate
        return node(name, comment, self.line_span(token))

    def return_statement(self, token: Token) -> Return:
        self.index += 1
        value = None
        if self.kinds[self.index] not in {"newline", "comment", "end", "elif", "else"}:
            value = self.expression()
        return Return(value, self.line_end(), self.line_span(token))

    def raw_statement(self, token: Token) -> Raw:
        self.index += 1
        text = raw.read(token.text)
        span = Span(token.line, token.column, token.line + token.text.count("\n") + 1, 1)
        if self.kinds[self.index] == "end":
            self.index += 1
            if self.kinds[self.index] == "comment":
                # It stays where it is, on a line of its own.
                return Raw(text, span)
            self.line_end()
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

    def part(self, opener: Token) -> "_Part":
        self.index += 1
        instead: Expression | None = _MISSING
        condition, comment = self.header(opener, self.condition_of(opener), instead)
        span = self.line_span(opener)
        return _Part(condition, comment, self.body(opener), span)

    def condition_of(self, opener: Token) -> "Callable[[], Expression | None]":
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
        if self.kinds[self.index + 1] != "(":
            return True
        index = self.index
        while self.kinds[index] not in {"newline", "comment"}:
            index += 1
        return self.kinds[index - 1] == ":"

    def for_loop(self, token: Token) -> ForEach | ForRange:
        self.index += 1
        nothing: _Counted = (Name("_"), None, _MISSING, None, None)
        (target, values, start, stop, step), comment = self.header(token, self.counted, nothing)
        body = self.block(token)
        span = self.line_span(token)
        if values is not None:
            return ForEach(target, values, body, comment, span)
        return ForRange(target, start or _MISSING, stop or _MISSING, step, body, comment, span)

    def counted(self) -> "_Counted":
        target = self.name_of(self.expect("name", "the name of a variable after `for`"))
        if self.kinds[self.index] == "in":
            self.index += 1
            return target, self.expression(), None, None, None
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
        return target, None, start, stop, step

    def word_of_for(self, word: str, wanted: str) -> None:
        if self.token.text != word:
            raise self.unexpected(wanted)
        self.index += 1

    # Items of the top level.

    def main(self, token: Token) -> Main:
        self.index += 1
        _, comment = self.header(token, lambda: None, None)
        body = self.block(token)
        if comment is not None:
            body = (Comment(comment, Span(token.line, token.column)), *body)
        return Main(body, self.line_span(token))

    def import_(self, token: Token) -> Import:
        self.index += 1
        name = self.expect("string", 'the name of a file in quotes, such as "dance",')
        module = self.unquoted(name)
        if not _MODULE.fullmatch(module):
            hint = module.replace("\\", "/").rpartition("/")[2].removesuffix(".py")
            advice = f' such as "{hint}"' if _MODULE.fullmatch(hint) else ""
            message = f"`import` takes the name of a Python file without folder and .py{advice}"
            raise self.slip("import-name", message, name)
        return Import(module, self.line_end(), self.line_span(token))

    def definition(self, token: Token) -> Def:
        self.index += 1
        nothing: tuple[str, tuple[str, ...]] = ("_", ())
        (name, parameters), comment = self.header(token, self.signature, nothing)
        return Def(name, parameters, self.block(token), comment, self.line_span(token))

    def signature(self) -> tuple[str, tuple[str, ...]]:
        name = self.expect("name", "the function's name after `def`").text
        self.expect("(", f"`(` after `def {name}`")
        parameters: list[str] = []
        while self.kinds[self.index] != ")":
            if parameters:
                self.expect(",", "`,` or `)`")
            token = self.expect("name", "the name of a parameter or `)`")
            if token.text in parameters:
                message = f"two parameters are called `{token.text}`: rename one"
                raise self.slip("duplicate-parameter", message, token)
            parameters.append(token.text)
        self.index += 1
        return name, tuple(parameters)

    def when(self, token: Token) -> When:
        self.index += 1
        nothing: tuple[str, Expression | None] = ("_", None)
        (name, condition), comment = self.header(token, self.event, nothing)
        return When(name, condition, self.block(token), comment, self.line_span(token))

    def event(self) -> tuple[str, Expression | None]:
        name = self.expect("name", "a name after `when`, as in `when seen = condition:`,").text
        if self.kinds[self.index] != "=":
            return name, None
        self.index += 1
        return name, self.expression()

    def setup(self, token: Token) -> Setup:
        self.index += 1
        arguments, keywords = self.arguments()
        return Setup(arguments, keywords, self.line_end(), self.line_span(token))

    def sets_up(self, items: list[Item | Main]) -> bool:
        return self.kinds[self.index + 1] == "(" and all(
            isinstance(item, Comment | Blank | Import) for item in items
        )

    # Expressions. `height` is how high the tree is that was read last.

    def expression(self, level: int = 1) -> Expression:
        kinds = self.kinds
        kind = kinds[self.index]
        atom = _ATOMS.get(kind)
        if atom is None:
            left = self.prefixed(kind, level)
        else:
            left = atom(self, self.tokens[self.index])
            if kinds[self.index] == "[":
                left = self.indexed(left)
        while True:
            operator = kinds[self.index]
            binding = _LEVELS.get(operator)
            if binding is None or binding < level:
                return left
            if binding == _COMPARE:
                if operator == "not" and kinds[self.index + 1] != "in":
                    return left
                left = self.comparison(left)
                continue
            height = self.height
            self.index += 1
            right = self.exponent() if binding == _POWER else self.expression(binding + 1)
            self.grow(height)
            left = Binary(operator, left, right, _joined(left.span, right.span))

    def exponent(self) -> Expression:
        self.nest()
        exponent = self.expression(_SIGN)
        self.nesting -= 1
        return exponent

    def grow(self, height: int) -> None:
        """The tree read last and one of `height` become one that is higher than both."""
        self.height = max(height, self.height) + 1
        if self.height > MAX_HEIGHT:
            raise _Slip(_too_deep(self.tokens[self.index - 1]))

    def prefixed(self, kind: str, level: int) -> Expression:
        token = self.tokens[self.index]
        if kind not in {"-", "+", "not"}:
            raise self.no_expression(token)
        if kind == "not" and level > _NOT:
            message = "put `not` and what follows it in brackets: `(not ...)`"
            raise self.slip("not-needs-brackets", message)
        self.index += 1
        self.nest()
        operand = self.expression(_NOT if kind == "not" else _SIGN)
        self.nesting -= 1
        self.grow(0)
        last = operand.span
        span = Span(token.line, token.column, last.end_line, last.end_column)
        return Unary(kind, operand, span)

    def nest(self) -> None:
        self.nesting += 1
        if self.nesting > MAX_HEIGHT:
            raise _Slip(_too_deep(self.token))

    def no_expression(self, token: Token) -> _Slip:
        before = self.tokens[self.index - 1]
        if token.kind in KEYWORDS and token.kind not in _LEVELS:
            return self.reserved(token)
        if token.kind == "=" and before.kind in _LEVELS:
            return self.slip("unexpected", f"write `{before.text}=` without a blank", token)
        if token.text in {"/", "*"} and before.text in {"/", "*"}:
            return self.slip(
                "unexpected", f"write `{before.text}{token.text}` without a blank", token
            )
        return self.unexpected(
            f"a value after `{before.text}`" if before.text.strip() else "a value"
        )

    def comparison(self, left: Expression) -> Compare:
        operators: list[str] = []
        operands = [left]
        while True:
            operator = self.kinds[self.index]
            if operator == "not" and self.kinds[self.index + 1] == "in":
                self.index += 1
                operator = "not in"
            elif _LEVELS.get(operator) != _COMPARE or operator == "not":
                break
            height = self.height
            self.index += 1
            operators.append(operator)
            operands.append(self.expression(_COMPARE + 1))
            self.height = max(height, self.height)
        self.grow(0)
        span = _joined(left.span, operands[-1].span)
        return Compare(tuple(operators), tuple(operands), span)

    def postfix(self, token: Token) -> Expression:
        value = self.skill_call(token) if token.kind == "function" else self.name(token)
        return self.indexed(value) if self.kinds[self.index] == "[" else value

    def indexed(self, value: Expression) -> Expression:
        while self.kinds[self.index] == "[":
            height = self.height
            self.index += 1
            self.nest()
            index = self.expression()
            self.nesting -= 1
            if self.kinds[self.index] == ":":
                message = "a part of a list is written `sublist(values, from, to)`"
                raise self.slip("slice", message)
            close = self.expect("]", "`]`")
            self.grow(height)
            first = value.span
            value = Index(
                value, index, Span(first.line, first.column, close.line, close.column + 1)
            )
        return value

    def name_of(self, token: Token) -> Name:
        _, text, line, column = token
        return Name(text, _new(Span, (line, column, line, column + len(text))))

    def name(self, token: Token) -> Expression:
        _, text, line, column = token
        self.index += 1
        if self.kinds[self.index] != "(":
            self.height = 1
            if self.kinds[self.index] in _AFTER_NAME:
                raise self.odd_name(token)
            return Name(text, _new(Span, (line, column, line, column + len(text))))
        arguments, keywords = self.arguments()
        close = self.tokens[self.index - 1]
        return Call(
            text, arguments, keywords, _new(Span, (line, column, close.line, close.column + 1))
        )

    def odd_name(self, token: Token) -> _Slip:
        following = self.token
        if following.kind == ".":
            return self.dotted(token, self.tokens[self.index + 1].text)
        if following.kind == "string" and token.text.lower() in {
            "f",
            "r",
            "b",
            "u",
            "rb",
            "br",
            "fr",
        }:
            message = (
                f"Block-Text has no `{token.text}` before a text: join with `+` and `str(...)`"
            )
            return self.slip("string-prefix", message, token)
        return self.unexpected("an operator")

    def skill_call(self, token: Token) -> Call | SkillCall:
        self.index += 1
        self.expect(".", "`.` and the name of a skill after `function`")
        name = self.token
        if name.kind != "name" and name.kind not in KEYWORDS:
            raise self.unexpected("the name of a skill after `function.`")
        self.index += 1
        if self.kinds[self.index] != "(":
            message = f"write `function.{name.text}()`: a call needs its brackets"
            raise self.slip("missing-brackets", message, name)
        arguments, keywords = self.arguments()
        close = self.tokens[self.index - 1]
        span = _new(Span, (token.line, token.column, close.line, close.column + 1))
        # The language's own primitive is among the robot's methods in Python: one node for both.
        node = Call if name.text == "elapsedTime" else SkillCall
        return node(name.text, arguments, keywords, span)

    def arguments(self) -> tuple[tuple[Expression, ...], tuple[Keyword, ...]]:
        opening = self.token
        self.index += 1
        if self.kinds[self.index] == ")":
            self.index += 1
            self.height = 1
            return (), ()
        self.nest()
        arguments: list[Expression] = []
        keywords: list[Keyword] = []
        height = 0
        while True:
            self.argument(arguments, keywords)
            height = max(height, self.height)
            if not self.another(opening, ")"):
                break
        self.nesting -= 1
        self.height = height
        self.grow(0)
        return tuple(arguments), tuple(keywords)

    def argument(self, arguments: list[Expression], keywords: list[Keyword]) -> None:
        token = self.tokens[self.index]
        if self.kinds[self.index + 1] == "=" and (token.kind == "name" or token.kind in KEYWORDS):
            self.index += 2
            if any(keyword.name == token.text for keyword in keywords):
                message = f"the argument `{token.text}` is given twice"
                raise self.slip("duplicate-argument", message, token)
            value = self.expression()
            last = value.span
            span = Span(token.line, token.column, last.end_line, last.end_column)
            keywords.append(Keyword(token.text, value, span))
            return
        if keywords:
            message = f"arguments without a name come before `{keywords[0].name}=`"
            raise self.slip("argument-order", message, token)
        arguments.append(self.expression())

    def another(self, opening: Token, closing: str) -> bool:
        """Whether one more value follows in a list of values; else its bracket has been closed."""
        kind = self.kinds[self.index]
        if kind == ",":
            self.index += 1
            if self.kinds[self.index] != closing:
                return True
            kind = closing
        if kind != closing:
            raise self.unclosed_bracket(opening, closing, "`,` or ")
        self.index += 1
        return False

    def unclosed_bracket(self, opening: Token, closing: str, separator: str = "") -> _Slip:
        if self.kinds[self.index] in {"newline", "comment", "eof", ":"}:
            message = f"this `{opening.text}` is not closed: write `{closing}` where it ends"
            return self.slip("unclosed-bracket", message, opening)
        return self.unexpected(f"{separator}`{closing}`")

    def parenthesized(self, token: Token) -> Expression:
        self.index += 1
        self.nest()
        value = self.expression()
        self.nesting -= 1
        if self.kinds[self.index] != ")":
            raise self.unclosed_bracket(token, ")")
        self.index += 1
        return value

    def list(self, token: Token) -> List:
        self.index += 1
        items: list[Expression] = []
        height = 0
        self.nest()
        if self.kinds[self.index] == "]":
            self.index += 1
        else:
            items.append(self.expression())
            height = self.height
            while self.another(token, "]"):
                items.append(self.expression())
                height = max(height, self.height)
        self.nesting -= 1
        self.height = height
        self.grow(0)
        close = self.tokens[self.index - 1]
        span = Span(token.line, token.column, close.line, close.column + 1)
        return List(tuple(items), span)

    def constant(self, token: Token) -> Constant:
        kind, _, line, column = token
        self.index += 1
        self.height = 1
        return Constant(_CONSTANTS[kind], _new(Span, (line, column, line, column + len(kind))))

    def number(self, token: Token) -> Number:
        _, text, line, column = token
        self.index += 1
        self.height = 1
        if not (text.isdecimal() and text[0] != "0" and len(text) < MAX_DIGITS):
            self.check_number(token)
        if self.kinds[self.index] == "name":
            self.check_unit(token, self.token)
        return Number(text, _new(Span, (line, column, line, column + len(text))))

    def check_number(self, token: Token) -> None:
        text = token.text
        if len(text) >= MAX_DIGITS:
            message = f"a number of {len(text)} digits is too long: at most {MAX_DIGITS}"
            raise self.slip("bad-number", message, token)
        if not _NUMBER.fullmatch(text):
            plain = text.lstrip("0_")
            advice = f": write `{plain}`" if text[0] == "0" and plain.isdecimal() else ""
            raise self.slip("bad-number", f"`{text}` is no number{advice}", token)

    def check_unit(self, number: Token, name: Token) -> None:
        if name.line == number.line and name.column == number.column + len(number.text):
            message = (
                f"`{number.text}{name.text}`: a name cannot begin with a digit, "
                "and a number has no unit behind it"
            )
            raise self.slip("bad-number", message, number)

    def string(self, token: Token) -> String:
        _, text, line, column = token
        self.index += 1
        self.height = 1
        if self.kinds[self.index] == "string":
            raise self.two_strings(token, self.token)
        span = _new(Span, (line, column, line, column + len(text)))
        return String(self.unquoted(token), span)

    def two_strings(self, token: Token, following: Token) -> _Slip:
        if token.text in {'""', "''"} and following.column == token.column + 2:
            message = "a text has one quote on each side; write `\\n` for a new line in it"
            return self.slip("triple-quote", message, token)
        return self.slip("unexpected", "join two texts with `+`", following)

    def unquoted(self, token: Token) -> str:
        try:
            return unquote(token.text)
        except ValueError as error:
            raise self.slip(
                "bad-escape", f"{error}; a backslash is written `\\\\`", token
            ) from None

    def raw_expression(self, token: Token) -> RawExpression:
        self.index += 1
        self.height = 1
        text = token.text[1:-1].replace("``", "`")
        span = Span(token.line, token.column, token.line, token.column + len(token.text))
        return RawExpression(text, span)


# What each kind of token begins.
_ATOMS: dict[str, Callable[[_Parser, Token], Expression]] = {
    "number": _Parser.number,
    "string": _Parser.string,
    "name": _Parser.name,
    "function": _Parser.skill_call,
    "True": _Parser.constant,
    "False": _Parser.constant,
    "None": _Parser.constant,
    "(": _Parser.parenthesized,
    "[": _Parser.list,
    "raw": _Parser.raw_expression,
}
_STARTS: dict[str, Callable[[_Parser, Token], Statement]] = {
    "name": _Parser.name_statement,
    "function": _Parser.perform,
    "if": _Parser.if_chain,
    "while": _Parser.while_loop,
    "for": _Parser.for_loop,
    "activate": _Parser.activation,
    "deactivate": _Parser.activation,
    "break": _Parser.word,
    "continue": _Parser.word,
    "pass": _Parser.word,
    "return": _Parser.return_statement,
    "python": _Parser.raw_statement,
}
_TOPS: dict[str, Callable[[_Parser, Token], Item | Main | None]] = {
    "import": _Parser.import_,
    "def": _Parser.definition,
    "when": _Parser.when,
    "main": _Parser.main,
    "end": _Parser.stray,
    "elif": _Parser.stray,
    "else": _Parser.stray,
}


class _Part(NamedTuple):
    condition: Expression | None
    comment: str | None
    body: list[Statement]
    span: Span


_Counted = tuple[Name, Expression | None, Expression | None, Expression | None, Expression | None]


def _joined(first: Span, last: Span) -> Span:
    return _new(Span, (first.line, first.column, last.end_line, last.end_column))


def _comment_text(token: Token) -> str:
    return token.text[1:].strip()


def _comment(token: Token) -> Comment:
    text = token.text
    span = Span(token.line, token.column, token.line, token.column + len(text))
    return Comment(text[1:].strip(), span)


def _arranged(items: list[Item | Main], span: Span) -> Program:
    """The program with `main` last, but the comments right above `main` still above it."""
    if any(type(item) is Setup for item in items):
        items = [item for index, item in enumerate(items) if not _says_nothing(items, index)]
    place = next((i for i, item in enumerate(items) if isinstance(item, Main)), None)
    if place is not None:
        items = _main_last(items[:place], items[place], items[place + 1 :])
    if any(type(item) is Blank for item in items):
        items = normalized(items)
    place = next((i for i, item in enumerate(items) if type(item) is Main), len(items))
    main = items[place] if place < len(items) else None
    assert main is None or isinstance(main, Main)  # noqa: S101 - for the type checker
    return Program(
        tuple(item for item in items[:place] if not isinstance(item, Main)),
        main,
        tuple(item for item in items[place:] if isinstance(item, Comment | Blank)),
        span=span,
    )


def _main_last(
    before: list[Item | Main], main: Item | Main, after: list[Item | Main]
) -> list[Item | Main]:
    ending = _notes_at_end(after)
    if len(ending) == len(after):
        return [*before, main, *after]
    above = _notes_at_end(before)
    rest = before[: len(before) - len(above)]
    return [*rest, Blank(), *after[: len(after) - len(ending)], *above, main, *ending]


def _notes_at_end(items: list[Item | Main]) -> list[Item | Main]:
    start = len(items)
    while start and isinstance(items[start - 1], Comment | Blank):
        start -= 1
    return items[start:]


def _says_nothing(items: list[Item | Main], index: int) -> bool:
    """Whether an item is a bare ``robot()``, which every program has anyway."""
    item = items[index]
    if not isinstance(item, Setup) or item.arguments or item.keywords or item.comment is not None:
        return False
    return not (index and isinstance(items[index - 1], Comment))
