"""The command line's part for the dictionary of tags: names, files of them, and tags on paper."""

from collections.abc import Mapping
from pathlib import Path

import click

from learnblock.console import print_json
from learnblock.errors import UnknownNameError
from learnblock.files import save

_JSON = click.option("--json", "as_json", is_flag=True, help="Print JSON, for tools.")
_FILE = click.argument("file", type=click.Path(path_type=Path, dir_okay=False))


@click.group("tags", invoke_without_command=True)
@_JSON
@click.pass_context
def tags_group(ctx: click.Context, as_json: bool) -> None:  # noqa: FBT001 - a flag of click
    """List the names of tags; or give, remove, import, export or print them.

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
    """Have a NAME mean the tag of that NUMBER."""
    _save({**_names(), name: number})


@tags_group.command()
@click.argument("name")
def remove(name: str) -> None:
    """Forget a NAME."""
    names = _names()
    if name not in names:
        raise UnknownNameError("name of a tag", name, names)
    _save({one: number for one, number in names.items() if one != name})


@tags_group.command("import")
@_FILE
@click.option("--replace", is_flag=True, help="Forget all other names.")
def import_command(file: Path, replace: bool) -> None:  # noqa: FBT001 - a flag of click
    """Add the names in a FILE: TOML like `ball = 3`, or CSV with a name and a number in a line."""
    from learnblock import tag_names  # noqa: PLC0415 - `--help` needs none of it

    found = tag_names.parse(file.read_text("utf-8-sig", errors="replace"), str(file))
    _save({**({} if replace else _names()), **found})
    click.echo(f"names of tags in {file}: {len(found)}")


@tags_group.command()
@_FILE
def export(file: Path) -> None:
    """Write the names into a FILE: CSV where its name ends so, else TOML."""
    from learnblock import tag_names  # noqa: PLC0415 - as above

    save(file, tag_names.write(_names(), as_csv=file.suffix.lower() == ".csv").encode())


@tags_group.command("print")
@click.argument("tags", nargs=-1, metavar="[NAME|NUMBER]...")
@click.option("--side", type=click.FloatRange(10, 200), default=80.0, show_default=True, help="mm.")
@click.option("--output", type=click.Path(path_type=Path, dir_okay=False), default="tags.html")
def print_command(tags: tuple[str, ...], side: float, output: Path) -> None:
    """Make a page of tags, of all that have names or of those given, that a browser prints.

    The side is that of a tag's black square. Print the page at 100 %, and leave the white margin.
    """
    from learnblock.tag_names import tag_id  # noqa: PLC0415 - as above
    from learnblock.tag_sheet import sheet  # noqa: PLC0415 - as above

    names = _names()
    wanted = [(tag_id(tag), tag if tag in names else "") for tag in tags]
    named = [(number, name) for name, number in names.items()]
    save(output, sheet(wanted or named, side).encode())
    click.echo(f"open {output} in a browser, and print it at 100 %")


def _names() -> Mapping[str, int]:
    from learnblock.tag_names import tag_names  # noqa: PLC0415 - as above

    return tag_names()


def _save(names: Mapping[str, int]) -> None:
    from learnblock.tag_names import save_names  # noqa: PLC0415 - as above

    save_names(names)
