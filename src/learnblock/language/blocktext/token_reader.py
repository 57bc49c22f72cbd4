"""The part of a parser that walks through the list of tokens."""

from functools import cached_property

from learnblock.i18n import Phrase
from learnblock.language.blocktext import slips
from learnblock.language.blocktext.lexer import LINE_END, LINE_ENDS, Token, Tokens
from learnblock.language.blocktext.slips import Slip
from learnblock.language.tree.nodes import Span

# Twice as fast as Span(...).
new = tuple.__new__


class TokenReader:
    """Reads one list of tokens; `index` is that of the next token."""

    def __init__(self, tokens: Tokens) -> None:
        self.tokens, self.kinds = tokens.tokens, tokens.kinds
        self.hoisted = tokens.hoisted
        self.diagnostics = tokens.diagnostics
        self.text = tokens.text
        self.index = 0

    @cached_property
    def lines(self) -> list[str]:
        return LINE_END.split(self.text)

    @property
    def token(self) -> Token:
        return self.tokens[self.index]

    @property
    def before(self) -> Token:
        """The previous token."""
        return self.tokens[self.index - 1]

    def report(self, code: str, message: Phrase, token: Token) -> None:
        self.diagnostics.append(slips.at(token, code, message))

    def slip(self, code: str, message: Phrase, token: Token | None = None) -> Slip:
        """A slip at a token, by default at the next one."""
        return slips.slip(token or self.token, code, message)

    def unexpected(self, wanted: Phrase) -> Slip:
        return slips.unexpected(self.token, self.before, wanted)

    def expect(self, kind: str, wanted: Phrase) -> Token:
        if self.kinds[self.index] != kind:
            raise self.unexpected(wanted)
        self.index += 1
        return self.tokens[self.index - 1]

    def skip_line(self) -> None:
        kinds, index = self.kinds, self.index
        while kinds[index] not in {"newline", "eof"}:
            index += 1
        self.index = index

    def line_ends_in_colon(self) -> bool:
        kinds, index = self.kinds, self.index
        while kinds[index] not in LINE_ENDS:
            index += 1
        return kinds[index - 1] == ":"


def from_to(start: Token, last: Token) -> Span:
    """The span from the first character of one token to the last of another on the same line."""
    _, _, line, column = start
    _, text, end_line, end_column = last
    return new(Span, (line, column, end_line, end_column + len(text)))
