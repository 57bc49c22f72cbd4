"""Write programs as text, line by line: the part that Block-Text and Python share."""

from collections.abc import Callable, Sequence
from typing import Any, ClassVar

from learnblock.language.tree.expression_writer import ExpressionWriter
from learnblock.language.tree.extents import Extent
from learnblock.language.tree.layout import placed
from learnblock.language.tree.nodes import (
    Activate,
    Assign,
    Blank,
    Body,
    Break,
    Comment,
    Continue,
    Deactivate,
    Def,
    Expression,
    ForEach,
    ForRange,
    If,
    Import,
    Item,
    Main,
    Node,
    Pass,
    Perform,
    PythonBlock,
    PythonLine,
    Raw,
    Repeat,
    Return,
    Setup,
    WaitUntil,
    When,
    While,
    WithoutRobot,
)

_WRITERS: dict[type[Item | Main], str] = {
    Comment: "comment",
    Blank: "blank",
    Perform: "perform",
    Assign: "assign",
    If: "if_chain",
    While: "while_loop",
    Repeat: "repeat",
    ForEach: "for_each",
    ForRange: "for_range",
    WaitUntil: "wait_until",
    Break: "word",
    Continue: "word",
    Pass: "word",
    Return: "return_",
    Activate: "activation",
    Deactivate: "activation",
    Raw: "raw_block",
    PythonLine: "python_line",
    PythonBlock: "python_block",
    WithoutRobot: "without_robot",
    Import: "import_",
    Setup: "setup",
    Def: "definition",
    When: "when",
    Main: "main",
}


def comment_text(text: str) -> str:
    """A comment's text with its ``#``."""
    if not text:
        return "#"
    return f"#{text}" if text[0] in "#!:" else f"# {text}"


class ProgramWriter(ExpressionWriter):
    """Writes items and statements; a subclass has a method for each one in its notation."""

    items: ClassVar[dict[type[Item | Main], Callable[[Any, Any], None]]] = {}

    def __init_subclass__(cls) -> None:
        super().__init_subclass__()
        cls.items = {kind: getattr(cls, name) for kind, name in _WRITERS.items()}

    def __init__(self) -> None:
        self.lines: list[str] = []
        self.indent = ""
        self.extents: dict[int, Extent] = {}

    def item(self, item: Item | Main) -> None:
        first = len(self.lines) + 1
        self.items[type(item)](self, item)
        self.extents[id(item)] = (first, len(self.lines))

    def in_order(self, items: Sequence[Item | Main]) -> None:
        """Write items of the top level, with the blank lines between them."""
        for item, apart, blank, _ in placed(items):
            if apart or blank:
                self.blank()
            self.item(item)

    def line(self, text: str, node: Node | None = None, comment: str | None = None) -> None:
        """Write one line, which belongs to `node`."""
        raise NotImplementedError

    def blank(self, _: Blank | None = None) -> None:
        raise NotImplementedError

    def block(self, header: str, body: Body, node: Node, comment: str | None) -> None:
        self.line(header + ":", node, comment)
        outer, self.indent = self.indent, self.indent + "    "
        for statement in body or (Pass(),):
            self.item(statement)
        self.indent = outer

    def closed(self, header: str, node: Any) -> None:
        """Write a block, and what closes it."""
        self.block(header, node.body, node, node.comment)
        self.close()

    def close(self) -> None:
        """Write the end of a block, if the notation has one."""

    def comment(self, node: Comment) -> None:
        self.line(comment_text(node.text), node)

    def perform(self, node: Perform) -> None:
        self.line(self.expression(node.call), node, node.comment)

    def assign(self, node: Assign) -> None:
        target = self.expression(node.target)
        self.line(f"{target} {node.operator} {self.expression(node.value)}", node, node.comment)

    def if_chain(self, node: If) -> None:
        word = "if"
        for branch in node.branches:
            condition = self.expression(branch.condition)
            self.block(f"{word} {condition}", branch.body, branch, branch.comment)
            word = "elif"
        if node.otherwise is not None:
            part = node.otherwise
            self.block("else", part.body, part, part.comment)
        self.close()

    def while_loop(self, node: While) -> None:
        self.closed(f"while {self.expression(node.condition)}", node)

    def for_each(self, node: ForEach) -> None:
        targets = ", ".join(map(self.expression, node.targets))
        header = f"for {targets} in {self.looped(node.values)}"
        self.closed(header, node)

    def looped(self, values: Expression) -> str:
        """What a loop goes through."""
        return self.expression(values)

    def word(self, node: Break | Continue | Pass) -> None:
        self.line(type(node).__name__.lower(), node, node.comment)

    def return_(self, node: Return) -> None:
        value = "" if node.value is None else " " + self.expression(node.value)
        self.line(f"return{value}", node, node.comment)

    def repeat(self, node: Repeat) -> None:
        raise NotImplementedError

    def for_range(self, node: ForRange) -> None:
        raise NotImplementedError

    def wait_until(self, node: WaitUntil) -> None:
        raise NotImplementedError

    def activation(self, node: Activate | Deactivate) -> None:
        raise NotImplementedError

    def raw_block(self, node: Raw) -> None:
        raise NotImplementedError

    def python_line(self, node: PythonLine) -> None:
        self.line(self.python(node.text), node, node.comment)

    def python_block(self, node: PythonBlock) -> None:
        parts, outer = node.parts, self.indent
        if node.has_cases:
            self.line(self.python(parts[0].header) + ":", parts[0], parts[0].comment)
            self.indent, parts = outer + "    ", parts[1:]
        for part in parts:
            self.block(self.python(part.header), part.body, part, part.comment)
        self.indent = outer
        self.close()

    def python(self, text: str) -> str:
        """Python in the notation."""
        return text

    def without_robot(self, node: WithoutRobot) -> None:
        raise NotImplementedError

    def import_(self, node: Import) -> None:
        raise NotImplementedError

    def setup(self, node: Setup) -> None:
        raise NotImplementedError

    def definition(self, node: Def) -> None:
        raise NotImplementedError

    def when(self, node: When) -> None:
        raise NotImplementedError

    def main(self, node: Main) -> None:
        raise NotImplementedError
