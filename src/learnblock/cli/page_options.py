"""The options of the commands that open the page."""

from collections.abc import Callable
from pathlib import Path

import click

_OPTIONS = (
    click.option(
        "--port",
        type=click.IntRange(0, 65535),
        help="Listen on this port  [default: 8421, or a free one if that is taken]",
    ),
    click.option("--host", metavar="ADDRESS", help="Listen on this address  [default: 127.0.0.1]"),
    click.option("--no-browser", is_flag=True, help="Only print the address of the page."),
    click.option("--window", is_flag=True, help="Show the page in a separate window."),
    click.option("--base-url", metavar="/PATH/", help="The path of the page behind a proxy."),
    click.option(
        "--allow-host",
        "allowed_hosts",
        metavar="NAME",
        multiple=True,
        help="A name that a proxy or the network uses for this computer.",
    ),
    click.option(
        "--unix-socket",
        type=click.Path(path_type=Path, dir_okay=False),
        help="Listen on this socket instead, for a proxy.",
    ),
    click.option(
        "--proxy-sends-token",
        is_flag=True,
        help="A proxy logs users in and sends the token (LEARNBLOCK_TOKEN) as a cookie.",
    ),
    click.option(
        "--new-token",
        is_flag=True,
        help="Change the page's address, so that the old one no longer opens it.",
    ),
    click.option(
        "--projects",
        type=click.Path(path_type=Path, file_okay=False),
        help="The folder of the projects.",
    ),
    click.option(
        "--take-over",
        is_flag=True,
        help="If another LearnBlock is using the folder, let it save everything and end.",
    ),
    click.option(
        "--read-only",
        is_flag=True,
        help="Open and run projects, but save nothing, so that another LearnBlock can go on.",
    ),
)


def page_options(command: Callable[..., None]) -> Callable[..., None]:
    """Add the options to a command."""
    for option in reversed(_OPTIONS):
        command = option(command)
    return command
