"""What the parts of the command line share: exit codes, and JSON for tools."""

from collections.abc import Sequence
from enum import IntEnum
from typing import TYPE_CHECKING, Any

import click

if TYPE_CHECKING:
    from learnblock.settings import Described


class ExitCode(IntEnum):
    """How a command ended, for scripts."""

    WELL = 0
    #: A file has mistakes, or a check failed.
    MISTAKES = 1
    #: The command was wrong: an option, or a file, robot or world that is not there.
    USAGE = 2
    #: The program ended with an error.
    PROGRAM_FAILED = 3
    #: The program had to be stopped, or was killed.
    PROGRAM_STOPPED = 4
    #: Ctrl-C.
    INTERRUPTED = 130


def print_json(value: object) -> None:
    """Print a value as indented JSON."""
    import msgspec  # noqa: PLC0415 - `--help` needs none of it

    click.echo(msgspec.json.format(msgspec.json.encode(value), indent=2))


def print_settings(settings: "Sequence[Described]", *, as_json: bool) -> None:
    """Print settings, one a line, with what each may be."""
    if as_json:
        print_json(settings)
        return
    width = max(len(one.name) for one in settings) + 1
    for one in settings:
        mark = "" if one.value == one.default else f"  [default: {shown(one.default)}]"
        click.echo(f"{one.name:<{width}} {shown(one.value):<22} {one.allowed}{mark}")


def shown(value: Any) -> str:
    """A setting's value as it is typed."""
    return value if isinstance(value, str) and value else repr(value)
