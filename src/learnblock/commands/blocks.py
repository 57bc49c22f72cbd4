"""The command line's part for blocks of one's own: list, check, export, import."""

import sys
from pathlib import Path
from typing import TYPE_CHECKING

import click

from learnblock.console import ExitCode, print_json

if TYPE_CHECKING:
    from learnblock.own_blocks import OwnBlock, Problem

_JSON = click.option("--json", "as_json", is_flag=True, help="Print JSON, for tools.")
_FILE = click.Path(path_type=Path, exists=True, dir_okay=False)


@click.group("blocks", invoke_without_command=True)
@_JSON
@click.pass_context
def blocks_group(ctx: click.Context, as_json: bool) -> None:  # noqa: FBT001 - a flag of click
    r"""List the blocks of your own; or check a file, give a block away, add one.

    \b
    learnblock blocks check dance.py
    learnblock blocks export dance
    learnblock blocks import dance.block.json
    """
    if ctx.invoked_subcommand is None:
        from learnblock.own_blocks import own_blocks  # noqa: PLC0415 - `--help` needs none of it

        _print_list(own_blocks(), as_json=as_json)


@blocks_group.command()
@click.argument("file", type=_FILE)
@click.option(
    "--configuration", type=_FILE, help="What is chosen for its blocks: JSON as in blocks/."
)
@_JSON
def check(file: Path, configuration: Path | None, as_json: bool) -> None:  # noqa: FBT001
    """Say what is wrong with a file of blocks, without running it.

    Exits with 1 when there are errors; warnings alone are no failure.
    """
    from learnblock import own_blocks, skill_files  # noqa: PLC0415

    source = skill_files.read(file)
    chosen = skill_files.read(configuration) if configuration else ""
    is_own = file.absolute() in [path.absolute() for path in skill_files.own_files()]
    replaces = file.stem if is_own else ""
    checked = own_blocks.check(source, chosen, name=file.stem, replaces=replaces)
    files = {"configuration": (str(configuration), chosen)}
    told = [(*files.get(one.part, (str(file), source)), one) for one in checked.problems]
    if as_json:
        print_json([_as_object(name, one) for name, _, one in told])
    for name, text, one in told if not as_json else ():
        _print(name, text, one)
    sys.exit(ExitCode.MISTAKES if checked.errors else ExitCode.WELL)


@blocks_group.command()
@click.argument("name", metavar="BLOCK")
@click.argument("file", required=False, type=click.Path(path_type=Path, dir_okay=False))
def export(name: str, file: Path | None) -> None:
    """Write a block of your own into one file, to be given to others."""
    from learnblock import own_blocks  # noqa: PLC0415
    from learnblock.files import save  # noqa: PLC0415

    filename, text = own_blocks.export(name)
    target = file or Path(filename)
    save(target, text.encode())
    click.echo(f"wrote {target}")


@blocks_group.command("import")
@click.argument("file", type=_FILE)
@click.option("--replace", is_flag=True, help="Replace your block of the same name.")
def import_command(file: Path, replace: bool) -> None:  # noqa: FBT001 - a flag of click
    """Add the block in a file that was exported. Nothing in it is run."""
    from learnblock import own_blocks  # noqa: PLC0415
    from learnblock.own_blocks.package import LARGEST  # noqa: PLC0415

    with file.open(encoding="utf-8", errors="replace") as opened:
        block = own_blocks.import_file(opened.read(LARGEST + 1), replace=replace)
    calls = ", ".join(f"function.{name}" for name in block.functions)
    click.echo(f"{block.name}: {calls}")


def _print_list(blocks: "tuple[OwnBlock, ...]", *, as_json: bool) -> None:
    if as_json:
        print_json([_listed(one) for one in blocks])
        return
    for one in blocks:
        click.echo(f"{one.name:<16} {', '.join(one.functions)}")
        for problem in one.problems:
            click.echo(f"    {problem.part}: {_sentence(problem)}")
    if not blocks:
        click.echo("there is none yet: make one in the page, or learnblock blocks import FILE")


def _listed(block: "OwnBlock") -> dict[str, object]:
    return {
        "name": block.name,
        "category": block.category,
        "functions": block.functions,
        "problems": [_as_object(f"{block.name}.py", one) for one in block.problems],
    }


def _as_object(file: str, problem: "Problem") -> dict[str, object]:
    one = problem.diagnostic
    return {
        "file": file,
        "part": problem.part,
        "line": one.line,
        "column": one.column,
        "severity": one.severity,
        "code": one.code,
        "message": one.message,
    }


def _sentence(problem: "Problem") -> str:
    one = problem.diagnostic
    return f"line {one.line}: {one.message}" if one.line else one.message


def _print(filename: str, text: str, problem: "Problem") -> None:
    click.echo(problem.diagnostic.located(filename))
    if pointed := problem.diagnostic.pointed(text):
        click.echo(pointed)
