"""The command line's part for what people add: `learnblock new robot`, `skill`, `world`."""

import shlex
from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING

import click

if TYPE_CHECKING:
    from learnblock.new.robot_plan import RobotPlan

_FORCE = click.option("--force", is_flag=True, help="Replace files that are there.")
_FOLDER = click.option(
    "--folder",
    type=click.Path(path_type=Path, file_okay=False),
    help="Write there instead of into your own folder of LearnBlock.",
)


@click.group("new")
def new_group() -> None:
    """Begin a robot, a skill or a world of your own: complete files, to be changed.

    \b
    learnblock new robot                              asks what there is to know
    learnblock new robot pathfinder --from pathfinder.toml
    learnblock new skill waltz
    learnblock new world garden
    """  # noqa: D301 - click wants the character itself


@new_group.command()
@click.argument("name", required=False)
@click.option(
    "--from",
    "description",
    type=click.Path(path_type=Path, exists=True, dir_okay=False),
    help="Ask nothing: the robot's description stands in this TOML file (docs/new.md).",
)
@click.option(
    "--folder",
    type=click.Path(path_type=Path, file_okay=False),
    help="Write a package of its own there, to be installed with pip.",
)
@_FORCE
def robot(
    name: str | None,
    description: Path | None,
    folder: Path | None,
    force: bool,  # noqa: FBT001 - a flag of click
) -> None:
    """Write a robot's client, its twin for the simulator, and their test.

    The twin runs at once. In the client, the functions that reach the hardware are left to be
    filled in; each says what it must do.
    """
    from learnblock.home import home  # noqa: PLC0415 - `--help` needs none of it
    from learnblock.new.robot import files_at_home, files_of_package  # noqa: PLC0415

    plan = _plan(name, description)
    files = files_of_package(plan, folder) if folder else files_at_home(plan, home())
    _write(files, force=force)
    test = next(path for path in files if path.name.startswith("test_"))
    if folder:
        click.echo(f"Next: pip install -e {shlex.quote(f'{folder}[test]')}, and then")
    else:
        click.echo("Next:")
    click.echo(f"    learnblock run PROGRAM --robot sim-{plan.name}")
    click.echo(f"    pytest -rs {shlex.quote(str(test))}")
    click.echo("The second one says which functions are left to be written, and what each must do.")


@new_group.command()
@click.argument("name")
@_FOLDER
@_FORCE
def skill(name: str, folder: Path | None, force: bool) -> None:  # noqa: FBT001 - a flag of click
    """Write a skill, which is a block at once, and its test."""
    from learnblock.home import home  # noqa: PLC0415
    from learnblock.new.skill import skill_files  # noqa: PLC0415

    files = skill_files(name, folder or home())
    _write(files, force=force)
    click.echo(f"Next: change what it does. In Block-Text it is function.{name}().")


@new_group.command()
@click.argument("name")
@_FOLDER
@_FORCE
def world(name: str, folder: Path | None, force: bool) -> None:  # noqa: FBT001 - a flag of click
    """Write a world for the simulator, with one thing of each kind."""
    from learnblock.home import home  # noqa: PLC0415
    from learnblock.new.world import world_files  # noqa: PLC0415

    files = world_files(name, folder or home())
    _write(files, force=force)
    given = name if folder is None else str(next(iter(files)))
    click.echo(f"Next: learnblock run PROGRAM --world {shlex.quote(given)}")


def _plan(name: str | None, description: Path | None) -> "RobotPlan":
    """What the robot is: as a file says it, or as the user answers."""
    from learnblock.new.names import check_robot_name  # noqa: PLC0415
    from learnblock.new.questions import ask_plan  # noqa: PLC0415
    from learnblock.new.robot_plan import named, read_plan  # noqa: PLC0415

    if name is not None:
        check_robot_name(name)
    if description is None:
        return ask_plan(name)
    plan = read_plan(description)
    plan = named(plan, name or plan.name or description.stem)
    check_robot_name(plan.name)
    return plan


def _write(files: Mapping[Path, str], *, force: bool) -> None:
    from learnblock.new.files import write_new  # noqa: PLC0415 - `--help` needs none of it

    write_new(files, force=force)
    for path in files:
        click.echo(f"wrote {path}")
