"""The commands for libraries: list, show, export, import and remove."""

from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from learnblock.cli.console import json_option, print_json, say, text, usage_error
from learnblock.cli.listing import tooltip
from learnblock.errors import LearnBlockError
from learnblock.i18n import Phrase

if TYPE_CHECKING:
    from learnblock.extensions.libraries import Library

_REPLACE = click.option("--replace", is_flag=True, help="Replace an existing library.")


@click.group("library")
def library_group() -> None:
    """Make, install or remove libraries of skills.

    \b
    learnblock library export dance.bt --functions waltz,polka --name dance --version 1.0.0
    learnblock library import dance.lblib songs.lblib
    learnblock library import dance.lblib --rename waltz=ball_waltz
    """  # noqa: D301 - click wants the character itself


@library_group.command("list")
@json_option
def list_command(as_json: bool) -> None:  # noqa: FBT001 - a click flag
    """List the installed libraries."""
    from learnblock.extensions.libraries import shelved  # noqa: PLC0415 - `--help` needs none of it

    shelf = shelved()
    if as_json:
        print_json([_row(entry.name, entry.library, entry.problem) for entry in shelf])
        return
    for entry in shelf:
        if entry.library is None:
            problem = Phrase("cli-library-broken", problem=entry.problem)
            click.echo(f"{entry.name:<16} {text(problem)}")
        else:
            version = entry.library.manifest.version
            click.echo(f"{entry.name:<16} {version:<8} {', '.join(entry.library.skills)}")
    if not shelf:
        say("cli-library-none")


@library_group.command()
@click.argument("name")
@json_option
def show(name: str, as_json: bool) -> None:  # noqa: FBT001 - a click flag
    """Show a library: an installed one, or one in a file or folder."""
    from learnblock.blocks.installed_libraries import installed as names  # noqa: PLC0415
    from learnblock.extensions.libraries import find, installed  # noqa: PLC0415

    library = installed(name) if name in names() else find(name)
    if as_json:
        print_json(_row(library.name, library, ""))
        return
    click.echo(f"{library.name} {library.manifest.version}")
    if library.manifest.description:
        click.echo(library.manifest.description)
    for skill, block in library.skills.items():
        parameters = ", ".join(parameter.name for parameter in block.parameters)
        click.echo(f"  function.{skill}({parameters})  {tooltip(block)}")


@library_group.command()
@click.argument(
    "file", required=False, type=click.Path(path_type=Path, exists=True, dir_okay=False)
)
@click.option("--functions", metavar="A,B", default="", help="Functions of the program in FILE.")
@click.option("--blocks", metavar="X,Y", default="", help="Custom blocks.")
@click.option("--name", required=True, help="The name that programs import.")
@click.option("--version", default="1.0.0", show_default=True, help="One to three numbers.")
@click.option("--title", help="The name of the palette tab, in English.")
@click.option(
    "--as",
    "form",
    type=click.Choice(["file", "folder"]),
    default="file",
    show_default=True,
    help="Whether to write a file or a folder.",
)
@_REPLACE
def export(
    file: Path | None,
    functions: str,
    blocks: str,
    *,
    form: str,
    replace: bool,
    **manifest: Any,
) -> None:
    """Make a library from functions of a program and from custom blocks.

    The functions that these functions call are added too. The library is written to the current
    folder.
    """
    from learnblock import language, running  # noqa: PLC0415
    from learnblock.extensions import libraries  # noqa: PLC0415

    program = running.read(file).tree if file else language.Program()
    title = {"en": manifest["title"]} if manifest["title"] else {}
    library = libraries.make(
        libraries.manifest(manifest["name"], manifest["version"], title),
        program,
        _names(functions),
        _names(blocks),
        str(file or ""),
    )
    target = Path(library.name if form == "folder" else library.name + libraries.ENDING)
    _clear(target, replace=replace)
    if form == "folder":
        libraries.write(library, target)
    else:
        target.write_bytes(libraries.pack(library))
    click.echo(f"{target}: {', '.join(library.skills)}")


@library_group.command("import")
@click.argument("addresses", metavar="LIBRARY...", nargs=-1, required=True)
@click.option(
    "--rename",
    "renames",
    metavar="SKILL=NEW",
    multiple=True,
    help="Rename a skill whose name is taken.",
)
@_REPLACE
def import_command(addresses: tuple[str, ...], renames: tuple[str, ...], *, replace: bool) -> None:
    """Install libraries without running them.

    A LIBRARY is a file, a folder, a file:// address, or a name in the current folder. If one of
    them cannot be installed, none is.
    """
    from learnblock.extensions import libraries  # noqa: PLC0415

    found_libraries = [libraries.find(address) for address in addresses]
    names = dict(map(_renaming, renames))
    for name in names:
        if not any(name in library.skills for library in found_libraries):
            raise LearnBlockError("cli-library-rename-unknown", skill=name)
    renamed_libraries = [
        libraries.renamed(
            library, {old: new for old, new in names.items() if old in library.skills}
        )
        for library in found_libraries
    ]
    new = libraries.install(renamed_libraries, replace=replace)
    for library in renamed_libraries:
        code = "cli-library-imported" if library in new else "cli-library-unchanged"
        say(code, name=library.name, version=library.manifest.version, skills=tuple(library.skills))


@library_group.command()
@click.argument("name")
def remove(name: str) -> None:
    """Remove an installed library.

    It is moved to the folder libraries/.trash.
    """
    from learnblock.extensions import libraries  # noqa: PLC0415

    libraries.remove(name)
    say("cli-library-removed", name=name)


def _row(name: str, library: "Library | None", problem: "Phrase | str") -> dict[str, object]:
    if library is None:
        return {"name": name, "problem": problem}
    manifest = library.manifest
    return {
        "name": name,
        "version": manifest.version,
        "title": manifest.title,
        "description": manifest.description,
        "skills": list(library.skills),
    }


def _names(text: str) -> list[str]:
    return [name.strip() for name in text.split(",") if name.strip()]


def _renaming(renaming: str) -> tuple[str, str]:
    name, equals, new = renaming.partition("=")
    if not (name and equals and new):
        raise usage_error("cli-library-rename-format", given=renaming)
    return name.strip(), new.strip()


def _clear(target: Path, *, replace: bool) -> None:
    """Remove the library that a new one replaces.

    Raises:
        LearnBlockError: replacing it is not allowed, or it is not a library.
    """
    import shutil  # noqa: PLC0415 - `--help` needs none of it

    from learnblock.blocks.installed_libraries import MANIFEST  # noqa: PLC0415

    if not target.exists():
        return
    if not replace:
        raise LearnBlockError("cli-library-exists", path=str(target))
    if target.is_dir():
        if not (target / MANIFEST).is_file():
            raise LearnBlockError("cli-library-other-folder", path=str(target))
        shutil.rmtree(target)
