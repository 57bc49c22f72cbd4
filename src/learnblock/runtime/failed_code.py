"""The part of a program that raised an error, so that a message can use the program's own words."""

import ast
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from itertools import islice
from types import TracebackType
from typing import Any

#: Longer code is not repeated in a message.
LONGEST_QUOTE = 60
_DIVISIONS: dict[type, str] = {ast.Div: "/", ast.FloorDiv: "//", ast.Mod: "%"}


@dataclass(frozen=True)
class FailedCode:
    """The innermost part of a program that raised an error.

    Args:
        node: its syntax tree.
        source: the program.
        inside: the function that it is in.
        own: the variables of that function.
        shared: the variables of the whole program.
    """

    node: ast.AST = field(default_factory=ast.Pass)
    source: str = ""
    inside: str = ""
    own: Mapping[str, Any] = field(default_factory=dict)
    shared: Mapping[str, Any] = field(default_factory=dict)

    @property
    def division(self) -> str:
        """The symbol of its division; ``/`` if it has none."""
        return _DIVISIONS.get(type(getattr(self.node, "op", None)), "/")

    @property
    def function(self) -> str:
        """The function that it calls, without the part before the dot; "" if it calls none."""
        match self.node:
            case ast.Call(func=ast.Name(id=name) | ast.Attribute(attr=name)):
                return name
        return ""

    @property
    def nothing(self) -> str | None:
        """The variable in it that is None, if there is exactly one."""
        names = {node.id for node in ast.walk(self.node) if isinstance(node, ast.Name)}
        empty = [name for name in names if self.value(name, "") is None]
        return empty[0] if len(empty) == 1 else None

    def value(self, name: str, default: object = None) -> object:
        """The value of a variable where the error was raised."""
        return self.own.get(name, self.shared.get(name, default))

    def sets(self, name: str) -> bool:
        """Whether the program sets this variable anywhere."""
        names = (node for node in ast.walk(ast.parse(self.source)) if isinstance(node, ast.Name))
        return any(node.id == name and isinstance(node.ctx, ast.Store) for node in names)

    def quote(self, node: ast.expr) -> str | None:
        """The text of an expression in it; None if it is too long."""
        text = ast.get_source_segment(self.source, node) or ""
        return text if 0 < len(text) <= LONGEST_QUOTE and "\n" not in text else None


#: The code of an error that was not raised inside the program.
UNKNOWN = FailedCode()


def failed_code(error: BaseException, filename: str, source: str) -> FailedCode:
    """The part of a program that raised an error.

    Args:
        error: as it was raised.
        filename: the name under which the program was compiled.
        source: the program.
    """
    steps = [step for step in _steps(error.__traceback__) if _file(step) == filename]
    if not steps:
        return UNKNOWN
    frame = steps[-1].tb_frame
    place = next(islice(frame.f_code.co_positions(), steps[-1].tb_lasti // 2, None), None)
    for node in ast.walk(ast.parse(source)):
        if isinstance(node, ast.expr | ast.AugAssign) and _place(node) == place:
            return FailedCode(node, source, frame.f_code.co_name, frame.f_locals, frame.f_globals)
    return UNKNOWN


def _steps(step: TracebackType | None) -> Iterator[TracebackType]:
    while step is not None:
        yield step
        step = step.tb_next


def _file(step: TracebackType) -> str:
    return step.tb_frame.f_code.co_filename


def _place(node: ast.expr | ast.AugAssign) -> tuple[int, int | None, int, int | None]:
    return node.lineno, node.end_lineno, node.col_offset, node.end_col_offset
