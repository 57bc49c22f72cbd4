"""Parse dictionaries: ``{"Ana": 1, "Luis": 2}``."""

from learnblock.i18n import Phrase
from learnblock.language.blocktext.lexer import Token
from learnblock.language.blocktext.nested_reader import NestedReader
from learnblock.language.blocktext.slips import Slip
from learnblock.language.tree.nodes import Dictionary, Expression, Span


def dictionary(parser: NestedReader, token: Token) -> Dictionary:
    """Read a dictionary."""
    parser.index += 1
    parser.nest()
    entries: list[tuple[Expression, Expression]] = []
    height = 0
    if parser.kinds[parser.index] == "}":
        parser.index += 1
    else:
        is_open = True
        while is_open:
            entry, entry_height = _entry(parser, token)
            entries.append(entry)
            height = max(height, entry_height)
            is_open = parser.another(token, "}")
    parser.nesting -= 1
    parser.height = height
    parser.grow(0)
    close = parser.before
    span = Span(token.line, token.column, close.line, close.column + 1)
    return Dictionary(tuple(key for key, _ in entries), tuple(value for _, value in entries), span)


def _entry(parser: NestedReader, opening: Token) -> tuple[tuple[Expression, Expression], int]:
    """Read a key and its value, with the height of the larger one."""
    key = parser.expression()
    height = parser.height
    if parser.kinds[parser.index] != ":":
        raise _no_colon(parser, opening)
    parser.index += 1
    value = parser.expression()
    return (key, value), max(height, parser.height)


def _no_colon(parser: NestedReader, opening: Token) -> Slip:
    kind = parser.kinds[parser.index]
    if kind == "=":
        return parser.slip("unexpected", Phrase("blocktext-entry-equals"))
    if kind in {",", "}"}:
        return parser.slip("unexpected", Phrase("blocktext-entry-without-value"))
    return parser.unclosed_bracket(
        opening, "}", parser.unexpected(Phrase("blocktext-token", text=":"))
    )
