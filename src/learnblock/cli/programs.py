"""The commands for programs: run, demo, check, format and convert."""

import gc
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from learnblock.cli.assignment import Assigned, Assignment
from learnblock.cli.console import (
    EXISTING_FILE,
    ExitCode,
    json_option,
    print_diagnostics,
    print_json,
    say,
    usage_error,
    warn,
)
from learnblock.errors import Diagnostic, FileError, LearnBlockError

if TYPE_CHECKING:
    from learnblock.runtime.standby import Standby

_NEW_FILE = click.Path(path_type=Path, dir_okay=False)
#: A file, or a folder for the logs of several robots.
_LOG = click.Path(path_type=Path)
_PROGRAM = click.argument("file", type=EXISTING_FILE)
_VARIANT = click.IntRange(min=0)
_VARIANTS = click.IntRange(1, 1000)
#: The endings of files, as short names of notations.
_NOTATIONS = {"py": "python", "bt": "block-text"}
_ROBOT = click.option("--robot", metavar="NAME", help="The robot: see learnblock robots.")


@click.command()
@click.argument(
    "programs", nargs=-1, required=True, type=Assigned(), metavar="FILE[@ROBOT[:COUNT]]..."
)
@_ROBOT
@click.option("--world", metavar="NAME", help="The world's name or file.")
@click.option("--seed", type=int, help="Seed of all noise; the same seed gives the same run.")
@click.option("--variant", type=_VARIANT, help="A variant of the world; 0 is as it is drawn.")
@click.option("--variants", type=_VARIANTS, help="Run in the variants 1 to this number.")
@click.option(
    "--pace",
    metavar="free|real|FACTOR",
    help="Speed: as fast as possible (default), real time, or this many times faster.",
)
@click.option(
    "--for",
    "seconds",
    type=click.FloatRange(min=0, min_open=True),
    help="Stop after this many seconds of the robot's time  [default: 300 at pace free]",
)
@click.option("--trace", type=_NEW_FILE, help="Write the trace as JSON Lines.")
@click.option("--why", type=_LOG, help="Write a log for questions: see learnblock why.")
@click.option("--picture", type=_NEW_FILE, help="Draw the world and the path as .png or .svg.")
@click.option("--page", type=_NEW_FILE, help="Write a page to take home, which shows the run.")
@click.option("--name", "pupil", metavar="NAME", help="Say on that page who made it.")
@click.option("--keys", type=EXISTING_FILE, help="Press the keys in this file: see docs/games.md.")
@click.option("--anyway", is_flag=True, help="Run even if the robot lacks a device it needs.")
@click.option("--allow-network", is_flag=True, help="Let the program use the network.")
@json_option
def run(programs: tuple[Assignment, ...], **choices: Any) -> None:
    """Run programs (.bt, .py or .learnblock) on robots.

    \b
    learnblock run examples/square.bt --robot sim-ev3 --picture square.png
    learnblock run examples/line-states.bt --world line --for 60 --pace 5
    learnblock run examples/dance.bt@sim-ebo:3 examples/square.bt@sim-ev3
    learnblock run examples/avoid.bt --world arena --for 60 --variants 20
    """  # noqa: D301 - click wants the character itself
    # As little as possible, and none of it for `--help`.
    from learnblock.runtime.standby import Standby  # noqa: PLC0415

    if choices["variants"] or sum(program.count for program in programs) > 1:
        sys.exit(_run(programs, None, **choices))
    # It loads what programs need while we load the rest.
    with Standby() as standby:
        sys.exit(_run(programs, standby, **choices))


def _run(
    programs: tuple[Assignment, ...],
    standby: "Standby | None",
    *,
    variants: int | None,
    robot: str | None,
    **choices: Any,
) -> int:
    """Run programs, and return the exit code."""
    with _loading():
        # Imported here because `--help` needs none of it.
        from learnblock.cli.reporting import run_and_report  # noqa: PLC0415
        from learnblock.project.files.programs import robots_in  # noqa: PLC0415

    count = sum(program.count * robots_in(program.file) for program in programs)
    if variants and count > 1:
        raise usage_error("report-variants-alone")
    if choices["why"] and variants:
        raise usage_error("report-why-alone")
    if choices["page"] and variants:
        raise usage_error("report-page-alone")
    if choices["pupil"] and not choices["page"]:
        raise usage_error("report-name-without-page")
    if count > 1:
        from learnblock.cli.team import run_team  # noqa: PLC0415 - most runs have one robot

        return run_team(programs, robot=robot, **choices)
    choices["robot"] = programs[0].robot or robot
    if variants:
        from learnblock.cli.variants import run_variants  # noqa: PLC0415 - most runs have none

        del choices["why"], choices["page"], choices["pupil"]
        return run_variants(programs[0].file, variants=variants, **choices)
    return run_and_report(programs[0].file, standby=standby, **choices)


@contextmanager
def _loading() -> Iterator[None]:
    """Collect no garbage while modules load: it takes a tenth of the time, and they stay."""
    gc.disable()
    try:
        yield
    finally:
        gc.freeze()
        gc.enable()


@click.command()
@click.option("--picture", type=_NEW_FILE, help="The file of the drawing.")
def demo(picture: Path | None) -> None:
    """Run a demonstration in the simulator, and draw it.

    A simulated EBO looks for tags, drives up to each one and shows a feeling.
    """
    from learnblock.cli.reporting import demonstrate  # noqa: PLC0415

    sys.exit(demonstrate(picture or Path("learnblock-demo.png")))


