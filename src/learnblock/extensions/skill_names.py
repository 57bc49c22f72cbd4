"""Positions of skill names in Python source, which is read but not run."""

import ast
from collections.abc import Collection, Iterable, Iterator, Mapping
from dataclasses import dataclass


@dataclass(frozen=True, slots=True, order=True)
class NamePosition:
    """A position where a skill is defined or called.

    Args:
        line: the line, from 1.
        column: the column in bytes, from 0.
        name: the skill's name.
        is_plain: whether the source spells it exactly like `name`, not in a different Unicode form.
    """

    line: int
    column: int
    name: str
    is_plain: bool


def places(tree: ast.Module, source: str, names: Collection[str]) -> Iterator[NamePosition]:
    """The positions of skill names.

    Args:
        tree: the syntax tree of the source.
        source: a module.
        names: the names of the skills, which need not be in the source.
    """
    lines = _lines(source)
    for line, column, name in _named(tree, lines, names):
        text = name.encode()
        yield NamePosition(line, column, name, lines[line - 1][column : column + len(text)] == text)


def replaced(source: str, positions: Iterable[NamePosition], names: Mapping[str, str]) -> str:
    """The source with other names at these positions, which must be plain."""
    lines = _lines(source)
    # From the end, so that earlier positions stay valid.
    for place in sorted(positions, reverse=True):
        text, end = lines[place.line - 1], place.column + len(place.name.encode())
        lines[place.line - 1] = text[: place.column] + names[place.name].encode() + text[end:]
    return b"\n".join(lines).decode("utf-8", "surrogatepass")


def _lines(source: str) -> list[bytes]:
    return [line.encode("utf-8", "surrogatepass") for line in source.split("\n")]


def _named(
    tree: ast.Module, lines: list[bytes], names: Collection[str]
) -> Iterator[tuple[int, int, str]]:
    for node in ast.walk(tree):
        match node:
            case ast.FunctionDef(name=name) if name in names:
                line = lines[node.lineno - 1]
                behind = line[node.col_offset + len("def") :]
                yield node.lineno, len(line) - len(behind.lstrip()), name
            case ast.Name(id=name) if name in names:
                yield node.lineno, node.col_offset, name
            case ast.Attribute(value=ast.Name(id="robot"), attr=name) if name in names:
                end = node.end_col_offset or 0
                yield node.end_lineno or 0, end - len(name.encode()), name
