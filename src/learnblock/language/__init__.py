"""Three notations round one syntax tree: pure functions from text to tree to text."""

from learnblock.language.check import check
from learnblock.language.format import format  # noqa: A004 - the verb of every formatter
from learnblock.language.nodes import Program, Span
from learnblock.language.parser import parse, recover
from learnblock.language.python import PythonText, to_python
from learnblock.language.python_reader import from_python
from learnblock.language.source_map import SourceMap
from learnblock.language.workspace import Workspace
from learnblock.language.workspace_conversion import (
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
