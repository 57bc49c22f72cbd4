"""Three notations for one syntax tree: pure functions that convert text to trees and back."""

from learnblock.language.blocktext.format import format  # noqa: A004 - the usual name in formatters
from learnblock.language.blocktext.parser import parse, recover
from learnblock.language.check.check import check
from learnblock.language.python.generation import PythonText, to_python
from learnblock.language.python.reader import from_python
from learnblock.language.python.source_map import SourceMap
from learnblock.language.tree.nodes import Program, Span
from learnblock.language.workspace.blocks import Workspace
from learnblock.language.workspace.conversion import (
    WorkspaceProgram,
    WorkspaceText,
    from_workspace,
    to_workspace,
)

__all__ = [
    "Program",
    "PythonText",
    "SourceMap",
    "Span",
    "Workspace",
    "WorkspaceProgram",
    "WorkspaceText",
    "check",
    "format",
    "from_python",
    "from_workspace",
    "parse",
    "recover",
    "to_python",
    "to_workspace",
]
