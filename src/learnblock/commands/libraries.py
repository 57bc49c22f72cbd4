"""The command line's part for libraries: list, show, export, import, remove."""

import shutil
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from learnblock.console import print_json
from learnblock.errors import LearnBlockError

if TYPE_CHECKING:
    from learnblock.library import Library

_JSON = click.option("--json", "as_json", is_flag=True, help="Print JSON, for tools.")
_REPLACE = click.option("--replace", is_flag=True, help="Replace what is there already.")


@click.group("library")
def library_group() -> None:
    """Make libraries of functions and blocks of your own, and import those of others.

    \b
    learnblock library export dance.bt --functions waltz,polka --name dance --version 1.0.0
    learnblock library import dance.lblib songs.lblib
    learnblock library import dance.lblib --rename waltz=ball_waltz
    """  # noqa: D301 - click wants the character itself


@library_group.command("list")
@_JSON
def list_command(as_json: bool) -> None:  # noqa: FBT001 - a flag of click
    """List the libraries that are installed."""
    from learnblock.library import shelved  # noqa: PLC0415 - `--help` needs none of it

    found = shelved()
    if as_json:
        print_json([_row(one.name, one.library, one.problem) for one in found])
        return
    for one in found:
        if one.library is None:
            click.echo(f"{one.name:<16} broken: {one.problem}")
        else:
            version = one.library.manifest.version
            click.echo(f"{one.name:<16} {version:<8} {', '.join(one.library.skills)}")
    if not found:
        click.echo("no library is installed: learnblock library import FILE")


@library_group.command()
@click.argument("name")
@_JSON
def show(name: str, as_json: bool) -> None:  # noqa: FBT001 - a flag of click
    """Show a library: an installed one by its name, or one in a file or folder."""
    from learnblock.blocks.libraries import installed as names  # noqa: PLC0415
    from learnblock.library import find, installed  # noqa: PLC0415

    library = installed(name) if name in names() else find(name)
    if as_json:
        print_json(_row(library.name, library, ""))
        return
    click.echo(f"{library.name} {library.manifest.version}")
    if library.manifest.description:
        click.echo(library.manifest.description)
    for skill, block in library.skills.items():
        parameters = ", ".join(one.name for one in block.parameters)
        click.echo(f"  function.{skill}({parameters})  {block.tooltip.get('EN', '')}")


@library_group.command()
@click.argument(
    "file", required=False, type=click.Path(path_type=Path, exists=True, dir_okay=False)
)
@click.option("--functions", metavar="A,B", default="", help="Functions of the program in FILE.")
@click.option("--blocks", metavar="X,Y", default="", help="Blocks of your own.")
@click.option("--name", required=True, help="What programs import it by.")
@click.option("--version", default="1.0.0", show_default=True, help="One to three numbers.")
@click.option("--title", help="The tab of the palette, in English.")
@click.option(
    "--as",
    "form",
    type=click.Choice(["file", "folder"]),
    default="file",
    show_default=True,
    help="What to write into the folder that you are in.",
)
@_REPLACE
def export(
    file: Path | None,
    functions: str,
    blocks: str,
    *,
    form: str,
    replace: bool,
    **said: Any,
) -> None:
    """Make a library of functions of a program, and of blocks of your own.

    Functions take along those that they call.
    """
    from learnblock import language, library, running  # noqa: PLC0415

    program = running.read(file).tree if file else language.Program()
    title = {"en": said["title"]} if said["title"] else {}
    made = library.make(
        library.manifest(said["name"], said["version"], title),
        program,
        _names(functions),
        _names(blocks),
        str(file or ""),
    )
    target = Path(made.name if form == "folder" else made.name + library.ENDING)
    _clear(target, replace=replace)
    if form == "folder":
        library.write(made, target)
    else:
        target.write_bytes(library.pack(made))
    click.echo(f"{target}: {', '.join(made.skills)}")


@library_group.command("import")
@click.argument("addresses", metavar="LIBRARY...", nargs=-1, required=True)
@click.option(
    "--rename",
    "renames",
    metavar="SKILL=NEW",
    multiple=True,
    help="Another name for a skill, where somebody has that name already.",
)
@_REPLACE
def import_command(addresses: tuple[str, ...], renames: tuple[str, ...], *, replace: bool) -> None:
    """Install libraries: files, folders, file:// addresses, or names in this folder.

    Nothing in them is run. All are installed, or none.
    """
    from learnblock import library  # noqa: PLC0415

    found = [library.find(address) for address in addresses]
    names = dict(map(_renaming, renames))
    for name in names:
        if not any(name in one.skills for one in found):
            raise LearnBlockError(f"--rename {name}: no library that comes has such a skill")
    chosen = [
        library.renamed(one, {old: new for old, new in names.items() if old in one.skills})
        for one in found
    ]
    new = library.install(chosen, replace=replace)
    for one in chosen:
        word = "imported" if one in new else "is there just so already:"
        click.echo(f"{word} {one.name} {one.manifest.version}: {', '.join(one.skills)}")


@library_group.command()
@click.argument("name")
def remove(name: str) -> None:
    """Take an installed library away; the last of each name is kept in libraries/.trash."""
    from learnblock import library  # noqa: PLC0415

    library.remove(name)
    click.echo(f"removed {name}")


def _row(name: str, library: "Library | None", problem: str) -> dict[str, object]:
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


def _renaming(text: str) -> tuple[str, str]:
    name, equals, new = text.partition("=")
    if not (name and equals and new):
        raise click.UsageError(f"--rename {text}: write SKILL=NEW, such as waltz=ball_waltz")
    return name.strip(), new.strip()


def _clear(target: Path, *, replace: bool) -> None:
    """Make room for what is to be written, and only there where a library lies.

    Raises:
        LearnBlockError: something is there.
    """
    from learnblock.blocks.libraries import MANIFEST  # noqa: PLC0415

    if not target.exists():
        return
    if not replace:
        raise LearnBlockError(f"{target} is there already: give --replace, or another --name")
    if target.is_dir():
        if not (target / MANIFEST).is_file():
            raise LearnBlockError(f"{target} is a folder of something else: give another --name")
        shutil.rmtree(target)
