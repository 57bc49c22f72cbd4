"""`learnblock stubs`: types and help of the user's own robots and skills, for editors."""

from pathlib import Path

import click

from learnblock.cli.console import say


@click.command("stubs")
@click.argument("folder", type=click.Path(path_type=Path, file_okay=False), default=".")
def stubs_command(folder: Path) -> None:
    """Tell editors about your own robots and skills.

    Write their types and help as stub files, for type checkers too.

    FOLDER is that of your programs, by default the current folder.
    """
    from learnblock.stubs.own import write_stubs  # noqa: PLC0415 - `--help` needs none of it

    say("cli-wrote", file=str(write_stubs(folder)))


def renew_stubs() -> None:
    """Write the stubs in the user's folder again, and in the current one if it has some."""
    from learnblock.storage.home import home  # noqa: PLC0415 - `--help` needs none of it
    from learnblock.stubs.own import stub_package, write_stubs  # noqa: PLC0415 - as above

    write_stubs(home())
    if stub_package(Path.cwd()).is_dir():
        write_stubs(Path.cwd())
