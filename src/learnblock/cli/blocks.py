"""The commands for custom blocks: list, check, export and import."""

import sys
from pathlib import Path
from typing import TYPE_CHECKING

import click

from learnblock.cli.console import (
    ExitCode,
    json_option,
    print_diagnostics,
    print_json,
    say,
    text,
)
from learnblock.errors import CustomBlockError, Diagnostic
from learnblock.i18n import Phrase

if TYPE_CHECKING:
    from learnblock.extensions.custom_blocks import CustomBlock, Problem

_FILE = click.Path(path_type=Path, exists=True, dir_okay=False)


@click.group("blocks", invoke_without_command=True)
@json_option
@click.pass_context
def blocks_group(ctx: click.Context, as_json: bool) -> None:  # noqa: FBT001 - a click flag
    """List, check, export or import custom blocks.

    \b
    learnblock blocks check dance.py
    learnblock blocks export dance
    learnblock blocks import dance.block.json
    """  # noqa: D301 - click wants the character itself
    if ctx.invoked_subcommand is None:
        from learnblock.extensions import custom_blocks  # noqa: PLC0415 - `--help` needs none of it

        _print_list(custom_blocks.load_all(), as_json=as_json)


@blocks_group.command()
@click.argument("file", type=_FILE)
@click.option(
    "--configuration", type=_FILE, help="The configuration of its blocks: JSON as in blocks/."
)
@json_option
def check(file: Path, configuration: Path | None, as_json: bool) -> None:  # noqa: FBT001
    """Check a Python file of custom blocks without running it.

    The exit code is 1 if there are errors; warnings do not change it.
    """
    from learnblock.extensions import custom_blocks  # noqa: PLC0415
    from learnblock.storage import skill_files  # noqa: PLC0415

    source = skill_files.read(file)
    configuration_text = skill_files.read(configuration) if configuration else ""
    is_own = file.absolute() in [path.absolute() for path in skill_files.own_files()]
    replaces = file.stem if is_own else ""
    checked = custom_blocks.check(source, configuration_text, name=file.stem, replaces=replaces)
    files = {"configuration": (str(configuration), configuration_text)}
    rows = [
        (*files.get(problem.part, (str(file), source)), problem) for problem in checked.problems
    ]
    if as_json:
        print_json([_as_object(name, problem) for name, _, problem in rows])
    for name, code, problem in rows if not as_json else ():
        print_diagnostics(name, [problem.diagnostic], code)
    sys.exit(ExitCode.MISTAKES if checked.errors else ExitCode.WELL)


@blocks_group.command()
@click.argument("name", metavar="BLOCK")
@click.argument("file", required=False, type=click.Path(path_type=Path, dir_okay=False))
def export(name: str, file: Path | None) -> None:
    """Export a custom block to one file, to share it."""
    from learnblock.extensions import custom_blocks  # noqa: PLC0415
    from learnblock.storage.files import save  # noqa: PLC0415

    filename, content = custom_blocks.export(name)
    target = file or Path(filename)
    save(target, content.encode())
    say("cli-wrote", file=str(target))


@blocks_group.command("import")
@click.argument("file", type=_FILE)
@click.option("--replace", is_flag=True, help="Replace your block of the same name.")
def import_command(file: Path, replace: bool) -> None:  # noqa: FBT001 - a click flag
    """Import a custom block from an exported file, without running it."""
    from learnblock.extensions import custom_blocks  # noqa: PLC0415
    from learnblock.extensions.custom_blocks.package import LARGEST  # noqa: PLC0415

    try:
        with file.open(encoding="utf-8-sig") as opened:
            content = opened.read(LARGEST + 1)
    except UnicodeDecodeError as error:
        diagnostic = Diagnostic("not-utf-8", Phrase("block-not-utf-8"))
        raise CustomBlockError(str(file), [diagnostic]) from error
    block = custom_blocks.import_file(content, replace=replace)
    calls = ", ".join(f"function.{name}" for name in block.functions)
    click.echo(f"{block.name}: {calls}")


def _print_list(blocks: "tuple[CustomBlock, ...]", *, as_json: bool) -> None:
    if as_json:
        print_json([_listed(block) for block in blocks])
        return
    for block in blocks:
        click.echo(f"{block.name:<16} {', '.join(block.functions)}")
        for problem in block.problems:
            click.echo(f"    {problem.part}:{problem.diagnostic.line}: {_message(problem)}")
    if not blocks:
        say("cli-blocks-none")


def _message(problem: "Problem") -> str:
    return text(problem.diagnostic.message)


def _listed(block: "CustomBlock") -> dict[str, object]:
    return {
        "name": block.name,
        "category": block.category,
        "functions": block.functions,
        "problems": [_as_object(f"{block.name}.py", problem) for problem in block.problems],
    }


def _as_object(file: str, problem: "Problem") -> dict[str, object]:
    diagnostic = problem.diagnostic
    return {
        "file": file,
        "part": problem.part,
        "line": diagnostic.line,
        "column": diagnostic.column,
        "severity": diagnostic.severity,
        "code": diagnostic.code,
        "message": str(diagnostic.message),
    }
