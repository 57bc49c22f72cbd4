"""Find out what a bracket that is never closed was meant to contain."""

from collections.abc import Sequence

from learnblock.language.blocktext.lexer import LINE_ENDS, Token

CLOSING = {"(": ")", "[": "]", "{": "}"}
#: They begin a line that belongs to the brackets above.
_VALUES = frozenset(("number", "string", "raw", "[", "{", "(", "-", "True", "False", "None"))
#: They follow a variable in a list; after a variable that begins a statement is something else.
_AFTER_NAME = frozenset((",", "]", "}", ")", *LINE_ENDS))


def opened(tokens: Sequence[Token]) -> list[Token]:
    """The brackets among some tokens that these do not close."""
    brackets: list[Token] = []
    for token in tokens:
        if token.kind in CLOSING:
            brackets.append(token)
        elif brackets and token.kind == CLOSING[brackets[-1].kind]:
            brackets.pop()
    return brackets


def closing(brackets: Sequence[Token]) -> str:
    """What closes some brackets."""
    return "".join(CLOSING[bracket.kind] for bracket in reversed(brackets))


def end_of_values(tokens: Sequence[Token], end: int) -> int:
    """The index of the last line end of values that continue below a line.

    Args:
        tokens: the program.
        end: the index of the line end after a comma or an opening bracket.
    """
    while _goes_on(tokens, end + 1):
        end += 1
        while tokens[end].kind not in LINE_ENDS:
            end += 1
        if tokens[end - 1].kind != ",":
            break
    return end


def _goes_on(tokens: Sequence[Token], first: int) -> bool:
    if first + 1 >= len(tokens):
        return False
    kind, after = tokens[first].kind, tokens[first + 1].kind
    return kind in _VALUES or (kind == "name" and after in _AFTER_NAME)
