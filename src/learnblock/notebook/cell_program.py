"""The cells of a kernel as one program, whose steps are noted."""

import ast
import re
from bisect import bisect_right
from dataclasses import dataclass

from msgspec.structs import replace

from learnblock.language.python.robot_import import robot_import
from learnblock.notebook.cell_source import CellPart
from learnblock.runtime.log.instrumenting import NOTING, instrument
from learnblock.runtime.log.nodes import Kind, Node
from learnblock.runtime.program import Program

#: What the program of a kernel is called.
_NAME = "notebook"
_CREATION = re.compile(r"^robot[ \t]*=[ \t]*Robot\(", re.MULTILINE)


@dataclass(frozen=True, slots=True)
class _Cell:
    """A cell that has run.

    Args:
        number: that of its prompt.
        before: how many lines the cells before it have.
        above: how many lines of the cell come before its program, such as that of a magic.
    """

    number: int
    before: int
    above: int


class CellProgram:
    """All cells that have run since a robot was made, in their order.

    A cell that runs again is there again: it may be another one by now.

    Attributes:
        nodes: what it notes.
        robot_module: the module of its robot; empty before there is one.
    """

    def __init__(self) -> None:
        self.nodes: list[Node] = []
        self.robot_module = ""
        # The first line is kept free for the import of the robot.
        self._lines = [""]
        self._cells: list[_Cell] = []

    def add(self, part: CellPart, number: int) -> ast.Module:
        """Add what a cell runs, and return its code, which also notes its steps.

        Args:
            part: its Python.
            number: that of the cell's prompt.

        Raises:
            SyntaxError: it is not Python.
            ValueError: it has a null character.
            RecursionError: it is nested too deeply.
        """
        functions = (node.name for node in self.nodes if node.kind is Kind.FUNCTION)
        cell = instrument(part.source, functions)
        nodes, lines = len(self.nodes), len(self._lines)
        _renumber(cell.tree, nodes)
        self._cells.append(_Cell(number, lines, part.above))
        self.nodes += [_moved(node, nodes, lines) for node in cell.nodes]
        self._lines += part.source.removesuffix("\n").split("\n")
        return cell.tree

    @property
    def program(self) -> Program:
        """The cells as one program."""
        text = "\n".join([*self._lines, ""])
        # The cell that imports it may have run before those of this program. Without its import,
        # a robot that they make would be any value, and its skills no blocks.
        if _CREATION.search(text) and not robot_import(text):
            text = f"from {self.robot_module} import Robot{text}"
        return Program(_NAME, text, text)

    def place(self, line: int) -> tuple[int, int]:
        """The number of the cell that a line of the program is in, and the line there."""
        index = bisect_right([cell.before for cell in self._cells], line - 1) - 1
        cell = self._cells[index]
        return cell.number, line - cell.before + cell.above


def _renumber(tree: ast.Module, nodes: int) -> None:
    """Put the numbers in the noting calls of a cell behind those of the cells before it."""
    for call in ast.walk(tree):
        match call:
            case ast.Call(ast.Name(name), [ast.Constant(int(value)) as number, *_]) if (
                name in NOTING
            ):
                number.value = value + nodes


def _moved(node: Node, nodes: int, lines: int) -> Node:
    """A node behind so many nodes and lines of other cells."""
    return replace(
        node,
        line=node.line + lines,
        end=node.end + lines,
        last=node.last + nodes,
        control=_behind(node.control, nodes),
        function=_behind(node.function, nodes),
        first=node.first + lines if node.first else 0,
    )


def _behind(number: int, nodes: int) -> int:
    return number + nodes if number >= 0 else number
