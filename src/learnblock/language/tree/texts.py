"""Text with values in it: the parts of an f-string, and how its text is written."""

import re
from collections.abc import Iterable

from learnblock.language.tree.identifiers import IDENTIFIER
from learnblock.language.tree.nodes import (
    Binary,
    Call,
    Dictionary,
    Expression,
    FString,
    RawExpression,
    Span,
    String,
)
from learnblock.language.tree.strings import escaped, unquote
from learnblock.language.tree.traversal import within

#: Text that can be written in single quotes without an escape.
_UNESCAPED = re.compile(r"[^'\"\\]*")
#: A brace that is written twice; the braces of an escape are not.
_BRACES = re.compile(r"\\N\{[^}]*\}|\\.|(\{)\{|(\})\}")
_DOTTED = re.compile(rf"{IDENTIFIER}(?:\.{IDENTIFIER})*")


def is_plain(value: Expression) -> bool:
    """Whether a value can be written between the braces of an f-string.

    Up to Python 3.11 it may contain neither a backslash nor the quotes of the f-string.
    """
    return all(map(_is_plain, within(value)))


def f_string(parts: Iterable[Expression], span: Span) -> FString | None:
    """An f-string of texts and values in any order; None if a value is not plain."""
    joined: list[Expression] = []
    for part in _flattened(parts):
        before = joined[-1] if joined else None
        if isinstance(part, String) and isinstance(before, String):
            joined[-1] = String(before.value + part.value, before.span)
        elif part != String(""):
            joined.append(part)
    if all(isinstance(part, String) or is_plain(part) for part in joined):
        return FString(tuple(joined), span)
    return None


def added(parts: Iterable[Expression], span: Span) -> Expression:
    """The sum that is equal to an f-string with values that are not plain."""
    texts = [part if isinstance(part, String | FString) else Call("str", (part,)) for part in parts]
    result: Expression = texts[0] if texts else String("")
    for text in texts[1:]:
        result = Binary("+", result, text, span)
    return result


def written(text: str) -> str:
    """The text between the braces of an f-string in double quotes."""
    return escaped(text, '"').replace("{", "{{").replace("}", "}}")


def read(written: str) -> str:
    """The text that `written` returned, or that an author wrote with other escapes.

    Raises:
        EscapeError: an escape does not name a character.
    """
    single = _BRACES.sub(lambda match: match[1] or match[2] or match[0], written)
    return unquote(f'"{single}"')


def _flattened(parts: Iterable[Expression]) -> Iterable[Expression]:
    for part in parts:
        if isinstance(part, FString):
            yield from part.parts
        else:
            yield part


def _is_plain(node: Expression) -> bool:
    match node:
        case String(value=value):
            return value.isprintable() and _UNESCAPED.fullmatch(value) is not None
        case RawExpression(text=text):
            return _DOTTED.fullmatch(text) is not None
    return not isinstance(node, FString | Dictionary)
