"""Split Block-Text into tokens, in one pass with one compiled pattern."""

import re
from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import NamedTuple

from learnblock.errors import Diagnostic
from learnblock.i18n import Phrase
from learnblock.language.tree.identifiers import IDENTIFIER, normal

KEYWORDS = frozenset(
    [
        "True",
        "False",
        "None",
        "and",
        "or",
        "not",
        "in",
        "if",
        "elif",
        "else",
        "while",
        "for",
        "break",
        "continue",
        "return",
        "pass",
        "def",
        "import",
        "main",
        "when",
        "end",
        "activate",
        "deactivate",
        "function",
    ]
)

# One of these at the beginning of a line begins a statement, even if a bracket is still open.
_OPENS_LINE = KEYWORDS - {"True", "False", "None", "and", "or", "not", "in", "function"}

_ASSIGNING = frozenset(("=", "+=", "-=", "*=", "/=", "//=", "%=", "**="))
_COMPARING = frozenset(("==", "!=", "<", "<=", ">", ">="))
_FIXED = KEYWORDS | _ASSIGNING | _COMPARING | frozenset("+-*/%()[]{},:.") | {"**", "//"}
_OPENING, _CLOSING = frozenset("([{"), frozenset(")]}")
#: A brace after one of these begins a dictionary, even at the end of its line.
_BEFORE_VALUE = (
    _ASSIGNING | _COMPARING | frozenset("+-*/%([{,") | {"//", "**", "in", "not", "and", "or"}
)
#: A brace after one of these begins a dictionary, but at the end of its line a block as in C.
_BEFORE_CONDITION = frozenset(("if", "elif", "else", "while", "return"))
#: The same for words that are names elsewhere.
_SOFT_WORDS = frozenset(("repeat", "until", "from", "to", "step"))

# White space; a token, unless the text ends here; or an invalid character.
_TOKEN = re.compile(
    r"""([ \t\f\xa0]*+)(?:
    (
        [fF](?:"(?:[^"\\\n\r]|\\[^\n\r])*"|'(?:[^'\\\n\r]|\\[^\n\r])*')
        |IDENTIFIER
        |\*\*=|//=|\*\*|//|[-+*/%=!<>]=|[-+*/%<>=()\[\]{},:]|\.(?![0-9])
        |(?:\r?\n|\r)(?:[ \t\f\xa0]*(?:\r?\n|\r))*
        |0[xXbBoO]\w*|(?:[0-9][0-9_]*\.?[0-9_]*|\.[0-9][0-9_]*)(?:[eE][-+]?[0-9][0-9_]*)?
        |"(?:[^"\\\n\r]|\\[^\n\r])*"|'(?:[^'\\\n\r]|\\[^\n\r])*'
        |\#[^\n\r]*
        |`(?:[^`\n\r]|``)+`
    )
    |(["'`][^\n\r]*|[^ \t\f\xa0])
    |\Z
    )""".replace("IDENTIFIER", IDENTIFIER),
    re.VERBOSE,
)
# The kind of a token that is neither a keyword nor an operator, by its first character.
_KINDS = {
    "\n": "newline",
    "\r": "newline",
    '"': "string",
    "'": "string",
    "#": "comment",
    "`": "raw",
    **dict.fromkeys(".0123456789", "number"),
}

_QUOTES = frozenset("\"'")
#: In an f-string: text up to a brace, and a value up to the brace that closes it.
_F_TEXT = re.compile(r"(?:[^{}\\]|\\N\{[^}]*\}|\\.|\{\{|\}\})*")
_F_VALUE = re.compile(r"(?:[^{}'\"`]|'[^']*'|\"[^\"]*\"|`[^`]*`|\{[^{}]*\})*\}")

_BRACES = frozenset("{}")

_RAW_START = re.compile(r"^([ \t]*)python[ \t]*:[ \t]*(#[^\n]*?)?\r?$", re.MULTILINE)
_RAW_END = re.compile(r"^[ \t]*end\b[ \t]*(?:#[^\n]*)?\r?$", re.MULTILINE)
_AT_LINE_END = re.compile(r"[ \t]*(?:#[^\n]*)?$", re.MULTILINE)
#: A line with a colon, except in its strings and comment.
_HEADER = re.compile(r"""(?:[^\n\r"'#:]|"(?:[^"\\\n\r]|\\.)*"|'(?:[^'\\\n\r]|\\.)*')*:""")
_ARGUMENT = re.compile(r"[ \t]*=(?!=)")
LINE_END = re.compile(r"\r?\n|\r")
#: The kinds of the tokens that end a line.
LINE_ENDS = frozenset(("newline", "comment"))
_FORBIDDEN = re.compile("[\x00\ud800-\udfff]")

MAX_CHARACTERS = 2_000_000


class Token(NamedTuple):
    """One token.

    Args:
        kind: a keyword or operator is its own kind; else name, number, string, raw, comment,
            newline, blank (lines), python (a raw block), bad or eof. An f-string is ``f-string`` up
            to its first value, the tokens of the value, ``f-part`` up to the next one, and so on.
        text: as written; names in their NFKC form.
        line: the line, from 1.
        column: the column, from 1.
    """

    kind: str
    text: str
    line: int
    column: int


