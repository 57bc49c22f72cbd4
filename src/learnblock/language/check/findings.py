"""The facts about a program that all checks share, and the diagnostics that they find."""

import ast
import warnings
from collections.abc import Mapping

from learnblock.blocks import BlockConfiguration, Configurations
from learnblock.blocks.importable import Importable
from learnblock.errors import Diagnostic, Severity, nearest
from learnblock.i18n import Phrase
from learnblock.language.tree import markers
from learnblock.language.tree.nodes import (
    AnyPython,
    Body,
    Call,
    Constant,
    Def,
    Dictionary,
    Expression,
    FString,
    Import,
    List,
    Name,
    Number,
    Program,
    RawExpression,
    SkillCall,
    Span,
    String,
    Unary,
    When,
)
from learnblock.language.tree.traversal import (
    all_expressions,
    set_by,
    statements,
)
from learnblock.language.workspace.literals import value_of


def unknown(sort: str, name: str, near: str | None) -> Phrase:
    """The message about an unknown name.

    Args:
        sort: ``name``, ``function`` for one that is called, or ``skill``.
        name: the name.
        near: a known name that resembles it; None if none does.
    """
    if near is None:
        return Phrase(f"check-unknown-{sort}", name=name)
    return Phrase(f"check-unknown-{sort}-near", name=name, near=near)


class Findings:
    """The facts about a program, and the diagnostics found so far.

    Args:
        program: the tree.
        skills: the skills of the robot, by name.
        equipment: what the chosen robot has; None if no robot is chosen.
        importable: the modules that an ``import`` can name; None if unknown.
        in_python: whether the program's author wrote Python.
    """

    def __init__(
        self,
        program: Program,
        skills: Mapping[str, BlockConfiguration],
        equipment: frozenset[str] | None,
        importable: Importable | None = None,
        *,
        in_python: bool = False,
    ) -> None:
        self.program, self.skills, self.equipment = program, skills, equipment
        self.in_python = in_python
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
        self.assigned = self.raw_names.union(*map(set_by, self.everything))

    @property
    def imports(self) -> bool:
        """Whether an import may define any name; a library defines only its skills."""
        known = self.importable.libraries if self.importable else frozenset()
        return bool(self.imported - known) or "*" in self.raw_names

    def called(self, skill: str) -> str:
        """The name of a skill as its author writes it."""
        return f"robot.{skill}" if self.in_python else f"function.{skill}"

    def spelled(self, node: Expression) -> str:  # noqa: PLR0911 - one for each expression
        """A short form of an expression, to be quoted."""
        match node:
            case Name(name=name):
                return name
            case Number(text=text):
                return text
            case String(value=value):
                return f'"{value}"'
            case Constant(value=value):
                return str(value)
            case Call(name=name):
                return f"{name}(...)"
            case SkillCall(name=name):
                return f"{self.called(name)}(...)"
            case List():
                return "[...]"
            case Dictionary():
                return "{...}"
            case FString():
                return 'f"..."'
        return "..."

    def is_of_language(self, name: str) -> bool:
        """Whether a function is built into the language and not replaced by another one."""
        return name not in self.functions and name not in self.raw_names and not self.imports

    def names_in_raw(self) -> set[str]:
        names: set[str] = set()
        for item in self.everything:
            if isinstance(item, AnyPython):
                names |= markers.raw_names(item.text) | markers.defined_names(item.text)
            for node in all_expressions(item):
                if isinstance(node, RawExpression) and ":=" in node.text:
                    names |= markers.raw_names(node.text.strip())
        return names

    def unknown_when(self, name: str) -> Phrase:
        """The message about a ``when`` that does not exist."""
        near = nearest(name, self.whens)
        if near is None:
            code = self.worded("check-unknown-when", "python-unknown-when")
            return Phrase(code, name=name)
        return Phrase("check-unknown-when-near", name=name, near=near)

    def worded(self, blocktext: str, python: str) -> str:
        """The code of a message in the notation of the program's author."""
        return python if self.in_python else blocktext

    def report(self, code: str, message: Phrase, span: Span, severity: Severity = "error") -> None:
        end = span.end_column if span.end_line == span.line else 0
        self.diagnostics.append(Diagnostic(code, message, span.line, span.column, end, severity))


def constant(node: Expression) -> float | str | None:
    """The value of a literal number or string."""
    match node:
        case String(value=text):
            return text
        case Number(text=spelled):
            return value_of(spelled)
        case Unary(operator="-", operand=Number(text=spelled)):
            value = value_of(spelled)
            return None if value is None else -value
    return None


def is_whole(text: str) -> bool:
    """Whether the spelling of a number is that of a whole one."""
    try:
        int(text, 0)
    except ValueError:
        return False
    return True


def python_error(text: str, mode: str) -> SyntaxError | None:
    """The syntax error in Python source; `mode` is ``exec`` for statements, else ``eval``."""
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            compile(text, "", mode, ast.PyCF_ONLY_AST)
    except SyntaxError as error:
        return error
    except (ValueError, RecursionError, MemoryError) as error:
        return SyntaxError(str(error))
    return None
