"""The commands for tag names: the list, files of them, and tags on paper."""

from collections.abc import Mapping
from pathlib import Path

import click

from learnblock.cli.console import json_option, print_json, say
from learnblock.errors import UnknownNameError
from learnblock.storage.files import save

_FILE = click.argument("file", type=click.Path(path_type=Path, dir_okay=False))


@click.group("tags", invoke_without_command=True)
@json_option
@click.pass_context
def tags_group(ctx: click.Context, as_json: bool) -> None:  # noqa: FBT001 - a click flag
    """List, change, import, export or print tag names.

    \b
    learnblock tags set ball 3
    learnblock tags import tags.csv
    learnblock tags print ball 12
    """  # noqa: D301 - click wants the character itself
    if ctx.invoked_subcommand is None:
        names = _names()
        if as_json:
            print_json(names)
        for name, number in names.items() if not as_json else ():
            click.echo(f"{number:>3}  {name}")


@tags_group.command("set")
@click.argument("name")
@click.argument("number", type=int)
def set_command(name: str, number: int) -> None:
    """Give the tag with this NUMBER a NAME."""
    _save({**_names(), name: number})


@tags_group.command()
@click.argument("name")
def remove(name: str) -> None:
    """Remove a NAME."""
    names = _names()
    if name not in names:
        raise UnknownNameError("tag", name, names)
    _save({other: number for other, number in names.items() if other != name})


@tags_group.command("import")
@_FILE
@click.option("--replace", is_flag=True, help="Remove all other names.")
def import_command(file: Path, replace: bool) -> None:  # noqa: FBT001 - a click flag
    """Import the names in a FILE.

    The file is TOML with lines such as ball = 3, or CSV with a name and a number in each line.
    """
    from learnblock.perception import tag_names  # noqa: PLC0415 - `--help` needs none of it

    names = tag_names.read(file)
    _save({**({} if replace else _names()), **names})
    say("cli-tags-imported", count=len(names), file=str(file))


@tags_group.command()
@_FILE
def export(file: Path) -> None:
    """Export the names to a FILE: CSV if its name ends in .csv, otherwise TOML."""
    from learnblock.perception import tag_names  # noqa: PLC0415 - as above

    save(file, tag_names.write(_names(), as_csv=file.suffix.lower() == ".csv").encode())


@tags_group.command("print")
@click.argument("tags", nargs=-1, metavar="[NAME|NUMBER]...")
@click.option(
    "--side",
    type=click.FloatRange(10, 200),
    default=80.0,
    show_default=True,
    help="Side of the black square in mm.",
)
@click.option(
    "--output",
    type=click.Path(path_type=Path, dir_okay=False),
    default="tags.html",
    show_default=True,
    help="The file to write.",
)
def print_command(tags: tuple[str, ...], side: float, output: Path) -> None:
    """Create a page of tags to print with a browser: all named tags, or those given.

    Print the page at 100 %, and leave the white margin around each tag.
    """
    from learnblock.monitor.tag_sheet import sheet  # noqa: PLC0415 - as above
    from learnblock.perception.tag_names import tag_id  # noqa: PLC0415 - as above

    names = _names()
    selection = [(tag_id(tag), tag if tag in names else "") for tag in tags]
    all_tags = [(number, name) for name, number in names.items()]
    save(output, sheet(selection or all_tags, side).encode())
    say("cli-tags-print", file=str(output))


def _names() -> Mapping[str, int]:
    from learnblock.perception.tag_names import tag_names  # noqa: PLC0415 - as above

    return tag_names()


def _save(names: Mapping[str, int]) -> None:
    from learnblock.perception.tag_names import save_names  # noqa: PLC0415 - as above

    save_names(names)
