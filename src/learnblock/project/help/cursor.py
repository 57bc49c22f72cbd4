"""The text around a cursor position, even in a program with syntax errors."""

import re
from dataclasses import dataclass, field
from functools import cached_property

from learnblock.language.tree.identifiers import IDENTIFIER, MARKS

_TOKEN = re.compile(
    r"""
    (?P<text>"(?:[^"\\]|\\.)*(?:"|$)|'(?:[^'\\]|\\.)*(?:'|$)|`[^`]*(?:`|$))
    |(?P<comment>\#.*)
    |(?P<name>IDENTIFIER(?:\s*\.\s*IDENTIFIER)*)
    |(?P<sign>[=!<>]=|\S)
    """.replace("IDENTIFIER", IDENTIFIER),
    re.VERBOSE,
)
#: The end of an unfinished f-string, from the value that is open.
_OPEN_VALUE = re.compile(r"(?<!\{)(?:\{\{)*\{([^{}]*)$")
_OPENING, _CLOSING = frozenset("([{"), frozenset(")]}")
_TYPED = re.compile(rf"{IDENTIFIER}$")
_DOTTED = re.compile(rf"({IDENTIFIER})\s*\.\s*$")
_REST = re.compile(rf"[\w{MARKS}]*")
_ARGUMENT = re.compile(r"\s*=(?!=)")


@dataclass
class OpenCall:
    """A call whose bracket is still open at the cursor.

    Args:
        name: the name of the called function with its prefix; empty for another kind of bracket.
        start: the column where the name begins, from 0.
        keywords: the names of the keyword arguments before the cursor.
        commas: the number of arguments before the cursor.
    """

    name: str
    start: int = 0
    keywords: set[str] = field(default_factory=set)
    commas: int = 0


@dataclass(frozen=True)
class Cursor:
    """A cursor position in a line.

    Args:
        before: the line before the cursor.
        after: the rest of the line.
    """

    before: str
    after: str

    @classmethod
    def at(cls, text: str, line: int, column: int) -> "Cursor":
        """The cursor at a line and column, from 1; after the end, that of the last line."""
        lines = text.split("\n")
        line_text = lines[min(max(line, 1), len(lines)) - 1]
        before = line_text[: max(column - 1, 0)]
        return cls(_in_value(before), line_text[len(before) :])

    @property
    def typed(self) -> str:
        """The part of a word directly before the cursor."""
        match = _TYPED.search(self.before)
        return match[0] if match else ""

    @property
    def word(self) -> str:
        """The word at the cursor."""
        rest = _REST.match(self.after)
        return self.typed + (rest[0] if rest and (self.typed or not rest[0][:1].isdigit()) else "")

    @property
    def start(self) -> int:
        """The column where the word begins, from 0."""
        return len(self.before) - len(self.typed)

    @property
    def behind(self) -> str:
        """The text after the word."""
        return (self.before + self.after)[self.start + len(self.word) :]

    @cached_property
    def owner(self) -> str:
        """The name before the dot before the word, or ""."""
        match = _DOTTED.search(self.before[: self.start])
        return match[1] if match else ""

    @property
    def begins_line(self) -> bool:
        """Whether there is nothing before the word."""
        return not self.before[: self.start].strip()

    @property
    def word_before(self) -> str:
        """The previous word, if only blanks are in between."""
        match = _TYPED.search(self.before[: self.start].rstrip())
        return match[0] if match else ""

    @property
    def is_argument_name(self) -> bool:
        """Whether the word is the name of an argument."""
        return self.call is not None and _ARGUMENT.match(self.behind) is not None

    @cached_property
    def is_in_text(self) -> bool:
        """Whether the cursor is in a comment, or in an unfinished string or raw Python."""
        tokens = [*_TOKEN.finditer(self.before)]
        if not tokens or tokens[-1].end() < len(self.before):
            return False
        last = tokens[-1]
        is_closed = len(last[0]) > 1 and last[0][-1] == last[0][0]
        return last.lastgroup == "comment" or (last.lastgroup == "text" and not is_closed)

    @cached_property
    def call(self) -> OpenCall | None:
        """The innermost call whose arguments are being written, if any."""
        opened = _open_calls(self.before)
        return opened[-1] if opened and opened[-1].name else None


def _in_value(before: str) -> str:
    """`before`, without the f-string around the value that the cursor is in, if it is in one.

    An open bracket takes its place, so that columns stay the same.
    """
    tokens = [*_TOKEN.finditer(before)][-2:]
    if len(tokens) < 2 or tokens[0][0] not in {"f", "F"} or tokens[1]["text"] is None:
        return before
    text = tokens[1]
    is_closed = len(text[0]) > 1 and text[0][-1] == text[0][0]
    value = None if is_closed or text.start() > tokens[0].end() else _OPEN_VALUE.search(text[0])
    if value is None:
        return before
    start = text.start() + value.start(1)
    return " " * (start - 1) + "(" + before[start:]


def _open_calls(before: str) -> list[OpenCall]:
    opened: list[OpenCall] = []
    name: re.Match[str] | None = None
    for token in _TOKEN.finditer(before):
        sign = token["sign"]
        if sign in _OPENING:
            called = name if sign == "(" else None
            opened.append(OpenCall(_plain(called[0]), called.start()) if called else OpenCall(""))
        elif sign in _CLOSING:
            del opened[-1:]
        elif opened and sign == ",":
            opened[-1].commas += 1
        elif opened and sign == "=" and name is not None:
            opened[-1].keywords.add(name[0])
        name = token if token.lastgroup == "name" else None
    return opened


def _plain(dotted: str) -> str:
    return re.sub(r"\s", "", dotted)
