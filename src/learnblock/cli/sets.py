"""The command that lists the block sets."""

import click

from learnblock.cli.console import json_option, print_diagnostics, print_json
from learnblock.cli.language import language


@click.command("sets")
@json_option
def sets_command(as_json: bool) -> None:  # noqa: FBT001 - a click flag
    """List the block sets.

    These are the built-in sets and your own sets.
    """
    from learnblock.blocks import block_sets  # noqa: PLC0415 - `--help` needs none of it

    own, wrong = block_sets.own()
    sets = (*block_sets.built_in().values(), *own)
    if as_json:
        print_json(sets)
        return
    for block_set in sets:
        about = _in_language(block_set.description) or _in_language(block_set.title)
        click.echo(f"{block_set.name:<20} {about}".rstrip())
    for error in wrong:
        print_diagnostics(error.filename, error.diagnostics, "", err=True)


def _in_language(texts: dict[str, str]) -> str:
    return texts.get(language()) or texts.get("en", "")
