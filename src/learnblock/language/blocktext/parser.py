"""Parse Block-Text into a tree: recursive descent by hand, with recovery after errors.

This module reads the top level; statements, expressions and slips have their own modules.
"""

import re
import unicodedata
from collections.abc import Callable, Sequence
from operator import attrgetter

from learnblock.errors import Diagnostic, ProgramError
from learnblock.i18n import Phrase
from learnblock.language.blocktext import slips
from learnblock.language.blocktext.lexer import LINE_ENDS, Token, tokenize
from learnblock.language.blocktext.order import definitions_first
from learnblock.language.blocktext.slips import Slip
from learnblock.language.blocktext.statement_parser import ASSIGNMENTS, StatementParser
from learnblock.language.blocktext.token_reader import from_to
from learnblock.language.tree.identifiers import IDENTIFIER
from learnblock.language.tree.layout import normalized
from learnblock.language.tree.nodes import (
    Blank,
    Comment,
    Def,
    Expression,
    Import,
    Item,
    Main,
    Program,
    Raw,
    Setup,
    Span,
    When,
    WithoutRobot,
)

MAX_DIAGNOSTICS = 100

MODULE = re.compile(rf"{IDENTIFIER}(?:\.{IDENTIFIER})*")


def parse(text: str, filename: str = "program.bt") -> Program:
    """Read a program in Block-Text.

    Raises:
        ProgramError: the program is invalid; it lists every error in the file.
    """
    program, diagnostics = recover(text)
    if diagnostics:
        raise ProgramError(filename, diagnostics, text)
    return program


def recover(text: str) -> tuple[Program, tuple[Diagnostic, ...]]:
    """Read as much of a program in Block-Text as possible, with its diagnostics. Never raises."""
    parser = _Parser(tokenize(text))
    try:
        program = parser.program()
    except RecursionError:
        # Our limits are far below Python's: this happens only if the caller has used up the stack.
        return Program(), (slips.too_deep(parser.token).diagnostic,)
    diagnostics = sorted(parser.diagnostics, key=attrgetter("line", "column"))
    return program, tuple(dict.fromkeys(diagnostics))[:MAX_DIAGNOSTICS]


# Why: docs/decisions.md, "The parser is written by hand"
class _Parser(StatementParser):
    """Reads the top level of a program."""

    def program(self) -> Program:
        items: list[Item | Main] = []
        while self.kinds[self.index] != "eof":
            if not self.note(items):
                self.item(items, self.token)
        return _arranged(items, Span(1, 1, self.token.line, self.token.column))

    def item(self, items: list[Item | Main], token: Token) -> None:
        """Read one item of the top level and add it to `items`."""
        read = _TOPS.get(token.kind, _Parser.statement)
        if token.text == "robot" and self.sets_up(items):
            read = _Parser.setup
        elif token.text == "without" and self.tokens[self.index + 1].text == "robot":
            read = _Parser.without_robot
        try:
            if token.kind in _TOPS and self.kinds[self.index + 1] in ASSIGNMENTS:
                raise slips.reserved(token)
            item = read(self, token)
        except Slip as slip:
            self.leave(slip)
            return
        if isinstance(item, Main) and any(isinstance(other, Main) for other in items):
            self.report("second-main", Phrase("blocktext-second-main"), token)
        elif item is not None:
            items.append(item)

    def sets_up(self, items: list[Item | Main]) -> bool:
        return self.kinds[self.index + 1] == "(" and all(
            isinstance(item, Comment | Blank | Import) for item in items
        )

    def main(self, token: Token) -> Main:
        self.index += 1
        _, comment = self.header(token, lambda: None, None)
        body = self.block(token)
        if comment is not None:
            body = (Comment(comment, Span(token.line, token.column)), *body)
        return Main(body, self.line_span(token))

    def import_(self, token: Token) -> Import:
        self.index += 1
        name = self.expect("string", Phrase("blocktext-wanted-library"))
        # Normalized as Python does, like all other names.
        module = unicodedata.normalize("NFKC", self.unquoted(name))
        if not MODULE.fullmatch(module):
            hint = module.replace("\\", "/").rpartition("/")[2].removesuffix(".py")
            example = hint if MODULE.fullmatch(hint) else "dance"
            message = Phrase("blocktext-import-name", example=example)
            raise self.slip("import-name", message, name)
        return Import(module, *self.line_end(token))

    def definition(self, token: Token) -> Def:
        self.index += 1
        nothing: tuple[str, tuple[str, ...]] = ("_", ())
        (name, parameters), comment = self.header(token, self.signature, nothing)
        return Def(name, parameters, self.block(token), comment, self.line_span(token))

    def signature(self) -> tuple[str, tuple[str, ...]]:
        name = self.expect("name", Phrase("blocktext-wanted-function-name")).text
        self.expect("(", Phrase("blocktext-wanted-parameters", name=name))
        parameters: list[str] = []
        while self.kinds[self.index] != ")":
            if self.kinds[self.index] in {*LINE_ENDS, ":"}:
                raise self.unclosed_parameters()
            if parameters:
                self.expect(",", Phrase("blocktext-wanted-either", first=",", second=")"))
            token = self.expect("name", Phrase("blocktext-wanted-parameter"))
            if token.text in parameters:
                message = Phrase("blocktext-duplicate-parameter", name=token.text)
                raise self.slip("duplicate-parameter", message, token)
            parameters.append(token.text)
        self.index += 1
        return name, tuple(parameters)

    def unclosed_parameters(self) -> Slip:
        if self.kinds[self.index] == ":":
            colon = self.token.column - 1
            line = self.lines[self.token.line - 1]
            message = Phrase(
                "blocktext-unclosed-bracket-before-colon",
                instead=f"{line[:colon]}){line[colon:]}".strip(),
            )
            return self.slip("unclosed-bracket", message)
        written, closing = self.closed_line()
        values = {"opening": "(", "closing": f"{closing}:", "instead": f"{written}:"}
        return self.slip("unclosed-bracket", Phrase("blocktext-unclosed-bracket-in-line", **values))

    def when(self, token: Token) -> When:
        self.index += 1
        nothing: tuple[str, Expression | None] = ("_", None)
        (name, condition), comment = self.header(token, self.event, nothing)
        return When(name, condition, self.block(token), comment, self.line_span(token))

    def event(self) -> tuple[str, Expression | None]:
        name = self.expect("name", Phrase("blocktext-wanted-when-name")).text
        if self.kinds[self.index] != "=":
            return name, None
        self.index += 1
        return name, self.expression()

    def without_robot(self, token: Token) -> WithoutRobot:
        self.index += 2
        if self.kinds[self.index] not in LINE_ENDS:
            raise self.more_on_line(self.kinds[self.index])
        # A comment behind it becomes the next line: Python has no line for it.
        return WithoutRobot(from_to(token, self.before))

    def setup(self, token: Token) -> Setup:
        self.index += 1
        arguments, keywords = self.arguments()
        return Setup(arguments, keywords, *self.line_end(token))


