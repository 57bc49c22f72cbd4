"""Leave out the errors that a ``try`` around them handles: they are not mistakes there."""

import ast
import builtins
from collections.abc import Iterable, Iterator, Mapping
from types import MappingProxyType
from typing import NamedTuple

from learnblock.errors import Diagnostic
from learnblock.language.tree.loads import parsed
from learnblock.language.tree.nodes import Item, PythonBlock

#: What Python raises, by the code of a message or of a diagnostic.
_RAISED: Mapping[str, type[Exception]] = MappingProxyType(
    {
        "check-not-whole": ValueError,
        "check-divide-by-zero": ZeroDivisionError,
        "past-end": IndexError,
        "wrong-type": TypeError,
        **dict.fromkeys(("missing-argument", "argument-count", "unknown-argument"), TypeError),
        **dict.fromkeys(("unknown-name", "unset-variable", "unknown-function"), NameError),
        **dict.fromkeys(
            (
                "check-unknown-name",
                "check-unknown-name-near",
                "check-unknown-function",
                "check-unknown-function-near",
            ),
            NameError,
        ),
    }
)
#: The errors of a program's author rather than of its data: only their own names handle them.
_SLIPS = frozenset((NameError, TypeError))


class _Handled(NamedTuple):
    """The lines below a ``try``, and the errors that it handles."""

    first: int
    last: int
    errors: tuple[type[BaseException], ...]

    def handles(self, diagnostic: Diagnostic) -> bool:
        raised = _RAISED.get(diagnostic.message.code) or _RAISED.get(diagnostic.code)
        if raised is None or not self.first <= diagnostic.line <= self.last:
            return False
        return raised in self.errors if raised in _SLIPS else issubclass(raised, self.errors)


def without_handled(diagnostics: Iterable[Diagnostic], items: Iterable[Item]) -> list[Diagnostic]:
    """The diagnostics that no ``try`` of a program handles.

    Args:
        diagnostics: all diagnostics.
        items: every statement of the program.
    """
    handled = list(_tries(items))
    return [each for each in diagnostics if not any(block.handles(each) for block in handled)]


def _tries(items: Iterable[Item]) -> Iterator[_Handled]:
    for item in items:
        if isinstance(item, PythonBlock) and item.parts[0].word == "try" and item.parts[0].body:
            body = item.parts[0].body
            yield _Handled(body[0].span.line, body[-1].span.end_line, tuple(_errors(item.text)))


def _errors(text: str) -> Iterator[type[BaseException]]:
    """The errors of Python that a ``try`` handles, except those that the program defines."""
    for node in ast.walk(parsed(text)):
        if not isinstance(node, ast.ExceptHandler):
            continue
        if node.type is None:
            yield BaseException
            continue
        for named in node.type.elts if isinstance(node.type, ast.Tuple) else [node.type]:
            error = getattr(builtins, named.id, None) if isinstance(named, ast.Name) else None
            if isinstance(error, type) and issubclass(error, BaseException):
                yield error
