"""A library as a value, and as files."""

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from functools import cached_property
from keyword import iskeyword
from types import MappingProxyType

from learnblock import language
from learnblock.blocks import BlockConfiguration, load_configurations
from learnblock.blocks.installed_libraries import CONFIGURATIONS, MANIFEST, blocks, skills_in
from learnblock.errors import Diagnostic, LibraryError
from learnblock.extensions.libraries.manifest import Manifest, read_manifest, write_manifest
from learnblock.i18n import Phrase
from learnblock.language.blocktext import names
from learnblock.language.edit.extraction import extracted
from learnblock.language.python.generation import to_skills
from learnblock.language.tree.nodes import Assign, Blank, Comment, Def
from learnblock.storage import skill_files

#: The file of functions in Block-Text.
FUNCTIONS = "functions.bt"
#: The file that makes a folder a Python package.
PACKAGE = "__init__.py"
MOST_FILES = 100
#: The limit for all files together, in bytes: a hundred times the usual size.
LARGEST = 4 * 1024 * 1024

_MADE = "functions.py"
_MODULE = re.compile(r"[a-z][a-z0-9_]{0,59}\.py|__init__\.py")


@dataclass(frozen=True)
class Library:
    """Skills that programs import together.

    Args:
        manifest: the manifest of the library.
        functions: the functions in Block-Text.
        modules: Python source by file name; a hand-written ``__init__.py`` is the only module.
        configurations: the configurations of the blocks, as JSON; empty for the defaults.
    """

    manifest: Manifest
    functions: str = ""
    modules: Mapping[str, str] = field(default_factory=dict)
    configurations: str = ""

    @property
    def name(self) -> str:
        return self.manifest.name

    @cached_property
    def files(self) -> Mapping[str, str]:
        """The text of each file by name, including the generated files."""
        files = {MANIFEST: write_manifest(self.manifest), **self.modules}
        if self.functions:
            files[FUNCTIONS] = self.functions
            files[_MADE] = to_skills(language.parse(self.functions, FUNCTIONS), FUNCTIONS)
        if PACKAGE not in files:
            files[PACKAGE] = _package(self.name, files)
        if self.configurations:
            files[CONFIGURATIONS] = self.configurations
        return MappingProxyType(dict(sorted(files.items())))

    @cached_property
    def skills(self) -> Mapping[str, BlockConfiguration]:
        """The blocks of its skills by name."""
        return MappingProxyType({block.name: block for block in blocks(self.name, self.files)})


def from_files(files: Mapping[str, bytes], where: str) -> Library:
    """The library in these files; nothing in them is run.

    Args:
        files: the content of each file, by name.
        where: the folder or file they come from, for errors.

    Raises:
        LibraryError: they are not a library.
        ProgramError: a file is not valid Python or Block-Text.
        BlockConfigurationError: ``blocks.json`` is invalid.
    """
    texts = _texts(files, where)
    functions = _functions(texts.get(FUNCTIONS, ""))
    modules = {name: text for name, text in texts.items() if name.endswith(".py")}
    if functions:
        modules.pop(_MADE, None)
    library = Library(
        read_manifest(texts[MANIFEST]),
        functions,
        MappingProxyType(dict(_hand_written(modules, alone=not functions))),
        texts.get(CONFIGURATIONS, ""),
    )
    check(library, where)
    return library


def check(library: Library, where: str) -> None:
    """Refuse a library whose skills could not be used.

    Raises:
        LibraryError: it has no skills, or two with the same name.
        ProgramError: a file is not valid Python.
        BlockConfigurationError: ``blocks.json`` is invalid.
    """
    file_of: dict[str, str] = {}
    for file, text in library.files.items():
        if file.endswith(".py"):
            skill_files.require_python(text, file)
        for skill in skills_in(file, text):
            if skill.name in file_of:
                message = Phrase("library-two-skills", skill=skill.name, file=file_of[skill.name])
                raise LibraryError(file, [Diagnostic("two-skills", message, skill.place.line)])
            file_of[skill.name] = file
    if not file_of:
        message = Phrase("library-no-skill")
        raise LibraryError(where, [Diagnostic("no-skill", message)])
    if library.configurations:
        load_configurations(library.configurations)


