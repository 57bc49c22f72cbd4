"""Parse text with values in it: ``f"score: {score}"``."""

from learnblock.errors import EscapeError
from learnblock.i18n import Phrase
from learnblock.language.blocktext.lexer import Token
from learnblock.language.blocktext.nested_reader import NestedReader
from learnblock.language.blocktext.slips import Slip
from learnblock.language.tree import texts
from learnblock.language.tree.nodes import Expression, FString, Span, String


def f_string(parser: NestedReader, token: Token) -> FString:
    """Read an f-string: its text, and the values between its braces."""
    parts: list[Expression] = []
    height, piece, text = 0, token, token.text[2:]
    while True:
        parser.index += 1
        parts.append(String(_plain(parser, piece, text[:-1]), _span(piece, piece)))
        if text[-1] != "{":
            break
        parts.append(_value(parser))
        height = max(height, parser.height)
        piece = parser.token
        text = piece.text[1:]
    parser.height = height
    parser.grow(0)
    joined = texts.f_string(parts, _span(token, piece))
    if joined is None:
        raise parser.slip("text-value", Phrase("blocktext-f-string-value"), token)
    return joined


def bad_f_string(parser: NestedReader, token: Token) -> FString:
    """Report an f-string with a brace that is never closed, or closes nothing."""
    quote, rest = token.text[-1], parser.lines[token.line - 1][token.column :]
    code = "blocktext-f-string-brace"
    if quote in rest[len(token.text) - 1 :]:
        code = "blocktext-f-string-quotes"
    raise parser.slip("text-value", Phrase(code), token)


def _value(parser: NestedReader) -> Expression:
    """Read a value, up to the token with which the text goes on."""
    if parser.kinds[parser.index] == "f-part":
        raise parser.slip("text-value", Phrase("blocktext-f-string-brace"))
    parser.nest()
    value = parser.expression()
    parser.nesting -= 1
    if parser.kinds[parser.index] != "f-part":
        raise _no_part(parser)
    return value


def _no_part(parser: NestedReader) -> Slip:
    if parser.token.text in {":", "=", "!"}:
        return parser.slip("text-value", Phrase("blocktext-f-string-format"))
    return parser.unexpected(Phrase("blocktext-token", text="}"))


def _plain(parser: NestedReader, token: Token, text: str) -> str:
    try:
        return texts.read(text)
    except EscapeError as error:
        raise parser.slip("bad-escape", error.phrase, token) from None


def _span(start: Token, last: Token) -> Span:
    return Span(start.line, start.column, last.line, last.column + len(last.text))
