"""The command line's part for sets of blocks: their list."""

import click

from learnblock.console import print_json


@click.command("sets")
@click.option("--json", "as_json", is_flag=True, help="Print JSON, for tools.")
def sets_command(as_json: bool) -> None:  # noqa: FBT001 - a flag of click
    """List the sets of blocks that the page can show: ours, and those of your own."""
    from learnblock.blocks import block_sets  # noqa: PLC0415 - `--help` needs none of it

    own, wrong = block_sets.own()
    found = (*block_sets.built_in().values(), *own)
    if as_json:
        print_json(found)
        return
    for one in found:
        about = one.description.get("en") or one.title.get("en", "")
        click.echo(f"{one.name:<20} {about}".rstrip())
    for error in wrong:
        click.echo(f"learnblock: {error}", err=True)
