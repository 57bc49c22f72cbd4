"""Numbers the places of a program while it is instrumented."""

import ast
from collections.abc import Iterator
from contextlib import contextmanager

from msgspec.structs import replace

from learnblock.runtime.log.nodes import Kind, Node
from learnblock.runtime.log.snapshots import LONGEST

#: What has a place in the text.
Placed = ast.stmt | ast.expr | ast.ExceptHandler


class Numbering:
    """The nodes of a program in the order in which they begin, each with what it is in.

    Args:
        source: the program's Python.
    """

    def __init__(self, source: str) -> None:
        self.numbered: list[Node] = []
        self._lines = source.encode("utf-8", "surrogatepass").splitlines()
        self._control, self._branch, self._function = -1, True, -1

    def begin(self, node: Placed, kind: Kind, *, at: Placed | None = None, **more: object) -> int:
        """Number a node; `end` says later what it contains.

        Args:
            node: the node.
            kind: what it is.
            at: where it begins, if not at its own first line.
            more: further fields of `Node`.
        """
        first = (at or node).lineno
        number = len(self.numbered)
        self.numbered.append(
            Node(
                kind,
                line=first,
                end=node.end_lineno or first,
                text=self._text(node),
                last=number,
                control=self._control,
                branch=self._branch,
                function=self._function,
                **more,  # type: ignore[arg-type] # the names of the fields
            )
        )
        return number

    def end(self, number: int, line: int | None = None) -> None:
        """End a node with the last one that has begun, at a line if it isn't its own last one."""
        node = self.numbered[number]
        self.change(number, last=len(self.numbered) - 1, end=line or node.end)

    def change(self, number: int, **more: object) -> None:
        """Change fields of a node."""
        self.numbered[number] = replace(self.numbered[number], **more)

    @contextmanager
    def controlled_by(self, number: int, *, branch: bool = True) -> Iterator[None]:
        """Let the nodes that begin meanwhile be in a condition or loop."""
        context = self._control, self._branch
        self._control, self._branch = number, branch
        yield
        self._control, self._branch = context

    @contextmanager
    def definition(self) -> Iterator[None]:
        """Let the nodes that begin meanwhile be in no condition or loop."""
        context = self._control, self._branch, self._function
        self._control, self._branch = -1, True
        yield
        self._control, self._branch, self._function = context

    def enter_function(self, number: int) -> None:
        """Let the nodes that begin from now on be in a function, until its `definition` ends.

        Args:
            number: the function's; -1 for none.
        """
        self._function = number

    def _text(self, node: Placed) -> str:
        """The first line of a node's Python, shortened."""
        line = self._lines[node.lineno - 1]
        end = node.end_col_offset if node.end_lineno == node.lineno else len(line)
        text = line[node.col_offset : end].decode("utf-8", "replace").strip()
        return text if len(text) <= LONGEST else text[: LONGEST - 3] + "..."
