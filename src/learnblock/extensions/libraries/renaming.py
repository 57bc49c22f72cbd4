"""Rename skills of a library, so that it can be used together with others."""

import ast
from collections.abc import Iterator, Mapping
from dataclasses import replace
from types import MappingProxyType

from learnblock import language
from learnblock.blocks import BlockConfiguration, load_configurations
from learnblock.blocks.schema.writing import written
from learnblock.errors import Diagnostic, LibraryError, UnknownNameError
from learnblock.extensions.libraries.contents import FUNCTIONS, Library, check, refuse_name
from learnblock.extensions.skill_names import places, replaced
from learnblock.i18n import Phrase
from learnblock.language.edit.rename import rename, rename_skill
from learnblock.storage import skill_files


def renamed(library: Library, names: Mapping[str, str]) -> Library:
    """Rename skills of a library, also where they call each other.

    Args:
        library: the library to change.
        names: the new name of each skill, by its old name.

    Raises:
        UnknownNameError: there is no such skill.
        LearnBlockError: a new name is not allowed.
    """
    for name, new in names.items():
        library = _renamed(library, name, new)
    return library


def _renamed(library: Library, name: str, new: str) -> Library:
    if name not in library.skills:
        raise UnknownNameError("skill", name, library.skills)
    if new in library.skills:
        message = Phrase("library-skill-exists", skill=new)
        raise LibraryError(library.name, [Diagnostic("name-taken", message)])
    if not new.isidentifier():
        message = Phrase("library-bad-skill-name", name=new[:100])
        raise LibraryError(library.name, [Diagnostic("skill-name", message)])
    refuse_name(new, library.name, 0)
    modules = {
        file: renamed_module(text, name, new, file) for file, text in library.modules.items()
    }
    new_library = replace(
        library,
        functions=_in_functions(library.functions, name, new),
        modules=MappingProxyType(modules),
        configurations=_in_configurations(library.configurations, name, new),
    )
    check(new_library, library.name)
    return new_library


def _in_functions(text: str, name: str, new: str) -> str:
    if not text:
        return ""
    program = rename_skill(language.parse(text, FUNCTIONS), name, new)
    if name in program.functions:
        program = rename(program, "function", name, new)
    return language.format(program)


def _in_configurations(text: str, name: str, new: str) -> str:
    if not text:
        return ""
    blocks = load_configurations(text)
    return written(_named(block, new) if block.name == name else block for block in blocks)


def _named(block: BlockConfiguration, new: str) -> BlockConfiguration:
    """A renamed block; a label that was the old name in words becomes the new name."""
    label = block.name.replace("_", " ")
    languages = {
        code: new.replace("_", " ") if text == label else text
        for code, text in block.languages.items()
    }
    return replace(block, name=new, languages=languages)


def renamed_module(source: str, name: str, new: str, filename: str) -> str:
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
    _refuse_ambiguous(tree, name, new, filename)
    occurrences = tuple(places(tree, source, {name}))
    for place in occurrences:
        if not place.is_plain:
            message = Phrase("library-unusual-name", name=name)
            raise LibraryError(filename, [Diagnostic("two-meanings", message, place.line)])
    return replaced(source, occurrences, {name: new})


def _refuse_ambiguous(tree: ast.Module, name: str, new: str, filename: str) -> None:
    defined = {id(node) for node in tree.body if isinstance(node, ast.FunctionDef)}
    for node in ast.walk(tree):
        line = getattr(node, "lineno", 0)
        if new in _mentioned(node):
            message = Phrase("library-name-used", name=new)
            raise LibraryError(filename, [Diagnostic("name-taken", message, line)])
        if name in _bound(node) and id(node) not in defined:
            message = Phrase("library-two-meanings", name=name)
            raise LibraryError(filename, [Diagnostic("two-meanings", message, line)])


def _mentioned(node: ast.AST) -> Iterator[str]:
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
