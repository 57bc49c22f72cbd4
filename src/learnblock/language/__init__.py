"""Three notations round one syntax tree: pure functions from text to tree to text."""

from learnblock.language.check import check
from learnblock.language.format import format  # noqa: A004 - the verb of every formatter
from learnblock.language.nodes import Program, Span
from learnblock.language.parser import parse, recover
from learnblock.language.python import PythonText, to_python
from learnblock.language.python_reader import from_python
from learnblock.language.source_map import SourceMap

__all__ = [
    "Program",
    "PythonText",
    "SourceMap",
    "Span",
    "check",
    "format",
    "from_python",
    "parse",
    "recover",
    "to_python",
]
