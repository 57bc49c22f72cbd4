"""Rename a skill in Python source, which is read and not run."""

import ast
from collections.abc import Iterator

from learnblock.errors import Diagnostic, LibraryError
from learnblock.extensions.skill_names import places, replaced
from learnblock.i18n import Phrase
from learnblock.storage import skill_files


def renamed(source: str, name: str, new: str, filename: str) -> str:
    """Rename a skill in a module, where it is defined and where it is called.

    Args:
        source: a module.
        name: the skill's name, which need not be in the source.
        new: its new name.
        filename: the file name shown in errors.

    Raises:
        LibraryError: the new name is already used, or the old one has other meanings.
        ProgramError: the source is not valid Python.
    """
    tree = skill_files.parse(source, filename)
    _refuse(tree, name, new, filename)
    found = tuple(places(tree, source, {name}))
    for place in found:
        if not place.is_plain:
            message = Phrase("library-unusual-name", name=name)
            raise LibraryError(filename, [Diagnostic("two-meanings", message, place.line)])
    return replaced(source, found, {name: new})


def _refuse(tree: ast.Module, name: str, new: str, filename: str) -> None:
    defined = {id(node) for node in tree.body if isinstance(node, ast.FunctionDef)}
    for node in ast.walk(tree):
        line = getattr(node, "lineno", 0)
        if new in _named(node):
            message = Phrase("library-name-used", name=new)
            raise LibraryError(filename, [Diagnostic("name-taken", message, line)])
        if name in _bound(node) and id(node) not in defined:
            message = Phrase("library-two-meanings", name=name)
            raise LibraryError(filename, [Diagnostic("two-meanings", message, line)])


def _named(node: ast.AST) -> Iterator[str]:
    yield from _bound(node)
    if isinstance(node, ast.Name):
        yield node.id


def _bound(node: ast.AST) -> Iterator[str]:
    """The names that a node binds."""
    match node:
        case ast.FunctionDef(name=name) | ast.AsyncFunctionDef(name=name) | ast.ClassDef(name=name):
            yield name
        case ast.Name(id=name, ctx=ast.Store() | ast.Del()) | ast.arg(arg=name):
            yield name
        case ast.Global(names=names) | ast.Nonlocal(names=names):
            yield from names
        case ast.alias(name=name, asname=asname):
            yield asname or name
        case ast.ExceptHandler(name=str(name)) | ast.MatchAs(name=str(name)):
            yield name
        case ast.MatchStar(name=str(name)) | ast.MatchMapping(rest=str(name)):
            yield name
