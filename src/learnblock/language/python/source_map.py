"""The mapping between the lines of generated Python and those of the program."""

from dataclasses import dataclass
from typing import Any


@dataclass(frozen=True, slots=True)
class SourceMap:
    """The mapping between the lines of a Python text and those of the program.

    Args:
        source_lines: for each line of Python, the line of the source, from 1; 0 for none.
        nodes: for each line of Python, the statement or item it belongs to, or None.
    """

    source_lines: tuple[int, ...] = ()
    nodes: tuple[Any, ...] = ()

    def source_line(self, python_line: int) -> int | None:
        """The line of the source for a line of Python, both from 1; None if there is none."""
        if not 1 <= python_line <= len(self.source_lines):
            return None
        return self.source_lines[python_line - 1] or None

    def python_line(self, source_line: int) -> int | None:
        """The first line of Python that was generated from a line of the source, both from 1."""
        if source_line < 1 or source_line not in self.source_lines:
            return None
        return self.source_lines.index(source_line) + 1

    def node(self, python_line: int) -> Any:
        """The statement or item of the tree that a line of Python, from 1, belongs to, or None."""
        return self.nodes[python_line - 1] if 1 <= python_line <= len(self.nodes) else None