_TOPS: dict[str, Callable[[_Parser, Token], Item | Main | None]] = {
    "import": _Parser.import_,
    "def": _Parser.definition,
    "when": _Parser.when,
    "main": _Parser.main,
    "end": _Parser.stray,
    "elif": _Parser.stray,
    "else": _Parser.stray,
}


def _arranged(items: list[Item | Main], span: Span) -> Program:
    """The program with definitions before their uses and `main` last.

    The comments directly above `main` stay above it.
    """
    kinds = [type(item) for item in items]
    if WithoutRobot in kinds:
        items = without_robot_first(items)
    if Setup in kinds:
        items = _without_plain_setup(items)
    if Def in kinds or When in kinds:
        items = definitions_first(items)
    if Main in kinds:
        items = _main_last(items)
    if Blank in map(type, items):
        items = normalized(items)
    for place, item in enumerate(items):
        if isinstance(item, Main):
            ending = tuple(note for note in items[place:] if isinstance(note, Comment | Blank))
            return Program(_without_main(items[:place]), item, ending, span=span)
    return Program(_without_main(items), span=span)


def without_robot_first(items: Sequence[Item | Main]) -> list[Item | Main]:
    """The items with the first of the lines that say that there is no robot at their head."""
    lines = [item for item in items if isinstance(item, WithoutRobot)]
    return [*lines[:1], *(item for item in items if not isinstance(item, WithoutRobot))]


def _without_main(items: list[Item | Main]) -> tuple[Item, ...]:
    return tuple([item for item in items if not isinstance(item, Main)])


def _main_last(items: list[Item | Main]) -> list[Item | Main]:
    place = next(index for index, item in enumerate(items) if isinstance(item, Main))
    before, main, after = items[:place], items[place], items[place + 1 :]
    ending = _notes_at_end(after)
    if len(ending) == len(after):
        return items
    above = _notes_at_end(before)
    rest = before[: len(before) - len(above)]
    return [*rest, Blank(), *after[: len(after) - len(ending)], *above, main, *ending]


def _notes_at_end(items: list[Item | Main]) -> list[Item | Main]:
    start = len(items)
    while start and isinstance(items[start - 1], Comment | Blank):
        start -= 1
    return items[start:]


def _without_plain_setup(items: list[Item | Main]) -> list[Item | Main]:
    plain = [item for index, item in enumerate(items) if not _says_nothing(items, index)]
    # A single block of raw Python is a whole file; only `robot()` makes it part of a program.
    statements_read = [item for item in plain if not isinstance(item, Blank)]
    return items if len(statements_read) == 1 and isinstance(statements_read[0], Raw) else plain


def _says_nothing(items: list[Item | Main], index: int) -> bool:
    """Whether an item is a plain ``robot()``, which every program implies."""
    item = items[index]
    if not isinstance(item, Setup) or item.arguments or item.keywords or item.comment is not None:
        return False
    return not (index and isinstance(items[index - 1], Comment))