def _texts(files: Mapping[str, bytes], where: str) -> dict[str, str]:
    if MANIFEST not in files:
        message = Phrase("library-no-manifest", manifest=MANIFEST)
        raise LibraryError(where, [Diagnostic("no-manifest", message)])
    if len(files) > MOST_FILES or sum(map(len, files.values())) > LARGEST:
        message = Phrase("library-limits", most=MOST_FILES, limit=LARGEST)
        raise LibraryError(where, [Diagnostic("too-large", message)])
    return {name: _text(name, content) for name, content in files.items()}


def _text(name: str, content: bytes) -> str:
    if name not in {MANIFEST, FUNCTIONS, CONFIGURATIONS} and not _is_module(name):
        file_names = (MANIFEST, FUNCTIONS, CONFIGURATIONS)
        message = Phrase("library-unknown-file", known=file_names)
        raise LibraryError(name, [Diagnostic("unknown-file", message)])
    if len(content) > skill_files.LARGEST:
        message = Phrase("library-file-too-large", limit=skill_files.LARGEST)
        raise LibraryError(name, [Diagnostic("too-large", message)])
    try:
        return plain_lines(content.decode("utf-8-sig"))
    except UnicodeDecodeError:
        message = Phrase("library-not-utf-8")
        raise LibraryError(name, [Diagnostic("not-utf-8", message)]) from None


def plain_lines(text: str) -> str:
    """A text with the line endings of library files."""
    return text.replace("\r\n", "\n").replace("\r", "\n")


def _is_module(name: str) -> bool:
    return _MODULE.fullmatch(name) is not None and not iskeyword(name.removesuffix(".py"))


def _functions(text: str) -> str:
    """The functions of a library, formatted; other statements are refused."""
    if not text.strip():
        return ""
    program = language.parse(text, FUNCTIONS)
    others = [
        item for item in program.items if not isinstance(item, Def | Assign | Comment | Blank)
    ]
    if others or program.main:
        line = others[0].span.line if others else program.main.span.line if program.main else 0
        message = Phrase("library-other-statement")
        raise LibraryError(FUNCTIONS, [Diagnostic("not-in-library", message, line)], text)
    for function in program.functions.values():
        refuse_name(function.name, FUNCTIONS, function.span.line)
    return extracted(program, program.functions, FUNCTIONS)


def refuse_name(name: str, filename: str, line: int) -> None:
    """Refuse a function whose name a skill cannot have.

    Raises:
        LibraryError: Python uses the name, or it begins with an underscore.
    """
    if name.startswith("_") or names.to_python(name) != name:
        message = Phrase("library-python-name", name=name)
        raise LibraryError(filename, [Diagnostic("skill-name", message, line)])


def _hand_written(modules: Mapping[str, str], *, alone: bool) -> Iterator[tuple[str, str]]:
    """The modules without a generated ``__init__.py``.

    Raises:
        LibraryError: there are other files beside a hand-written one.
        ProgramError: a file is not valid Python.
    """
    for name, text in modules.items():
        tree = skill_files.parse(text, name)
        if name != PACKAGE or (alone and len(modules) == 1):
            yield name, text
        elif any(skill_files.functions(tree)):
            message = Phrase("library-functions-in-package", file=PACKAGE)
            raise LibraryError(PACKAGE, [Diagnostic("not-in-library", message)])


def _package(name: str, files: Mapping[str, str]) -> str:
    modules = sorted(file.removesuffix(".py") for file in files if file.endswith(".py"))
    return (
        f'"""The library {name}, made by LearnBlock."""\n\n'
        f"from . import {', '.join(modules)}\n\n"
        "__all__: list[str] = []\n"
    )
