"""Rename a name in Python source, where it is read, set, imported and defined."""

import ast
import re
from collections.abc import Iterator
from typing import NamedTuple

from learnblock.language.tree.loads import parsed


class UnsupportedNameError(Exception):
    """The name is used in a way in which it can't be renamed."""


#: Columns of Python's parser count bytes; text may have halves of characters.
_ENCODING = ("utf-8", "surrogatepass")


class _Place(NamedTuple):
    """A name in a line, counted in bytes, and what is written before the new one."""

    line: int
    start: int
    before: str = ""


def renamed_in(text: str, old: str, new: str) -> str:
    """Python source with another name for a variable, a function, a class or a module.

    Args:
        text: statements, an expression or a decorator.
        old: the name as spelled in Python.
        new: the new name as spelled in Python.

    Raises:
        UnsupportedNameError: it is used where its place is not certain.
    """
    # The parser reads neither a decorator alone nor an indented expression.
    indent = 1 if text.startswith("@") else len(text) - len(text.lstrip(" "))
    source = text[indent:]
    lines = [line.encode(*_ENCODING) for line in source.split("\n")]
    spelled = old.encode(*_ENCODING)
    places = {place for node in ast.walk(parsed(source)) for place in _places(node, old, lines)}
    for line, start, before in sorted(places, reverse=True):
        written, end = lines[line - 1], start + len(spelled)
        if written[start:end] != spelled:
            raise UnsupportedNameError
        kept = written[:start] + before.encode(*_ENCODING)
        lines[line - 1] = kept + new.encode(*_ENCODING) + written[end:]
    return text[:indent] + b"\n".join(lines).decode(*_ENCODING)


def functions_with(text: str, parameter: str) -> set[str]:
    """The functions in Python source that have a parameter of this name."""
    return {
        node.name
        for node in ast.walk(parsed(text))
        if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef)
        and any(isinstance(part, ast.arg) and part.arg == parameter for part in ast.walk(node.args))
    }


def _places(node: ast.AST, old: str, lines: list[bytes]) -> Iterator[_Place]:
    match node:
        case ast.Name(id=name) | ast.arg(arg=name) if name == old:
            yield _Place(node.lineno, node.col_offset)
        case ast.Global(names=shared) | ast.Nonlocal(names=shared) if old in shared:
            yield _behind(r"\b(?:global|nonlocal)\b.*?", old, node, lines)
        case ast.FunctionDef(name=name) | ast.AsyncFunctionDef(name=name) if name == old:
            yield _behind(r"\bdef\s+", old, node, lines)
        case ast.ClassDef(name=name) if name == old:
            yield _behind(r"\bclass\s+", old, node, lines)
        case ast.ExceptHandler(name=name) if name == old:
            yield _behind(r"\bas\s+", old, node, lines)
        case ast.alias():
            yield from _imported(node, old, lines)
        case ast.MatchAs(name=name) | ast.MatchStar(name=name) if name == old:
            # The name is their last word.
            start = (node.end_col_offset or 0) - len(old.encode(*_ENCODING))
            yield _Place(node.end_lineno or node.lineno, start)
        case ast.MatchMapping(rest=name) if name == old:
            yield _behind(r"\*\*\s*", old, node, lines)


def _imported(node: ast.alias, old: str, lines: list[bytes]) -> Iterator[_Place]:
    if node.asname == old:
        yield _behind(r"\bas\s+", old, node, lines)
    elif node.asname is None and node.name == old:
        yield _Place(node.lineno, node.col_offset, f"{old} as ")
    elif node.asname is None and node.name.partition(".")[0] == old:
        raise UnsupportedNameError


def _behind(
    words: str,
    name: str,
    node: ast.stmt | ast.ExceptHandler | ast.alias | ast.pattern,
    lines: list[bytes],
) -> _Place:
    """The place of a name that the tree does not give: behind some words of its node's line."""
    line = lines[node.lineno - 1].decode(*_ENCODING)
    start = len(lines[node.lineno - 1][: node.col_offset].decode(*_ENCODING))
    match = re.compile(rf"{words}\b({re.escape(name)})\b").search(line, start)
    if match is None:
        raise UnsupportedNameError
    return _Place(node.lineno, len(line[: match.start(1)].encode(*_ENCODING)))
