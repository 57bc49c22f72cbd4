"""The statements of a program, told apart by the lines that the interpreter reports.

Versions of Python disagree on the lines of a statement: one that spans several lines is reported
once or several times, a loop in one line once or in each round, the inside of a lambda never or
always. They agree on which statement runs next, so that is what a line event says here.
"""

import ast
from collections.abc import Callable, Iterator
from types import CodeType, FrameType
from typing import Any

OnLine = Callable[[int], object]
#: What `sys.settrace` and a frame's ``f_trace`` expect.
Trace = Callable[[FrameType, str, Any], Any]

_MODULE = "<module>"


# Why: docs/decisions.md, "A line event is a statement that begins"
class Statements:
    """The statements of a program, and the one that each of its frames is in.

    Args:
        source: the program's Python.

    Raises:
        SyntaxError: it is not Python.
    """

    def __init__(self, source: str) -> None:
        program = _Program(source)
        self._beginnings = program.beginnings
        self._loops_in_a_line = program.loops_in_a_line
        #: The statement that each frame is in, and the instruction where it began. Keyed by the
        #: frame's id, because a reference would keep its variables.
        self._current: dict[int, tuple[int, int]] = {}

    def enter(self, frame: FrameType) -> None:
        """Record that a frame of the program begins."""
        self._current.pop(id(frame), None)

    def resume(self, frame: FrameType) -> None:
        """Record a frame that is already in the middle of a statement."""
        self._current[id(frame)] = self._beginnings.get(frame.f_lineno, 0), frame.f_lasti

    def begun(self, frame: FrameType, line: int) -> int:
        """The first line of the statement that begins at `line`; 0 if none begins."""
        code = frame.f_code
        if line == code.co_firstlineno and code.co_name != _MODULE:
            # The start of a class or a function, which Python reports up to 3.12.
            return 0
        beginning = self._beginnings.get(line, 0)
        current, began = self._current.get(id(frame), (0, -1))
        begins_again = frame.f_lasti == began and beginning not in self._loops_in_a_line
        if beginning == current and not begins_again:
            # Another line of the same statement, or a return to its first.
            return 0
        self._current[id(frame)] = beginning, frame.f_lasti
        return beginning

    def follow(self, frame: FrameType, on_line: OnLine, *, is_running: bool = False) -> Trace:
        """A trace function for one frame of the program, which calls `on_line` as `begun` says.

        It is as `enter` or `resume` and then `begun` at each line, at half the cost: nearly all of
        a trace is lines.

        Args:
            frame: the frame.
            on_line: called with the first line of each statement that begins.
            is_running: whether the frame is in the middle of a statement.
        """
        code, beginning_of, loops = frame.f_code, self._beginnings.get, self._loops_in_a_line
        definition = 0 if code.co_name == _MODULE else code.co_firstlineno
        current, began = 0, -1
        if is_running:
            current, began = beginning_of(frame.f_lineno, 0), frame.f_lasti

        def local(frame: FrameType, event: str, _argument: object) -> Any:
            nonlocal current, began
            if event == "line" and (line := frame.f_lineno) != definition:
                beginning, instruction = beginning_of(line, 0), frame.f_lasti
                if beginning != current or (instruction == began and beginning not in loops):
                    current, began = beginning, instruction
                    if beginning:
                        on_line(beginning)
            return local

        return local


def has_statements(code: CodeType) -> bool:
    """Whether `code` has statements: an expression's function, such as a lambda, has none."""
    return code.co_name == _MODULE or not (
        code.co_name.startswith("<") or code.co_name == "__annotate__"
    )


class _Program:
    """The lines at which the statements of a program begin.

    Args:
        source: the program's Python.
    """

    def __init__(self, source: str) -> None:
        self._lines = source.encode().splitlines()
        #: For each line, the line at which its innermost statement begins; 0 if it never runs.
        self.beginnings: dict[int, int] = {}
        #: Loops such as `while True: x += 1`, whose rounds Python reports up to 3.11.
        self.loops_in_a_line: set[int] = set()
        nodes: list[ast.AST] = [ast.parse(source)]
        while nodes:
            node = nodes.pop()
            self._mark(node)
            nodes += reversed([*_inner(node)])

    def _mark(self, node: ast.AST) -> None:
        for first, last in _extents(node):
            beginning = self._beginning(node, first)
            self.beginnings.update(dict.fromkeys(range(first, last + 1), beginning))
        if isinstance(node, ast.While) and not self._leads_its_line(node.body[0]):
            self.loops_in_a_line.add(node.lineno)

    def _beginning(self, node: ast.AST, first: int) -> int:
        if isinstance(node, ast.stmt) and not self._leads_its_line(node):
            return self.beginnings[first]
        # From 3.14 on an annotation without a value is no longer evaluated.
        return 0 if isinstance(node, ast.AnnAssign) and node.value is None else first

    def _leads_its_line(self, node: ast.stmt) -> bool:
        return not self._lines[node.lineno - 1][: node.col_offset].strip()


def _extents(node: ast.AST) -> Iterator[tuple[int, int]]:
    """The first and the last line of a statement, and of each of its decorators."""
    if isinstance(node, ast.match_case):
        # It has no line of its own; its pattern begins at it.
        yield node.pattern.lineno, node.body[-1].end_lineno or 0
    elif isinstance(node, ast.stmt | ast.excepthandler):
        yield node.lineno, node.end_lineno or node.lineno
    for decorator in getattr(node, "decorator_list", ()):
        yield decorator.lineno, decorator.end_lineno


def _inner(node: ast.AST) -> Iterator[ast.AST]:
    """The statements in a statement, with the parts that begin with a line of their own."""
    for field in ("body", "orelse", "finalbody", "handlers", "cases"):
        yield from getattr(node, field, ())
