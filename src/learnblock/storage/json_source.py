"""JSON that a person wrote: its value, and the position of each part, for messages."""

import json
import re
from bisect import bisect_right
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import accumulate, pairwise
from typing import NoReturn

from learnblock.errors import BlockConfigurationError, Diagnostic
from learnblock.i18n import Phrase

#: The keys and indices that lead to a part of a value.
Path = tuple[str | int, ...]

#: The limit in characters; the configurations of all built-in blocks together have a fifth of it.
LARGEST = 250_000
#: The limit of nested brackets: a configuration needs five, and a list as a default a few more.
DEEPEST = 16

# An unclosed string extends to the end of the text, so that reading always takes linear time.
_TOKEN = re.compile(r'"(?:[^"\\]|\\.)*"?|[][{}:,]|[^\s"\][{}:,]+', re.DOTALL)
_NO_NUMBERS = frozenset({"NaN", "Infinity", "-Infinity"})
_OPENING, _CLOSING = frozenset("[{"), frozenset("]}")

#: Python's own messages in terms of a configuration.
_SLIPS = {
    "Expecting ',' delimiter": "json-missing-comma",
    "Expecting ':' delimiter": "json-missing-colon",
    "Expecting property name enclosed in double quotes": "json-missing-key",
    "Expecting value": "json-missing-value",
    "Unterminated string starting at": "json-missing-quote",
    "Extra data": "json-several-values",
    "Invalid \\escape": "json-backslash",
    "Invalid \\uXXXX escape": "json-unicode-escape",
}


@dataclass(frozen=True, slots=True)
class TextPosition:
    """A position in the text; line and column are counted from 1."""

    line: int = 0
    column: int = 0
    end_column: int = 0


@dataclass(frozen=True, slots=True)
class JsonDocument:
    """The value of a JSON text, and the positions of its parts.

    Args:
        value: as `json.loads` returns it.
        values: the position of each value.
        keys: the position of each object's key, by the path of its value.
        repeated: duplicate keys of an object, with the position of the later one.
    """

    value: object
    values: Mapping[Path, TextPosition] = field(default_factory=dict)
    keys: Mapping[Path, TextPosition] = field(default_factory=dict)
    repeated: tuple[tuple[str, TextPosition], ...] = ()


@dataclass(frozen=True, slots=True)
class _Token:
    text: str
    start: int

    @property
    def is_string(self) -> bool:
        return self.text.startswith('"')


def parse(text: str, filename: str) -> JsonDocument:
    """Read JSON; a text that starts with a key is read as an object without its braces.

    Line breaks inside strings are allowed, as in the paper's example.

    Raises:
        BlockConfigurationError: the text is not JSON, or is too large or too deeply nested.
    """
    return _Source(text, filename).document()


