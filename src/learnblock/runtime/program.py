"""A program to run: its Python, and the mapping to the text its author wrote."""

import ast
import hashlib
from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property

from learnblock.client.keyboard import KEYS, Key
from learnblock.language.python.robot_import import for_any_robot
from learnblock.language.python.source_map import SourceMap

#: The skill that asks whether a key is held down.
KEY_SKILL = "is_key_pressed"


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
        dead_ends: the lines of loops that it never leaves, at which its run may end.
    """

    name: str
    python: str
    written: str
    source_map: SourceMap | None = None
    folder: str = ""
    tags: Mapping[str, int] = field(default_factory=dict)
    dead_ends: tuple[int, ...] = ()

    @cached_property
    def identity(self) -> str:
        """A hash of the program as Python reads it, independent of its name, notation and robot."""
        neutral = for_any_robot(_as_read(self.python))
        return hashlib.sha256(neutral.encode("utf-8", "surrogatepass")).hexdigest()

    @cached_property
    def names(self) -> tuple[str, ...]:
        """Every attribute it uses, including skills; none if it cannot be parsed."""
        attributes = {node.attr for node in self._nodes if isinstance(node, ast.Attribute)}
        return tuple(sorted(attributes))

    @property
    def keys(self) -> tuple[Key, ...]:
        """The keys it asks for; every key if its text does not tell which."""
        calls = (node for node in self._nodes if isinstance(node, ast.Call))
        keys = {_asked_key(call) for call in calls if _is_for_key(call)}
        return tuple(key for key in KEYS if key in keys or None in keys or not keys)

    @cached_property
    def _nodes(self) -> tuple[ast.AST, ...]:
        try:
            return tuple(ast.walk(ast.parse(self.python)))
        except (SyntaxError, ValueError, RecursionError, MemoryError):
            return ()

    def written_line(self, python_line: int) -> int:
        """The author's line that became `python_line`; 0 if there is none."""
        if self.source_map is None:
            return python_line
        return self.source_map.source_line(python_line) or 0

    def python_line(self, written_line: int) -> int:
        """The first line of Python that became of the author's line; 0 if there is none."""
        if self.source_map is None:
            return written_line
        return self.source_map.python_line(written_line) or 0

    def quote(self, line: int) -> str:
        """The text of one of the author's lines; "" if there is none."""
        lines = self.written.splitlines()
        return lines[line - 1].strip() if 1 <= line <= len(lines) else ""


def _is_for_key(call: ast.Call) -> bool:
    return isinstance(call.func, ast.Attribute) and call.func.attr == KEY_SKILL


def _as_read(text: str) -> str:
    """A program without differences that Python does not see: line ends and those of the file."""
    lines = text.removeprefix("\ufeff").replace("\r\n", "\n").replace("\r", "\n")
    return lines.rstrip("\n") + "\n"


def _asked_key(call: ast.Call) -> object:
    """The key in a call of the skill; None if only the running program knows it."""
    arguments = [*call.args, *(keyword.value for keyword in call.keywords)]
    if not arguments:
        return "space"
    return arguments[0].value if isinstance(arguments[0], ast.Constant) else None
