"""A library as a value, and as the files that it consists of."""

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from functools import cached_property
from keyword import iskeyword
from types import MappingProxyType

from learnblock import language, skill_files
from learnblock.blocks import BlockConfiguration, load_configurations
from learnblock.blocks.libraries import CONFIGURATIONS, MANIFEST, blocks, skills_in
from learnblock.errors import Diagnostic, LibraryError
from learnblock.language import names
from learnblock.language.extraction import extracted
from learnblock.language.nodes import Assign, Blank, Comment, Def
from learnblock.language.skill_writer import to_skills
from learnblock.library.manifest import Manifest, read_manifest, write_manifest

#: The Block-Text of the functions that were made from blocks.
FUNCTIONS = "functions.bt"
#: What every Python package begins with.
PACKAGE = "__init__.py"
MOST_FILES = 100
#: Bytes of all files together; a person writes a hundredth of it.
LARGEST = 4 * 1024 * 1024

_MADE = "functions.py"
_MODULE = re.compile(r"[a-z][a-z0-9_]{0,59}\.py|__init__\.py")


@dataclass(frozen=True)
class Library:
    """Skills that programs import together.

    Args:
        manifest: what it says of itself.
        functions: those made from blocks, in Block-Text.
        modules: Python by the file's name; a hand-written ``__init__.py`` stands alone.
        configurations: what else is said of the blocks, as JSON; empty for nothing.
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
        """The text of each file by its name; what can be made is made."""
        found = {MANIFEST: write_manifest(self.manifest), **self.modules}
        if self.functions:
            found[FUNCTIONS] = self.functions
            found[_MADE] = to_skills(language.parse(self.functions, FUNCTIONS), FUNCTIONS)
        if PACKAGE not in found:
            found[PACKAGE] = _package(self.name, found)
        if self.configurations:
            found[CONFIGURATIONS] = self.configurations
        return MappingProxyType(dict(sorted(found.items())))

    @cached_property
    def skills(self) -> Mapping[str, BlockConfiguration]:
        """The blocks of its skills by name."""
        return MappingProxyType({one.name: one for one in blocks(self.name, self.files)})


def from_files(files: Mapping[str, bytes], where: str) -> Library:
    """The library that files are; nothing in them is run.

    Args:
        files: the content of each by its name.
        where: the folder or file they come from, for errors.

    Raises:
        LibraryError: they are no library, or there are files that none has.
        ProgramError: a file is no Python, or no Block-Text.
        BlockConfigurationError: ``blocks.json`` is wrong.
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
        LibraryError: there are none, or two of one name.
        ProgramError: a file is no Python.
        BlockConfigurationError: ``blocks.json`` is wrong.
    """
    seen: dict[str, str] = {}
    for file, text in library.files.items():
        if file.endswith(".py"):
            skill_files.require_python(text, file)
        for skill in skills_in(file, text):
            if skill.name in seen:
                message = f"the skill `{skill.name}` stands in {seen[skill.name]} as well: keep one"
                raise LibraryError(file, [Diagnostic("two-skills", message, skill.place.line)])
            seen[skill.name] = file
    if not seen:
        message = "there is no skill in it: a function whose first parameter is called `robot`"
        raise LibraryError(where, [Diagnostic("no-skill", message)])
    if library.configurations:
        load_configurations(library.configurations)


def _texts(files: Mapping[str, bytes], where: str) -> dict[str, str]:
    if MANIFEST not in files:
        message = f"this is no library: there is no {MANIFEST} in it"
        raise LibraryError(where, [Diagnostic("no-manifest", message)])
    if len(files) > MOST_FILES or sum(map(len, files.values())) > LARGEST:
        message = f"a library has at most {MOST_FILES} files with {LARGEST:,} bytes together"
        raise LibraryError(where, [Diagnostic("too-large", message)])
    return {name: _text(name, content) for name, content in files.items()}


def _text(name: str, content: bytes) -> str:
    if name not in {MANIFEST, FUNCTIONS, CONFIGURATIONS} and not _is_module(name):
        message = (
            f"a library holds {MANIFEST}, {FUNCTIONS}, {CONFIGURATIONS} and Python files with names"
            " in small letters, and nothing else"
        )
        raise LibraryError(name, [Diagnostic("unknown-file", message)])
    if len(content) > skill_files.LARGEST:
        message = f"the file is larger than {skill_files.LARGEST:,} bytes"
        raise LibraryError(name, [Diagnostic("too-large", message)])
    try:
        return plain_lines(content.decode("utf-8-sig"))
    except UnicodeDecodeError as error:
        message = f"byte {error.start} is not UTF-8; save the file as UTF-8"
        raise LibraryError(name, [Diagnostic("not-utf-8", message)]) from None


def plain_lines(text: str) -> str:
    """A text whose lines end as everywhere in a library."""
    return text.replace("\r\n", "\n").replace("\r", "\n")


def _is_module(name: str) -> bool:
    return _MODULE.fullmatch(name) is not None and not iskeyword(name.removesuffix(".py"))


def _functions(text: str) -> str:
    """The functions of a library in their one spelling, with nothing that a library has not."""
    if not text.strip():
        return ""
    program = language.parse(text, FUNCTIONS)
    others = [one for one in program.items if not isinstance(one, Def | Assign | Comment | Blank)]
    if others or program.main:
        line = others[0].span.line if others else program.main.span.line if program.main else 0
        message = "a library holds functions and the variables they share, and nothing else"
        raise LibraryError(FUNCTIONS, [Diagnostic("not-in-library", message, line)], text)
    for one in program.functions.values():
        refuse_name(one.name, FUNCTIONS, one.span.line)
    return extracted(program, program.functions, FUNCTIONS)


def refuse_name(name: str, filename: str, line: int) -> None:
    """Refuse a function whose name no skill can have.

    Raises:
        LibraryError: Python keeps the name to itself, or nobody would see it.
    """
    if name.startswith("_") or names.to_python(name) != name:
        message = f"`{name}` cannot be the name of a skill, since Python has it: rename it"
        raise LibraryError(filename, [Diagnostic("skill-name", message, line)])


def _hand_written(modules: Mapping[str, str], *, alone: bool) -> Iterator[tuple[str, str]]:
    """The modules without an ``__init__.py`` that is made anew.

    Raises:
        LibraryError: one that was written by hand stands beside others.
        ProgramError: a file is no Python.
    """
    for name, text in modules.items():
        tree = skill_files.parse(text, name)
        if name != PACKAGE or (alone and len(modules) == 1):
            yield name, text
        elif any(skill_files.functions(tree)):
            message = (
                f"{PACKAGE} is made anew where other files stand beside it: put its functions into"
                " a file of their own"
            )
            raise LibraryError(PACKAGE, [Diagnostic("not-in-library", message)])


def _package(name: str, files: Mapping[str, str]) -> str:
    modules = sorted(file.removesuffix(".py") for file in files if file.endswith(".py"))
    return (
        f'"""The library {name}, as LearnBlock makes it."""\n\n'
        f"from . import {', '.join(modules)}\n\n"
        "__all__: list[str] = []\n"
    )