@dataclass(slots=True)
class Tokens:
    """The tokens of a file, in order.

    Args:
        tokens: ends with a ``newline`` and an ``eof``.
        kinds: the kind of each token.
        hoisted: comments inside brackets, by the index of the first token of their statement.
        diagnostics: invalid characters.
        text: the text that was read, with plain line ends.
    """

    tokens: list[Token] = field(default_factory=list)
    kinds: list[str] = field(default_factory=list)
    hoisted: dict[int, list[Token]] = field(default_factory=dict)
    diagnostics: list[Diagnostic] = field(default_factory=list)
    text: str = ""


def tokenize(text: str) -> Tokens:
    """The tokens of a program in Block-Text. Never raises."""
    if problem := _unreadable(text):
        return _nothing(problem)
    return _Lexer(_plain_line_ends(text).removeprefix("\ufeff")).run()


def too_long(text: str) -> Phrase:
    """The message about a program with more than `MAX_CHARACTERS`."""
    return Phrase("blocktext-too-long", characters=len(text), limit=MAX_CHARACTERS)


def _unreadable(text: str) -> Diagnostic | None:
    if len(text) > MAX_CHARACTERS:
        return Diagnostic("too-long", too_long(text))
    if text.isascii() and "\0" not in text:
        return None
    forbidden = _FORBIDDEN.search(text)
    if forbidden is None:
        return None
    line = text.count("\n", 0, forbidden.start()) + 1
    column = forbidden.start() - text.rfind("\n", 0, forbidden.start())
    message = Phrase("blocktext-forbidden-character", number=f"U+{ord(forbidden[0]):04X}")
    return Diagnostic("bad-character", message, line, column, column + 1)


def _nothing(problem: Diagnostic) -> Tokens:
    end = [Token("newline", "", 1, 1), Token("eof", "", 1, 1)]
    return Tokens(end, ["newline", "eof"], diagnostics=[problem])


def _plain_line_ends(text: str) -> str:
    """Replace the line ends of Windows and of old Macs by line feeds.

    A file with mixed line ends is not changed: they may belong to raw Python, which is kept.
    """
    if "\r" not in text:
        return text
    if text.count("\r\n") == text.count("\n") == text.count("\r"):
        return text.replace("\r\n", "\n")
    return text if "\n" in text else text.replace("\r", "\n")


def _foreign_name(text: str) -> tuple[str, str]:
    """The kind and text of a name with letters beyond ASCII."""
    name = normal(text)
    if name is None:
        return "bad", text
    return (name if name in KEYWORDS else "name"), name


def _f_string(text: str, line: int, column: int) -> Iterator[Token]:
    """The tokens of an f-string, whose values are read like any other."""
    kind, start, end = "f-string", 0, len(text) - 1
    while True:
        plain = _F_TEXT.match(text, max(start, 2) if start < 2 else start + 1, end)
        after = len(text) if plain is None or plain.end() >= end else plain.end() + 1
        closes = None if after > end else _F_VALUE.match(text, after, end)
        if after <= end and (text[after - 1] == "}" or closes is None):
            yield Token("f-bad", text[start:], line, column + start)
            return
        yield Token(kind, text[start:after], line, column + start)
        if closes is None:
            return
        start = closes.end() - 1
        yield from _f_value(text, after, start, line, column)
        kind = "f-part"


def _f_value(text: str, start: int, end: int, line: int, column: int) -> Iterator[Token]:
    for match in _TOKEN.finditer(text, start, end):
        known, bad = match[2], match[3]
        if known is None and bad is None:
            return
        written, at = known or bad, column + match.start(2 if known else 3)
        kind = written if written in _FIXED else _KINDS.get(written[0], "name")
        if bad or kind in LINE_ENDS:
            yield Token("bad", written, line, at)
        elif kind == "name" and written[-1] in _QUOTES:
            yield from _f_string(written, line, at)
        elif kind == "name" and not written.isascii():
            yield Token(*_foreign_name(written), line, at)
        else:
            yield Token(kind, written, line, at)


