"""The part of a parser that rewrites a line from another language in place, and reports it."""

from collections.abc import Collection, Iterable
from functools import cached_property

from learnblock.errors import Diagnostic
from learnblock.language.blocktext import declarations
from learnblock.language.blocktext.expression_parser import ExpressionParser
from learnblock.language.blocktext.foreign_lines import NAME_WITH_SPACE, RULES
from learnblock.language.blocktext.lexer import LINE_ENDS, Token, Tokens, tokenize
from learnblock.language.blocktext.line_rules import Rewording, Rule, reworded
from learnblock.language.blocktext.python_lines import CASES

#: At most this many lines are compared with known slips; a pupil reads only the first messages.
MAX_COMPARED = 200
#: The blocks that have local variables.
_FUNCTIONS = frozenset(("def", "when"))


def is_in_function(openers: Iterable[Token]) -> bool:
    """Whether open blocks are in a function or a ``when``, which has local variables.

    Args:
        openers: the first tokens of the open blocks.
    """
    return any(opener.kind in _FUNCTIONS for opener in openers)


def is_in_match(openers: Iterable[Token]) -> bool:
    """Whether open blocks are in a ``match`` of Python.

    Args:
        openers: the first tokens of the open blocks.
    """
    return any(opener.text.startswith(("`match", "`case")) for opener in openers)


class LineRewriter(ExpressionParser):
    """Replaces the tokens of a line that resembles a known slip, and reports the slip."""

    def __init__(self, tokens: Tokens) -> None:
        super().__init__(tokens)
        self.rewritten: dict[int, str] = {}  # what the lines should be, by their number
        self.compared = 0

    def line_start(self) -> int:
        """The index of the first token of this line."""
        index = self.index
        while index and self.kinds[index - 1] not in LINE_ENDS | {"blank", "python"}:
            index -= 1
        return index

    def rewrite_line(self, openers: Collection[Token]) -> bool:
        """Rewrite this line, if it resembles a known slip and has no other statement.

        Args:
            openers: the first tokens of the open blocks.
        """
        number = self.token.line
        if self.compared >= MAX_COMPARED or any(opener.line == number for opener in openers):
            return False
        start, end = self.line_start(), self.line_end_index()
        if any(token.line != number for token in self.tokens[start:end]):
            return False
        self.compared += 1
        inside = is_in_function(openers)
        declared = declarations.IN_FUNCTIONS if inside else declarations.OUTSIDE
        cases = CASES if is_in_match(openers) else ()
        rules = (*self.spaced_names, *declared, *cases, *RULES)
        rewording = reworded(self.code_of(number, end), rules)
        if rewording is None:
            return False
        if number not in self.rewritten:
            self.diagnostics.append(_diagnostic(rewording, number))
        self.rewritten[number] = rewording.line
        self.replace(start, end, _tokens_of(rewording.line, number))
        # The new line may be shorter than the part that was read of the old one.
        self.index = start
        return True

    @cached_property
    def spaced_names(self) -> tuple[Rule, ...]:
        """Rules for the names of two words that lines of the program set."""
        names: dict[tuple[str, str], None] = {}
        for line in self.lines:
            match = NAME_WITH_SPACE.match(line)
            rewording = reworded(line, (*declarations.OUTSIDE, *RULES)) if match else None
            if match and rewording and rewording.message.code == NAME_WITH_SPACE.code:
                names[match[2], match[3]] = None
        return tuple(
            NAME_WITH_SPACE._replace(
                pattern=rf".*?\b(?P<wrong>({first})\s+({second}))\b", instead=r"\2_\3"
            )
            for first, second in names
        )

    def line_end_index(self) -> int:
        index = self.index
        while self.kinds[index] not in LINE_ENDS:
            index += 1
        return index

    def code_of(self, number: int, end: int) -> str:
        """A line without its comment, as it was rewritten last."""
        if number in self.rewritten:
            return self.rewritten[number]
        line = self.lines[number - 1]
        return line[: self.tokens[end].column - 1] if self.kinds[end] == "comment" else line

    def replace(self, start: int, end: int, tokens: list[Token]) -> None:
        self.tokens[start:end] = tokens
        self.kinds[start:end] = [token.kind for token in tokens]
        shift = len(tokens) - (end - start)
        moved = {(at + shift if at >= end else at): line for at, line in self.hoisted.items()}
        self.hoisted.clear()
        self.hoisted.update(moved)


def _tokens_of(line: str, number: int) -> list[Token]:
    """The tokens of a line, without its end."""
    read = tokenize(line).tokens
    return [token._replace(line=number) for token in read if token.kind not in {"newline", "eof"}]


def _diagnostic(rewording: Rewording, number: int) -> Diagnostic:
    start, end = rewording.start + 1, rewording.end + 1
    return Diagnostic("not-block-text", rewording.message, number, start, end)
