"""Libraries of the original LearnBlock: ``NAME/NAME.lb``, with ``NAME.py`` and ``NAME.conf``."""

import re
from collections.abc import Mapping
from dataclasses import dataclass, replace
from pathlib import Path, PurePath
from typing import Self

import msgspec

from learnblock.blocks import BlockConfiguration
from learnblock.blocks.schema.writing import written
from learnblock.errors import Diagnostic, FileError, LearnBlockError, ProjectError
from learnblock.extensions import libraries
from learnblock.extensions.libraries import Library
from learnblock.i18n import Phrase
from learnblock.importing.conversion import Imported
from learnblock.importing.old_text import LARGEST_LIBRARY, decoded, parse_old
from learnblock.importing.report import ImportReport, Reporting
from learnblock.language import format as format_program
from learnblock.language.tree.nodes import Blank, Comment, Def, Item, Program
from learnblock.storage import skill_files

LIBRARY_ENDING = ".lb"

_NAME = re.compile(r"\w[\w .-]*")


@dataclass(frozen=True)
class LibraryFiles:
    """The files of a library of the original LearnBlock.

    Args:
        filename: the file name or path of its ``.lb`` file.
        text: the content of that file.
        python: that of its ``.py`` file, if it has one.
        configuration: that of its ``.conf`` file, if it has one.
    """

    filename: str
    text: bytes
    python: bytes | None = None
    configuration: bytes | None = None

    @classmethod
    def at(cls, path: Path) -> Self:
        """The library with this ``.lb`` file; the others are in the same folder.

        Raises:
            OSError: a file can't be read.
        """
        others = (_read_if_there(path.with_suffix(ending)) for ending in (".py", ".conf"))
        return cls(str(path), _read(path), *others)

    def beside(self, ending: str) -> str:
        """The name of the file with another ending."""
        return PurePath(self.filename).with_suffix(ending).name


@dataclass(frozen=True)
class ImportedLibrary:
    """A library that was imported.

    Args:
        blocktext: its functions.
        library: the same as a library; None if its functions can only be used in a program.
        report: what changed and what is missing.
    """

    blocktext: str
    library: Library | None
    report: ImportReport


def import_library(
    files: LibraryFiles, skills: Mapping[str, BlockConfiguration]
) -> ImportedLibrary:
    """Import a library of the original LearnBlock.

    Args:
        files: its files.
        skills: the known skills, by name.

    Raises:
        FileError: the library can't be read.
    """
    reporting = Reporting()
    whole = parse_old(files.text, files.filename, skills, reporting)
    program = _only_functions(whole)
    if whole.main is not None or len(program.items) < len(_statements(whole)):
        reporting.miss(Phrase("import-not-only-functions"))
        return ImportedLibrary(format_program(whole), None, reporting.report())
    if not program.functions:
        message = Phrase("import-no-functions")
        raise ProjectError(files.filename, [Diagnostic("no-functions", message)])
    described = _described(files, program, reporting)
    _report_python(files, program, reporting)
    library = _made(files.filename, program, described, reporting)
    return ImportedLibrary(format_program(program), library, reporting.report())


def import_text(data: bytes, filename: str, skills: Mapping[str, BlockConfiguration]) -> Imported:
    """Import a program in the Block-Text of the original LearnBlock.

    Raises:
        FileError: it is too large, or isn't Block-Text.
    """
    reporting = Reporting()
    program = parse_old(data, filename, skills, reporting)
    return Imported(format_program(program), None, reporting.report())


def find_library(folder: Path, name: str) -> bytes | None:
    """Find a library with a folder in `folder` or next to it; return its ``.lb`` file, or None."""
    if not _NAME.fullmatch(name):
        return None
    for place in (folder / name, folder.parent / name):
        content = _read_if_there(place / f"{name}{LIBRARY_ENDING}")
        if content is not None:
            return content
    return None


def _statements(program: Program) -> tuple[Item, ...]:
    return tuple(item for item in program.items if not isinstance(item, Blank | Comment))


def _only_functions(program: Program) -> Program:
    return Program(tuple(item for item in program.items if isinstance(item, Def)))


def _read(path: Path) -> bytes:
    with path.open("rb") as file:
        return file.read(LARGEST_LIBRARY + 1)


def _read_if_there(path: Path) -> bytes | None:
    return _read(path) if path.is_file() else None


class _OldBlock(msgspec.Struct):
    """What a library needs of a block configuration of the original LearnBlock."""

    name: str
    languages: dict[str, str] = {}
    tooltip: dict[str, str] = {}


def _described(files: LibraryFiles, program: Program, reporting: Reporting) -> dict[str, _OldBlock]:
    """The words of the library's blocks, if they can be read."""
    if files.configuration is None:
        return {}
    name = files.beside(".conf")
    try:
        blocks = msgspec.json.decode(decoded(files.configuration, name), type=list[_OldBlock])
    except (msgspec.MsgspecError, RecursionError) as error:
        reporting.miss(Phrase("import-not-readable", name=name, reason=str(error)))
        return {}
    for block in blocks:
        if block.name not in program.functions:
            reporting.miss(Phrase("import-no-block", name=block.name[:100]))
    return {block.name: block for block in blocks}


def _report_python(files: LibraryFiles, program: Program, reporting: Reporting) -> None:
    """Report functions that are only in Python: they use the old robot."""
    if files.python is None:
        return
    name = files.beside(".py")
    try:
        functions = skill_files.functions(skill_files.parse(decoded(files.python, name), name))
    except FileError as error:
        reporting.miss(Phrase("import-not-readable", name=name, reason=error.phrase))
        return
    only = tuple(function.name for function in functions if function.name not in program.functions)
    if only:
        reporting.miss(Phrase("import-python-only", name=name, functions=only))


def _made(
    filename: str,
    program: Program,
    described: Mapping[str, _OldBlock],
    reporting: Reporting,
) -> Library | None:
    stem = PurePath(filename).stem
    manifest = libraries.manifest(_library_name(stem), "1.0.0", {"en": stem[:60]})
    try:
        library = libraries.make(manifest, program, list(program.functions), (), filename)
    except LearnBlockError as error:
        reporting.miss(Phrase("import-not-a-library", reason=error.phrase))
        return None
    blocks = [_labelled(skill, described.get(skill.name)) for skill in library.skills.values()]
    return replace(library, configurations=written(blocks))


def _labelled(block: BlockConfiguration, old: _OldBlock | None) -> BlockConfiguration:
    """A block with the words that its old configuration has."""
    if old is None:
        return block
    return replace(
        block, languages=old.languages or block.languages, tooltip=old.tooltip or block.tooltip
    )


def _library_name(stem: str) -> str:
    name = re.sub(r"[^a-z0-9_]", "_", stem.lower())[:40]
    return name if name[:1].isalpha() else f"library_{name}"[:40]