class _Lexer:
    def __init__(self, text: str) -> None:
        self.text = text
        self.result = Tokens(text=text)
        self.line, self.line_start = 1, 0
        self.depth = 0  # the number of open brackets
        self.braces = 0  # how many of them are braces
        self.soft: list[tuple[int, Token]] = []  # line ends inside brackets, with their index
        self.statement = 0  # index of the first token of the logical line

    def run(self) -> Tokens:
        position = 0
        if "python" in self.text:
            while start := _RAW_START.search(self.text, position):
                self.scan(position, start.start())
                position = self.raw_block(start)
        self.scan(position, len(self.text))
        self.finish()
        return self.result

    def scan(self, position: int, end: int) -> None:  # noqa: C901, PLR0912 - the hot loop
        tokens = self.result.tokens
        add = tokens.append
        new = tuple.__new__  # twice as fast as Token(...)
        line, line_start, depth = self.line, self.line_start, self.depth
        for white, known, bad in _TOKEN.findall(self.text, position, end):
            text = known or bad
            if not text:
                break
            position += len(white)
            column = position - line_start + 1
            position += len(text)
            if known in _FIXED:
                kind = text
                if kind in _BRACES and not self.is_of_dictionary(kind, depth, position):
                    kind = "bad"
                elif kind in _OPENING:
                    depth += 1
                elif depth:
                    if kind in _CLOSING:
                        depth -= 1
                        if not depth:
                            self.soft.clear()
                            self.braces = 0
                    elif (
                        self.soft and kind in _OPENS_LINE and self.begins_statement(kind, position)
                    ):
                        # The bracket was never closed: a statement begins here.
                        self.restore_line_ends()
                        depth = self.braces = 0
            elif bad:
                kind = "bad"
            else:
                kind = _KINDS.get(text[0], "name")
                if kind == "name":
                    if text[-1] in _QUOTES:
                        tokens += _f_string(text, line, column)
                        continue
                    if not text.isascii():
                        kind, text = _foreign_name(text)
                elif kind == "newline":
                    line += self.line_break(text, line, column, soft=depth > 0)
                    line_start = position
                    continue
                elif depth and kind == "comment":
                    comment = Token(kind, text, line, column)
                    self.result.hoisted.setdefault(self.statement, []).append(comment)
                    continue
            add(new(Token, (kind, text, line, column)))
        self.line, self.line_start, self.depth = line, line_start, depth

    def is_of_dictionary(self, brace: str, depth: int, after: int) -> bool:
        """Whether a brace is one of a dictionary, and not of a block as in C."""
        if brace == "}":
            is_open = self.braces > 0
            self.braces -= is_open
        else:
            is_open = self.begins_value(depth, after)
            self.braces += is_open
        return is_open

    def begins_value(self, depth: int, after: int) -> bool:
        if not self.result.tokens:
            return False
        kind, text, _, _ = self.result.tokens[-1]
        if kind in _BEFORE_VALUE or (kind == ":" and depth > 0):
            return True
        may_begin = kind in _BEFORE_CONDITION or (kind == "name" and text in _SOFT_WORDS)
        return may_begin and (depth > 0 or not _AT_LINE_END.match(self.text, after))

    def line_break(self, text: str, line: int, column: int, *, soft: bool) -> int:
        """Add a line end, or record one inside brackets; return the number of lines."""
        tokens = self.result.tokens
        token = Token("newline", "\n", line, column)
        lines = 1 if text == "\n" else len(LINE_END.findall(text))
        if soft:
            self.soft.append((len(tokens), token))
            return lines
        tokens.append(token)
        if lines > 1:
            tokens.append(Token("blank", "", line + lines - 1, 1))
        self.statement = len(tokens)
        return lines

    def begins_statement(self, kind: str, after: int) -> bool:
        """Whether a keyword that ends at `after` begins its line and is not an argument's name.

        ``end`` can also begin a line as an argument name: ``print("a",`` and ``end="")`` below. A
        value such as ``x if y else z`` may go on with ``if`` or ``else``, without a colon.
        """
        if self.soft[-1][0] != len(self.result.tokens) or _ARGUMENT.match(self.text, after):
            return False
        return kind not in {"if", "else"} or _HEADER.match(self.text, after) is not None

    def restore_line_ends(self) -> None:
        """Put back the line ends that were skipped after a bracket that is never closed."""
        tokens = self.result.tokens
        first = self.soft[0][0]
        tail, tokens[first:] = tokens[first:], []
        for (start, line_end), end in zip(
            self.soft, [*(index for index, _ in self.soft[1:]), first + len(tail)], strict=True
        ):
            tokens.append(line_end)
            tokens.extend(tail[start - first : end - first])
        self.soft.clear()
        self.statement = len(tokens)

    def raw_block(self, start: re.Match[str]) -> int:
        """Keep everything up to the block's ``end`` as one token; return the position after it."""
        if self.depth:
            if self.soft:
                self.restore_line_ends()
            self.depth = 0
        column = len(start[1]) + 1
        if start[2]:
            self.add("comment", start[2], start.start(2) - start.start() + 1)
            self.add("newline", "\n", start.end() - start.start() + 1)
        end = _RAW_END.search(self.text, start.end())
        close = len(self.text) if end is None else end.start()
        body = self.text[min(start.end() + 1, close) : close]
        self.add("python", body, column)
        self.line += body.count("\n") + 1
        if end is None:
            message = Phrase("blocktext-python-without-end")
            self.result.diagnostics.append(
                Diagnostic("missing-end", message, self.result.tokens[-1].line, column, column + 6)
            )
            return close
        self.line_start = close
        after = self.text.index("end", close) + 3
        self.add("end", "end", after - 2 - close)
        return after

    def add(self, kind: str, text: str, column: int) -> None:
        self.result.tokens.append(Token(kind, text, self.line, column))

    def finish(self) -> None:
        if self.depth and self.soft:
            self.restore_line_ends()
        column = len(self.text) - self.line_start + 1
        self.add("newline", "", column)
        self.add("eof", "", column)
        self.result.kinds = [token[0] for token in self.result.tokens]