@click.command()
@click.argument("files", nargs=-1, required=True, type=EXISTING_FILE, metavar="FILE...")
@_ROBOT
@click.option("--all-robots", is_flag=True, help="Say which robots can run each program.")
@json_option
def check(
    files: tuple[Path, ...],
    robot: str | None,
    all_robots: bool,  # noqa: FBT001 - a click flag
    as_json: bool,  # noqa: FBT001
) -> None:
    """Check programs for mistakes without running them.

    With --robot, also checks that this robot has what each program needs. The exit code is 1 if
    there are errors; warnings do not change it.

    \b
    learnblock check square.bt --robot sim-thymio
    learnblock check examples/*.bt --all-robots
    """  # noqa: D301 - click wants the character itself
    if all_robots:
        if robot:
            raise usage_error("cli-one-or-all-robots")
        from learnblock.cli.robot_table import print_robots  # noqa: PLC0415

        sys.exit(print_robots(files, as_json=as_json))
    results = {file: _diagnose(file, robot) for file in files}
    if as_json:
        print_json(
            [
                _as_object(file, diagnostic)
                for file, (all_, _) in results.items()
                for diagnostic in all_
            ]
        )
    else:
        for file, (diagnostics, text) in results.items():
            print_diagnostics(str(file), diagnostics, text)
            if not diagnostics:
                say("cli-no-problems", file=str(file))
    errors = [
        diagnostic
        for all_, _ in results.values()
        for diagnostic in all_
        if diagnostic.severity == "error"
    ]
    sys.exit(ExitCode.MISTAKES if errors else ExitCode.WELL)


@click.command("format")
@click.argument("files", nargs=-1, required=True, type=EXISTING_FILE, metavar="FILE.bt...")
@click.option("--check", "only_check", is_flag=True, help="Change nothing; exit 1 if it would.")
@click.option("--stdout", "to_stdout", is_flag=True, help="Print the result; change nothing.")
@json_option
def format_command(
    files: tuple[Path, ...],
    only_check: bool,  # noqa: FBT001 - a click flag
    to_stdout: bool,  # noqa: FBT001
    as_json: bool,  # noqa: FBT001
) -> None:
    """Format Block-Text programs.

    The style is fixed: four spaces per level, and one space where needed.
    """
    changed_files = [
        file for file in files if _format(file, only_check=only_check, to_stdout=to_stdout)
    ]
    if as_json:
        print_json({"changed": [str(file) for file in changed_files]})
    elif not to_stdout:
        for file in changed_files:
            say("cli-would-change" if only_check else "cli-formatted", file=str(file))
    sys.exit(ExitCode.MISTAKES if only_check and changed_files else ExitCode.WELL)


@click.command()
@_PROGRAM
@click.option(
    "--to",
    "notation",
    required=True,
    type=click.Choice(["python", "block-text", "py", "bt"]),
    help="The notation to convert to.",
)
@_ROBOT
@json_option
def convert(file: Path, notation: str, robot: str | None, as_json: bool) -> None:  # noqa: FBT001
    """Convert a program between Block-Text and Python.

    The result goes to standard output.

    \b
    learnblock convert square.bt --to python --robot ev3 > square.py
    """  # noqa: D301 - click wants the character itself
    from learnblock import language, robots, running  # noqa: PLC0415

    source = running.read(file)
    notation = _NOTATIONS.get(notation, notation)
    if notation == "block-text":
        text = language.format(source.tree)
    else:
        robot_module = robots.module_of(robot or running.DEFAULT_ROBOT)
        module = None if source.is_python and not robot else robot_module
        text = language.to_python(source.tree, module).text
    if as_json:
        print_json({"file": str(file), "to": notation, "text": text})
    else:
        click.echo(text, nl=False)


def _diagnose(file: Path, robot: str | None) -> tuple[list[Diagnostic], str]:
    """A program's diagnostics, and its text for the caret."""
    from learnblock import robots, running  # noqa: PLC0415
    from learnblock.project.files.programs import read  # noqa: PLC0415

    entry = robots.find(robot) if robot else None
    try:
        source = read(file, warn)
    except FileError as error:
        return list(error.diagnostics), error.source
    return running.check(source, entry), source.text


def _format(file: Path, *, only_check: bool, to_stdout: bool) -> bool:
    """Format one file; return whether that changes it."""
    from learnblock import language, running  # noqa: PLC0415
    from learnblock.storage.files import save  # noqa: PLC0415

    if file.suffix.lower() != ".bt":
        raise LearnBlockError("cli-format-only-block-text", file=str(file))
    source = running.read(file)
    text = language.format(source.tree)
    is_different = text != source.text
    if to_stdout:
        click.echo(text, nl=False)
    elif is_different and not only_check:
        save(file, text.encode())
    return is_different


def _as_object(file: Path, diagnostic: Diagnostic) -> dict[str, object]:
    return {
        "file": str(file),
        "line": diagnostic.line,
        "column": diagnostic.column,
        "end_column": diagnostic.end_column,
        "severity": diagnostic.severity,
        "code": diagnostic.code,
        "message": str(diagnostic.message),
    }
