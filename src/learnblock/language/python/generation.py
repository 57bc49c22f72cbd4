"""Generate Python: simple code for learners, with the source of each line, and skills.

Skills are functions of a library: they take the robot first and pass it to each other.
"""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass

from learnblock.language.python.robot_import import with_robot
from learnblock.language.python.source_map import SourceMap
from learnblock.language.python.writer import PythonWriter
from learnblock.language.tree.builtins import MODULES
from learnblock.language.tree.extents import Extent, every
from learnblock.language.tree.nodes import (
    Call,
    Def,
    If,
    Node,
    Program,
    PythonBlock,
    Raw,
    is_only_raw,
)
from learnblock.language.tree.traversal import statements

DEFAULT_ROBOT = "learnblock.robots.sim_ebo"


@dataclass(frozen=True, slots=True)
class PythonText:
    """A Python program and the source of each of its lines.

    Args:
        text: the program.
        source_map: maps its lines to those of the source.
        extents: the lines of each statement, by the `id()` of its node.
    """

    text: str
    source_map: SourceMap
    extents: Mapping[int, Extent]


# Why: docs/decisions.md, "Generated Python is what a good teacher would write"
def to_python(program: Program, robot_module: str | None = DEFAULT_ROBOT) -> PythonText:
    """Write a program as Python, for one robot.

    Args:
        program: a program that was read from Python keeps its text, except for the robot's import.
        robot_module: the module from which ``Robot`` is imported: the only difference between
            robots. None keeps the one in the text.
    """
    if program.python is not None:
        return _kept(program, program.python, robot_module)
    if _is_raw(program):
        return _kept(program, program.items[0].text, None)  # type: ignore[union-attr]
    return canonical(program, robot_module or DEFAULT_ROBOT)


def canonical(program: Program, robot_module: str) -> PythonText:
    """Write a program as Python in its canonical form, even if it was read from Python."""
    writer = PythonWriter(program, frozenset())
    text = writer.program(robot_module)
    if writer.clashes:
        writer = PythonWriter(program, frozenset(writer.clashes))
        text = writer.program(robot_module)
    source_map = SourceMap(tuple(writer.sources), tuple(writer.nodes))
    return PythonText(text, source_map, writer.extents)


def _is_raw(program: Program) -> bool:
    return program.main is None and is_only_raw(program.items)


def _kept(program: Program, text: str, robot_module: str | None) -> PythonText:
    if robot_module is not None:
        text = with_robot(text, robot_module)
    lines = text.count("\n") + (not text.endswith("\n"))
    sources: list[int] = [0] * lines
    nodes: list[Node | None] = [None] * lines
    raw_only = _is_raw(program) and program.python is None
    for line, source, node in _raw_lines(program) if raw_only else _read_lines(program):
        if line <= lines and not sources[line - 1]:
            sources[line - 1], nodes[line - 1] = source, node
    written = {id(node): (node.span.line, node.span.end_line) for node in every(program)}
    if raw_only:
        written = {id(program.items[0]): (1, text.count("\n") + 1)}
    return PythonText(text, SourceMap(tuple(sources), tuple(nodes)), written)


def _raw_lines(program: Program) -> Iterator[tuple[int, int, Node]]:
    """The lines of a program that consists of raw Python, starting below ``python:``."""
    node = program.items[0]
    assert isinstance(node, Raw)  # noqa: S101 - checked by the caller
    below = node.span.line + (1 if node.span.line else 0)
    from_python = node.span.end_column == 0
    for index in range(node.text.count("\n") + 1):
        yield index + 1, (index + 1 if from_python else below + index), node


def _read_lines(program: Program) -> Iterator[tuple[int, int, Node]]:
    """The lines of a program that was read from Python, from its spans."""
    for statement in statements(program.items + (program.main.body if program.main else ())):
        for line in range(statement.span.line, statement.span.end_line + 1):
            yield line, line, statement
        if isinstance(statement, If):
            for part in (*statement.branches, statement.otherwise):
                if part is not None:
                    yield part.span.line, part.span.line, statement
        elif isinstance(statement, PythonBlock):
            for header in statement.parts:
                yield header.span.line, header.span.line, statement


def to_skills(program: Program, origin: str) -> str:
    """The Python of a program that consists of functions and the variables that they share.

    Args:
        program: the program of a library.
        origin: the file of the program.
    """
    writer = _SkillWriter(program, frozenset())
    writer.body_of(list(program.items))
    heading = [f'"""Made from {origin}: change that, and not this file."""']
    imports = [f"import {module}" for module in MODULES if module in writer.modules]
    lines = [*heading, *([""] if imports else []), *imports, *writer.lines]
    return "\n".join([*lines, ""])


class _SkillWriter(PythonWriter):
    def definition(self, node: Def) -> None:
        parameters = ["robot", *map(self.variable, node.parameters)]
        self.function(f"def {self.variable(node.name)}({', '.join(parameters)})", node)

    def call(self, node: Call, level: int) -> str:
        text = super().call(node, level)
        if node.name not in self.functions:
            return text
        name, _, arguments = text.partition("(")
        return f"{name}(robot{'' if arguments == ')' else ', '}{arguments}"
