"""Rename skills of a library, so that it can be used together with others."""

from collections.abc import Mapping
from dataclasses import replace
from types import MappingProxyType

from learnblock import language
from learnblock.blocks import BlockConfiguration, load_configurations
from learnblock.blocks.schema.writing import written
from learnblock.errors import Diagnostic, LibraryError, UnknownNameError
from learnblock.extensions.libraries.contents import FUNCTIONS, Library, check, refuse_name
from learnblock.extensions.libraries.python_names import renamed as renamed_in_python
from learnblock.i18n import Phrase
from learnblock.language.edit.rename import rename, rename_skill


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
        file: renamed_in_python(text, name, new, file) for file, text in library.modules.items()
    }
    changed = replace(
        library,
        functions=_in_functions(library.functions, name, new),
        modules=MappingProxyType(modules),
        configurations=_in_configurations(library.configurations, name, new),
    )
    check(changed, library.name)
    return changed


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
    return written(_named(one, new) if one.name == name else one for one in blocks)


def _named(block: BlockConfiguration, new: str) -> BlockConfiguration:
    """A renamed block; a label that was the old name in words becomes the new name."""
    label = block.name.replace("_", " ")
    languages = {
        code: new.replace("_", " ") if text == label else text
        for code, text in block.languages.items()
    }
    return replace(block, name=new, languages=languages)
