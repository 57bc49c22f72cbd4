"""The part of a parser that reads values in each other, down to a limit."""

from learnblock.i18n import Phrase
from learnblock.language.blocktext import open_brackets, slips
from learnblock.language.blocktext.lexer import Token, Tokens
from learnblock.language.blocktext.slips import Slip
from learnblock.language.blocktext.token_reader import TokenReader
from learnblock.language.tree.nodes import Expression

# Writing a deeper tree would overflow the stack of Python.
MAX_HEIGHT = 200
#: The level of a whole expression, whatever its operators.
LOOSEST = 0


class NestedReader(TokenReader):
    """Reads values with brackets; `height` is the height of the last tree."""

    def __init__(self, tokens: Tokens) -> None:
        super().__init__(tokens)
        self.height = 0
        self.nesting = 0  # the nesting depth of brackets

    def expression(self, level: int = LOOSEST) -> Expression:
        """Read an expression whose operators bind at least as tightly as a level."""
        raise NotImplementedError

    def nest(self) -> None:
        self.nesting += 1
        if self.nesting > MAX_HEIGHT:
            raise slips.too_deep(self.token)

    def grow(self, height: int) -> None:
        """Join the last tree and one of height `height` into a tree above both."""
        self.height = max(height, self.height) + 1
        if self.height > MAX_HEIGHT:
            raise slips.too_deep(self.before)

    def another(self, opening: Token, closing: str) -> bool:
        """Whether another value follows in a list of values; if not, read the closing bracket."""
        kind = self.kinds[self.index]
        if kind == ",":
            self.index += 1
            if self.kinds[self.index] != closing:
                return True
            kind = closing
        if kind != closing:
            raise self.unclosed_bracket(
                opening, closing, slips.next_value(self.token, self.before, closing)
            )
        self.index += 1
        return False

    def unclosed_bracket(self, opening: Token, closing: str, otherwise: Slip) -> Slip:
        kind = self.kinds[self.index]
        if kind not in {"newline", "comment", "eof", ":"}:
            return otherwise
        values = {"opening": opening.text, "closing": closing}
        message = Phrase("blocktext-unclosed-bracket", **values)
        if kind != ":" and self.before.line == opening.line:
            line, values["closing"] = self.closed_line()
            message = Phrase("blocktext-unclosed-bracket-in-line", **values, instead=line)
        return self.slip("unclosed-bracket", message, opening)

    def closed_line(self) -> tuple[str, str]:
        """The line before this token with its brackets closed, and those that were missing."""
        last = self.before
        missing = open_brackets.closing(open_brackets.opened(self.line_before()))
        written = self.lines[last.line - 1][: last.column - 1] + last.text
        return written.strip().removesuffix(",") + missing, missing

    def line_before(self) -> list[Token]:
        """The tokens of the line that ends at this token."""
        line, start = self.before.line, self.index
        while start and self.tokens[start - 1].line == line:
            start -= 1
        return self.tokens[start : self.index]
