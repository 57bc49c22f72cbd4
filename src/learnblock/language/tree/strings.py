"""String literals of Block-Text: conversion between the literal and its content."""

import re

from learnblock.errors import EscapeError

_ESCAPE = re.compile(
    r"\\(?:([0-7]{1,3})|x([0-9a-fA-F]{2})|u([0-9a-fA-F]{4})|U([0-9a-fA-F]{8})|N\{([^}]*)\}|(.))",
    re.DOTALL,
)
_SIMPLE = {
    "\\": "\\",
    "'": "'",
    '"': '"',
    "a": "\a",
    "b": "\b",
    "f": "\f",
    "n": "\n",
    "r": "\r",
    "t": "\t",
    "v": "\v",
}
_SPELLED = {"\\": "\\\\", "\n": "\\n", "\r": "\\r", "\t": "\\t"}
_PLAIN = re.compile(r"[ -!#-\[\]-~]*")


def unquote(literal: str) -> str:
    """The content of a string literal, with the escapes of Python.

    Raises:
        EscapeError: an escape does not name a character.
    """
    body = literal[1:-1]
    return _ESCAPE.sub(_meant, body) if "\\" in body else body


def quote(value: str) -> str:
    """A string literal for `value`, in double quotes unless that needs more escapes."""
    if _PLAIN.fullmatch(value):
        return f'"{value}"'
    mark = "'" if value.count('"') > value.count("'") else '"'
    return mark + escaped(value, mark) + mark


def escaped(value: str, mark: str) -> str:
    """The characters of a string literal between its quotes."""
    return "".join(_written(character, mark) for character in value)


def _meant(match: re.Match[str]) -> str:
    octal, *hexadecimal, name, simple = match.groups()
    if octal:
        return chr(int(octal, 8))
    if name is not None:
        return _named(name)
    digits = next(filter(None, hexadecimal), None)
    if digits:
        return _numbered(digits)
    if simple in {"x", "u", "U", "N"}:
        raise EscapeError("blocktext-escape-without-number", escape="\\" + simple)
    return _SIMPLE.get(simple, "\\" + simple)


def _numbered(digits: str) -> str:
    number = int(digits, 16)
    if number > 0x10FFFF:
        raise EscapeError("blocktext-no-character-number", number=digits)
    return chr(number)


def _named(name: str) -> str:
    import unicodedata  # noqa: PLC0415 - large, and few programs name a character

    try:
        return unicodedata.lookup(name)
    except KeyError:
        raise EscapeError("blocktext-no-character-name", name=name) from None


def _written(character: str, mark: str) -> str:
    if character == mark:
        return "\\" + character
    if character in _SPELLED:
        return _SPELLED[character]
    if character.isprintable():
        return character
    number = ord(character)
    if number < 0x100:
        return f"\\x{number:02x}"
    return f"\\u{number:04x}" if number < 0x10000 else f"\\U{number:08x}"
