"""A program to run: its Python, and the mapping to the text its author wrote."""

import ast
import hashlib
import re
from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property

from learnblock.language.python.source_map import SourceMap

_ROBOT_IMPORT = re.compile(r"^from [\w.]+ import Robot\b", re.MULTILINE)


@dataclass(frozen=True)
class Program:
    """A program to run.

    Args:
        name: its file name, such as ``square.bt``.
        python: the Python that is run.
        written: the source as its author wrote it, in either notation.
        source_map: from lines of `python` to lines of `written`; None where both are the same.
        folder: where its modules are imported from; "" for nowhere.
        tags: the numbers of tags, by name, that it uses instead of the user's.
    """

    name: str
    python: str
    written: str
    source_map: SourceMap | None = None
    folder: str = ""
    tags: Mapping[str, int] = field(default_factory=dict)

    @cached_property
    def identity(self) -> str:
        """A hash of the program itself, independent of its name, notation and robot."""
        neutral = _ROBOT_IMPORT.sub("from robot import Robot", self.python)
        return hashlib.sha256(neutral.encode("utf-8", "surrogatepass")).hexdigest()

    @cached_property
    def names(self) -> tuple[str, ...]:
        """Every attribute it uses, including skills; none if it cannot be parsed."""
        try:
            tree = ast.parse(self.python)
        except (SyntaxError, ValueError, RecursionError, MemoryError):
            return ()
        found = {node.attr for node in ast.walk(tree) if isinstance(node, ast.Attribute)}
        return tuple(sorted(found))

    def written_line(self, python_line: int) -> int:
        """The author's line that became `python_line`; 0 if there is none."""
        if self.source_map is None:
            return python_line
        return self.source_map.source_line(python_line) or 0

    def quote(self, line: int) -> str:
        """The text of one of the author's lines; "" if there is none."""
        lines = self.written.splitlines()
        return lines[line - 1].strip() if 1 <= line <= len(lines) else ""
