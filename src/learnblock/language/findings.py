"""What is known of a program that is being checked, and what has been found wrong with it."""

import ast
import warnings
from collections.abc import Iterable, Mapping

from learnblock.blocks.configuration import BlockConfiguration, Configurations
from learnblock.blocks.importable import Importable
from learnblock.errors import Diagnostic, Severity
from learnblock.language import markers
from learnblock.language.nodes import (
    Body,
    Def,
    Import,
    Program,
    Raw,
    Span,
    When,
    set_by,
    statements,
)


class Findings:
    """The facts that all checks share, and the diagnostics that they add to.

    Args:
        program: the tree.
        skills: what ``function.`` offers, by name.
        devices: what the chosen robot has; None where no robot is chosen.
        importable: what an ``import`` can name; None where that is not known.
    """

    def __init__(
        self,
        program: Program,
        skills: Mapping[str, BlockConfiguration],
        devices: frozenset[str] | None,
        importable: Importable | None = None,
    ) -> None:
        self.program, self.skills, self.devices = program, skills, devices
        self.importable = importable
        self.broken = skills.broken if isinstance(skills, Configurations) else {}
        self.diagnostics: list[Diagnostic] = []
        self.functions = program.functions
        self.whens = program.whens
        self.top = tuple(item for item in program.items if not isinstance(item, Def | When))
        self.main: Body = () if program.main is None else program.main.body
        self.everything = list(statements(program.items + self.main))
        self.imported = {item.module for item in program.items if isinstance(item, Import)}
        self.raw_names = self.names_in_raw()
        self.assigned = self.raw_names.union(filter(None, map(set_by, self.everything)))

    @property
    def imports(self) -> bool:
        """Whether names may come from elsewhere; a library brings none but those of its skills."""
        known = self.importable.libraries if self.importable else frozenset()
        return bool(self.imported - known) or "*" in self.raw_names

    def names_in_raw(self) -> set[str]:
        found: set[str] = set()
        for item in self.everything:
            if isinstance(item, Raw):
                found |= markers.raw_names(item.text) | defined_names(item.text)
        return found

    def report(self, code: str, message: str, span: Span, severity: Severity = "error") -> None:
        end = span.end_column if span.end_line == span.line else 0
        self.diagnostics.append(Diagnostic(code, message, span.line, span.column, end, severity))


def quoted(names: Iterable[str]) -> str:
    return ", ".join(f"`{name}`" for name in names)


def write_one(name: str) -> str:
    return f"write one, or check the name `{name}`"


def python_error(text: str, mode: str) -> SyntaxError | None:
    """Why a text is no Python; `mode` is ``exec`` for statements and ``eval`` for an expression."""
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            compile(text, "", mode, ast.PyCF_ONLY_AST)
    except SyntaxError as error:
        return error
    except (ValueError, RecursionError, MemoryError) as error:
        return SyntaxError(str(error))
    return None


def defined_names(text: str) -> set[str]:
    """What raw Python imports and defines."""
    try:
        tree = ast.parse(text)
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        return set()
    found: set[str] = set()
    for node in ast.walk(tree):
        if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef | ast.ClassDef):
            found.add(node.name)
        elif isinstance(node, ast.alias):
            found.add((node.asname or node.name).partition(".")[0])
    return found
