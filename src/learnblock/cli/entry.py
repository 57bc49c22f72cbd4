"""`learnblock`: the page, and the commands that need none, such as `learnblock run`.

Each command is imported when it is called, so that `learnblock --help` is fast.
"""

from typing import Any

import click

from learnblock.cli.commands import Commands
from learnblock.cli.language import choose
from learnblock.cli.page_options import page_options
from learnblock.i18n import languages


@click.group(
    cls=Commands,
    invoke_without_command=True,
    context_settings={"help_option_names": ["-h", "--help"], "max_content_width": 100},
    epilog="Start with: learnblock. Or see what it does without a page: learnblock demo",
)
@click.option(
    "--language",
    type=click.Choice(languages()),
    is_eager=True,
    expose_value=False,
    callback=choose,
    help="Language of the output  [default: LEARNBLOCK_LANGUAGE, or the system's language]",
)
@click.version_option(package_name="learnblock-studio", prog_name="learnblock")
@page_options
@click.pass_context
def main(ctx: click.Context, /, **choices: Any) -> None:
    """Program any robot in blocks, Block-Text or Python, and run it in a simulated world.

    Without a command, it opens the page. The address holds a token that keeps others out.
    """
    if ctx.invoked_subcommand is None:
        from learnblock.cli.page import open_page  # noqa: PLC0415 - `--help` needs none of it

        open_page(None, **choices)