class _Source:
    def __init__(self, text: str, filename: str) -> None:
        self._text = text
        self._filename = filename
        lines = text.splitlines(keepends=True)
        self._line_starts = list(accumulate(map(len, lines), initial=0))

    def document(self) -> JsonDocument:
        if len(self._text) > LARGEST:
            self._refuse("too-large", Phrase("json-too-large", size=len(self._text), limit=LARGEST))
        tokens = [_Token(match[0], match.start()) for match in _TOKEN.finditer(self._text)]
        if not tokens:
            self._refuse("empty", Phrase("json-empty"))
        self._check_depth(tokens)
        self._check_tokens(tokens)
        braceless = _is_braceless(tokens)
        value = self._value(tokens, braceless=braceless)
        self._check_characters(value)
        return self._located(value, tokens, braceless=braceless)

    def _check_depth(self, tokens: Sequence[_Token]) -> None:
        depth = 0
        for token in tokens:
            depth += (token.text in _OPENING) - (token.text in _CLOSING)
            if depth > DEEPEST:
                self._refuse("too-deep", Phrase("json-too-deep", limit=DEEPEST), token)

    def _check_tokens(self, tokens: Sequence[_Token]) -> None:
        """Find mistakes that `json` accepts, or locates differently in different Pythons."""
        for token, behind in pairwise(tokens):
            if token.text == "," and behind.text in _CLOSING:
                self._refuse("not-json", Phrase("json-extra-comma", bracket=behind.text), token)
        for token in tokens:
            if token.text in _NO_NUMBERS:
                self._refuse("not-json", Phrase("json-not-a-number", text=token.text), token)

    def _check_characters(self, value: object) -> None:
        for text in _strings(value):
            if _is_half_a_character(text):
                self._refuse("not-json", Phrase("json-half-character", text=repr(text)))

    def _value(self, tokens: Sequence[_Token], *, braceless: bool) -> object:
        text = f"{{{self._text}}}" if braceless else self._text
        try:
            return json.loads(text, strict=False)
        except json.JSONDecodeError as error:
            self._refuse_syntax(error.msg, min(error.pos - braceless, len(self._text)), tokens)
        except ValueError:
            # Python refuses to convert thousands of digits.
            self._refuse("not-json", Phrase("json-too-many-digits"))

    def _refuse_syntax(self, slip: str, at: int, tokens: Sequence[_Token]) -> NoReturn:
        before = [token for token in tokens if token.start < at]
        if before and before[-1].is_string and "\n" in before[-1].text:
            self._refuse("not-json", Phrase("json-text-over-lines"), at=before[-1].start)
        code = _SLIPS.get(slip)
        self._refuse(
            "not-json", Phrase(code) if code else Phrase("json-broken", reason=slip), at=at
        )

    def _located(self, value: object, tokens: Sequence[_Token], *, braceless: bool) -> JsonDocument:
        walk = _Walk(braceless=braceless)
        for token in tokens:
            walk.step(token)
        return JsonDocument(
            value,
            {path: self._place(token) for path, token in walk.values.items()},
            {path: self._place(token) for path, token in walk.keys.items()},
            tuple((name, self._place(token)) for name, token in walk.repeated),
        )

    def _place(self, token: _Token) -> TextPosition:
        place = self._place_at(token.start)
        return TextPosition(place.line, place.column, place.column + len(token.text))

    def _place_at(self, offset: int) -> TextPosition:
        last = max(len(self._line_starts) - 2, 0)
        line = min(bisect_right(self._line_starts, offset) - 1, last)
        column = offset - self._line_starts[line] + 1
        return TextPosition(line + 1, column, column + 1)

    def _refuse(
        self, code: str, message: Phrase, token: _Token | None = None, at: int | None = None
    ) -> NoReturn:
        place = TextPosition()
        if token is not None:
            place = self._place(token)
        elif at is not None:
            place = self._place_at(at)
        diagnostic = Diagnostic(code, message, place.line, place.column, place.end_column)
        # A file that is too large is not shown, so it needs no caret.
        source = self._text if len(self._text) <= LARGEST else ""
        raise BlockConfigurationError(self._filename, [diagnostic], source)


class _Walk:
    """Goes through the tokens of correct JSON and records the path of each."""

    def __init__(self, *, braceless: bool) -> None:
        self.values: dict[Path, _Token] = {}
        self.keys: dict[Path, _Token] = {}
        self.repeated: list[tuple[str, _Token]] = []
        self._brackets: list[str] = []
        self._path: list[str | int] = []
        self._previous = ""
        if braceless:
            self._open("{")
            self._previous = "{"

    def step(self, token: _Token) -> None:
        text = token.text
        if text in _CLOSING:
            self._brackets.pop()
            self._path.pop()
        elif text == ",":
            self._next()
        elif token.is_string and self._expects_key():
            self._key(token)
        elif text != ":":
            self.values[tuple(self._path)] = token
            if text in _OPENING:
                self._open(text)
        self._previous = text

    def _open(self, bracket: str) -> None:
        self._brackets.append(bracket)
        self._path.append(0 if bracket == "[" else "")

    def _next(self) -> None:
        last = self._path[-1]
        if isinstance(last, int):
            self._path[-1] = last + 1

    def _expects_key(self) -> bool:
        return bool(self._brackets) and self._brackets[-1] == "{" and self._previous in {"{", ","}

    def _key(self, token: _Token) -> None:
        name = str(json.loads(token.text, strict=False))
        self._path[-1] = name
        path = tuple(self._path)
        if path in self.keys:
            self.repeated.append((name, token))
        self.keys[path] = token


def _is_braceless(tokens: Sequence[_Token]) -> bool:
    return len(tokens) > 1 and tokens[0].is_string and tokens[1].text == ":"


def _strings(value: object) -> Iterator[str]:
    """Every string in a JSON value, keys included."""
    if isinstance(value, str):
        yield value
    elif isinstance(value, list):
        for item in value:
            yield from _strings(item)
    elif isinstance(value, dict):
        for key, item in value.items():
            yield key
            yield from _strings(item)


def _is_half_a_character(text: str) -> bool:
    return any("\ud800" <= character <= "\udfff" for character in text)
