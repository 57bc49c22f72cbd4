"""Libraries of the original LearnBlock: ``NAME/NAME.lb``, with ``NAME.py`` and ``NAME.conf``."""

import re
from collections.abc import Mapping
from dataclasses import dataclass, replace
from pathlib import Path

import msgspec

from learnblock.blocks import BlockConfiguration
from learnblock.blocks.schema.writing import written
from learnblock.errors import Diagnostic, FileError, LearnBlockError, ProjectError
from learnblock.extensions import libraries
from learnblock.extensions.libraries import Library
from learnblock.i18n import Phrase
from learnblock.importing.conversion import Imported
from learnblock.importing.old_text import parse_old
from learnblock.importing.report import Report, Reporting
from learnblock.language import format as format_program
from learnblock.language.tree.nodes import Blank, Comment, Def, Item, Program
from learnblock.storage import skill_files

LIBRARY_ENDING = ".lb"
#: Bytes of a file of a library.
LARGEST = 1024 * 1024

_NAME = re.compile(r"\w[\w .-]*")


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
    report: Report


def import_library(path: Path, skills: Mapping[str, BlockConfiguration]) -> ImportedLibrary:
    """Import a library of the original LearnBlock.

    Args:
        path: its ``.lb`` file; the ``.py`` and ``.conf`` are beside it.
        skills: the known skills, by name.

    Raises:
        FileError: the file can't be read.
        OSError: the system does not let us read it.
    """
    reporting = Reporting()
    whole = parse_old(_text(path), str(path), skills, reporting)
    program = _only_functions(whole)
    if whole.main is not None or len(program.items) < len(_statements(whole)):
        return ImportedLibrary(format_program(whole), None, reporting.report())
    if not program.functions:
        message = Phrase("import-no-functions")
        raise ProjectError(str(path), [Diagnostic("no-functions", message)])
    described = _described(path.with_suffix(".conf"), program, reporting)
    _report_python(path.with_suffix(".py"), program, reporting)
    made = _made(path, program, described, reporting)
    return ImportedLibrary(format_program(program), made, reporting.report())


def import_text(data: bytes, filename: str, skills: Mapping[str, BlockConfiguration]) -> Imported:
    """Import a program in the Block-Text of the original LearnBlock.

    Raises:
        FileError: it is too large, or is no Block-Text.
    """
    reporting = Reporting()
    program = parse_old(_decoded(data, filename), filename, skills, reporting)
    return Imported(format_program(program), None, reporting.report())


def find_library(
    folder: Path, name: str, skills: Mapping[str, BlockConfiguration]
) -> dict[str, Def] | None:
    """The functions of a library whose folder is in `folder` or beside it, or None."""
    if not _NAME.fullmatch(name):
        return None
    for place in (folder / name, folder.parent / name):
        path = place / f"{name}{LIBRARY_ENDING}"
        if path.is_file():
            program = parse_old(_text(path), str(path), skills, Reporting())
            return dict(program.functions)
    return None


def _statements(program: Program) -> tuple[Item, ...]:
    return tuple(one for one in program.items if not isinstance(one, Blank | Comment))


def _only_functions(program: Program) -> Program:
    return Program(tuple(one for one in program.items if isinstance(one, Def)))


def _text(path: Path) -> str:
    with path.open("rb") as file:
        return _decoded(file.read(LARGEST + 1), str(path))


def _decoded(data: bytes, filename: str) -> str:
    if len(data) > LARGEST:
        message = Phrase("import-too-large", size=len(data), limit=LARGEST)
        raise ProjectError(filename, [Diagnostic("too-large", message)])
    return data.decode("utf-8", "replace")


class _OldBlock(msgspec.Struct):
    """What a library needs of a block configuration of the original LearnBlock."""

    name: str
    languages: dict[str, str] = {}
    tooltip: dict[str, str] = {}


def _described(path: Path, program: Program, reporting: Reporting) -> dict[str, _OldBlock]:
    """The words of the library's blocks, if they can be read."""
    if not path.is_file():
        return {}
    try:
        found = msgspec.json.decode(_text(path), type=list[_OldBlock])
    except (msgspec.MsgspecError, RecursionError) as error:
        reporting.miss(Phrase("import-not-readable", name=path.name, reason=str(error)))
        return {}
    for block in found:
        if block.name not in program.functions:
            reporting.miss(Phrase("import-no-block", name=block.name[:100]))
    return {block.name: block for block in found}


def _report_python(path: Path, program: Program, reporting: Reporting) -> None:
    """Report functions that are only in Python: they use the old robot."""
    if not path.is_file():
        return
    try:
        functions = skill_files.functions(skill_files.parse(_text(path), path.name))
    except FileError as error:
        reporting.miss(Phrase("import-not-readable", name=path.name, reason=error.phrase))
        return
    only = tuple(one.name for one in functions if one.name not in program.functions)
    if only:
        reporting.miss(Phrase("import-python-only", name=path.name, functions=only))


def _made(
    path: Path,
    program: Program,
    described: Mapping[str, _OldBlock],
    reporting: Reporting,
) -> Library | None:
    manifest = libraries.manifest(_library_name(path.stem), "1.0.0", {"en": path.stem[:60]})
    try:
        made = libraries.make(manifest, program, list(program.functions), (), str(path))
    except LearnBlockError as error:
        reporting.miss(Phrase("import-not-a-library", reason=error.phrase))
        return None
    blocks = [_labelled(one, described.get(one.name)) for one in made.skills.values()]
    return replace(made, configurations=written(blocks))


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
