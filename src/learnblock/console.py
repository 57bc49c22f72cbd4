"""What the parts of the command line share: exit codes, and JSON for tools."""

from enum import IntEnum

import click


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
