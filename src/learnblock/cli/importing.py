"""The command that imports programs of the original LearnBlock."""

import sys
from collections.abc import Callable, Container, Iterator, Mapping
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, TypeAlias

import click

from learnblock.cli.console import (
    ExitCode,
    json_option,
    print_diagnostics,
    print_json,
    say,
    text,
)
from learnblock.errors import Diagnostic, FileError, ProjectError
from learnblock.i18n import Phrase

if TYPE_CHECKING:
    from learnblock.importing import Imported, ImportReport

#: The ending of the new file, its content, and what changed.
_Converted: TypeAlias = "tuple[str, bytes, ImportReport]"
_Converter = Callable[[Path], _Converted]


@click.command("import")
@click.argument(
    "paths",
    metavar="FILE|FOLDER...",
    nargs=-1,
    required=True,
    type=click.Path(exists=True, path_type=Path),
)
@click.option(
    "--output",
    metavar="FOLDER",
    type=click.Path(file_okay=False, path_type=Path),
    default=Path(),
    help="Where to write the new files  [default: the current folder]",
)
@click.option(
    "--to",
    "notation",
    type=click.Choice(["project", "block-text"]),
    default="project",
    show_default=True,
    help="Whether to write projects for the page, or programs in Block-Text.",
)
@click.option("--replace", is_flag=True, help="Replace existing files.")
@json_option
def import_command(
    paths: tuple[Path, ...], output: Path, notation: str, *, replace: bool, as_json: bool
) -> None:
    """Import programs of the original LearnBlock.

    A project (.blockProject, of versions 1 to 3) becomes a .learnblock project with its blocks in
    their places, and a library (NAME.lb) becomes a library (.lblib). In a folder, every project and
    library is imported. Nothing in the files is run. What changed and what could not be carried
    over is listed; the exit code is 1 if a file could not be imported.

    \b
    learnblock import square.blockProject
    learnblock import old-projects --output projects
    learnblock import square.blockProject --to block-text
    """  # noqa: D301 - click wants the character itself
    from learnblock import importing  # noqa: PLC0415 - `--help` needs none of it

    convert = {
        importing.ENDING: _program if notation == "block-text" else _project,
        importing.LIBRARY_ENDING: _library,
    }
    outcomes = [
        _imported(source, output / place, convert, replace=replace)
        for source, place in _found(paths, convert)
    ]
    if as_json:
        print_json([outcome.as_object() for outcome in outcomes])
    else:
        for outcome in outcomes:
            outcome.print()
    sys.exit(ExitCode.MISTAKES if any(outcome.error for outcome in outcomes) else ExitCode.WELL)


@dataclass(frozen=True)
class _Done:
    """A file that was imported, or not.

    Args:
        source: the file.
        target: the new file.
        report: what changed and what is missing.
        error: why it was not imported.
    """

    source: Path
    target: Path | None = None
    report: "ImportReport | None" = None
    error: FileError | None = None

    def print(self) -> None:
        if self.error is not None:
            print_diagnostics(self.error.filename, self.error.diagnostics, "", err=True)
            return
        say("import-imported", file=str(self.source), target=str(self.target))
        if self.report is not None:
            print_report(self.report)

    def as_object(self) -> dict[str, object]:
        return {
            "file": str(self.source),
            "written": self.target and str(self.target),
            "changed": self.report.changed if self.report else (),
            "missing": self.report.missing if self.report else (),
            "error": str(self.error.phrase) if self.error else None,
        }


def print_report(report: "ImportReport") -> None:
    """List what an import changed, and what it could not carry over."""
    _print_list("import-changed", report.changed)
    _print_list("import-missing", report.missing)


def _print_list(heading: str, phrases: tuple[Phrase, ...]) -> None:
    if phrases:
        click.echo(f"  {text(Phrase(heading))}")
    for phrase in phrases:
        click.echo(f"    {text(phrase)}")


def _found(paths: tuple[Path, ...], endings: Container[str]) -> Iterator[tuple[Path, Path]]:
    """The files to import, each with the folder for its result."""
    for path in paths:
        if path.is_file():
            yield path, Path()
            continue
        files = [
            file for file in sorted(path.rglob("*")) if file.suffix in endings and file.is_file()
        ]
        if not files:
            message = Phrase("import-nothing", folder=str(path))
            raise ProjectError(str(path), [Diagnostic("nothing", message)])
        for file in files:
            yield file, file.relative_to(path).parent


def _imported(
    source: Path, folder: Path, convert: Mapping[str, _Converter], *, replace: bool
) -> _Done:
    try:
        if source.suffix not in convert:
            message = Phrase("import-type")
            raise ProjectError(str(source), [Diagnostic("unknown-file", message)])
        ending, content, report = convert[source.suffix](source)
        target = _written(folder / f"{source.stem}{ending}", content, replace=replace)
    except FileError as error:
        return _Done(source, error=error)
    return _Done(source, target, report)


def _project(source: Path) -> "_Converted":
    """A project for the page."""
    from learnblock.project.files import ENDING  # noqa: PLC0415
    from learnblock.project.files.project import Project  # noqa: PLC0415
    from learnblock.project.files.project_file import encode  # noqa: PLC0415

    imported = _read(source)
    project = Project(source.stem, imported.blocktext, workspace=imported.workspace)
    return ENDING, encode(project), imported.report


def _program(source: Path) -> "_Converted":
    """A program in Block-Text."""
    imported = _read(source)
    return ".bt", imported.blocktext.encode(), imported.report


def _read(source: Path) -> "Imported":
    from learnblock import importing  # noqa: PLC0415
    from learnblock.blocks.known import all_configurations  # noqa: PLC0415

    skills = all_configurations()
    with source.open("rb") as file:
        data = file.read(importing.LARGEST + 1)
    find_library = partial(importing.find_library, source.parent)
    return importing.import_project(data, str(source), skills, find_library)


def _library(source: Path) -> "_Converted":
    """A library, or a program of functions that can't be one."""
    from learnblock import importing  # noqa: PLC0415
    from learnblock.blocks.known import all_configurations  # noqa: PLC0415
    from learnblock.extensions import libraries  # noqa: PLC0415

    library = importing.import_library(importing.LibraryFiles.at(source), all_configurations())
    if library.library is None:
        return ".bt", library.blocktext.encode(), library.report
    return libraries.ENDING, libraries.pack(library.library), library.report


def _written(target: Path, content: bytes, *, replace: bool) -> Path:
    from learnblock.storage.files import save  # noqa: PLC0415

    if target.exists() and not replace:
        message = Phrase("import-exists", file=str(target))
        raise ProjectError(str(target), [Diagnostic("exists", message)])
    target.parent.mkdir(parents=True, exist_ok=True)
    save(target, content)
    return target
