"""Python that stays Python as blocks: its words, and sockets for the values between them.

The tree has only its text; blocks split it at its values, and join it again with what is in the
sockets.
"""

from collections.abc import Iterable, Mapping, Sequence

from learnblock.language.python.expression_reader import ExpressionReader
from learnblock.language.python.forms import (
    Split,
    SplitLine,
    filled,
    header_form,
    line_form,
    value_form,
)
from learnblock.language.python.writer import PythonWriter
from learnblock.language.tree import markers
from learnblock.language.tree.nodes import (
    Body,
    Expression,
    Program,
    PythonBlock,
    PythonLine,
    Raw,
    RawExpression,
)
from learnblock.language.workspace.block_reader import MAX_INPUTS
from learnblock.language.workspace.notes import NO_NOTES, Notes

#: The types of the blocks: a value, a line, a statement with statements in it, a docstring.
VALUE, LINE, BLOCK, TEXT = "lb_python_form", "lb_python_line", "lb_python_block", "lb_python_text"


class Sockets:
    """Turns the values in Python's text into trees, whose nodes live as long as this object."""

    def __init__(self, program: Program) -> None:
        whens = PythonWriter(program, frozenset()).whens
        self.whens = {python: plain for plain, python in whens.items()}
        self.functions = frozenset(program.functions)
        # In a program without a robot, the name may be that of something else.
        self.robot = None if program.is_without_robot else ExpressionReader.robot
        self.kept: list[Expression] = []

    def values(self, text: str, form: SplitLine) -> list[Expression]:
        """The values of a form of `text`."""
        reader = ExpressionReader([text.strip()], self.whens, self.functions)
        reader.robot = self.robot
        expressions = [reader.expression(value) for value in form.values]
        self.kept += expressions
        return expressions


def python_parts(
    sockets: Sockets, node: RawExpression | PythonLine
) -> tuple[SplitLine, list[Expression]] | None:
    """The words and values of an expression or a line; None if it is one grey block."""
    form = (line_form if isinstance(node, PythonLine) else value_form)(node.text)
    return None if form is None else (form, sockets.values(node.text, form))


def block_parts(
    sockets: Sockets, node: PythonBlock
) -> tuple[list[list[str]], list[Expression], list[Body]]:
    """The words of each first line of a block, the values of all of them, and the bodies."""
    words: list[list[str]] = []
    values: list[Expression] = []
    for part in node.parts:
        form = header_form(part.header)
        words.append(list(form.words))
        values += sockets.values(part.header, form)
    return words, values, [part.body for part in node.parts]


def raw_type(node: Raw) -> tuple[str, Notes]:
    """The type of the block of raw Python, and its notes."""
    if markers.is_long_text(node.text):
        return TEXT, NO_NOTES
    return "lb_python", NO_NOTES if node.text.endswith("\n") else Notes(unfinished=True)


def words_in(state: object) -> list[str]:
    """The words in the extra state of a block, of which anything may be wrong."""
    words = state if isinstance(state, list) else []
    return [" ".join(word.split("\n")) for word in words[:MAX_INPUTS] if isinstance(word, str)]


class Joiner:
    """Joins the words and values of blocks to Python, with the names that the program defines."""

    def __init__(self, program: Program) -> None:
        self.writer = PythonWriter(program, frozenset())
        self.sockets = Sockets(program)

    def kept(
        self, spelled: str, words: Sequence[str], values: Sequence[Expression], split: Split
    ) -> str:
        """The line as its author wrote it; joined again if its words or values have changed."""
        form = split(spelled) if spelled else None
        same = form is not None and form.words == tuple(words)
        if form is not None and same and self.sockets.values(spelled, form) == list(values):
            return spelled
        return self.joined(words, values, split)

    def joined(self, words: Sequence[str], values: Iterable[Expression], split: Split) -> str:
        """The line of Python."""
        return filled(words, [self.writer.expression(value) for value in values], split)


SPLITS: Mapping[str, Split] = {
    VALUE: value_form,
    LINE: line_form,
    BLOCK: header_form,
}
