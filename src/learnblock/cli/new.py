"""The commands that create files: `learnblock new robot`, `skill` and `world`."""

from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING

import click

from learnblock.cli.console import print_command, say
from learnblock.cli.stubs import renew_stubs

if TYPE_CHECKING:
    from learnblock.monitor.worlds import Template
    from learnblock.new.robot_plan import RobotPlan

_FORCE = click.option("--force", is_flag=True, help="Replace existing files.")
_FOLDER = click.option(
    "--folder",
    type=click.Path(path_type=Path, file_okay=False),
    help="Write to this folder instead of your LearnBlock folder.",
)


@click.group("new")
def new_group() -> None:
    """Create the files of a new robot, skill or world.

    \b
    learnblock new robot
    learnblock new robot pathfinder --from pathfinder.toml
    learnblock new skill waltz
    learnblock new world garden
    learnblock new world labyrinth-7 --template maze --size 7 --seed 3
    """  # noqa: D301 - click wants the character itself


@new_group.command()
@click.argument("name", required=False)
@click.option(
    "--from",
    "description",
    type=click.Path(path_type=Path, exists=True, dir_okay=False),
    help="Read the robot's description from this TOML file (docs/add-a-robot.md) "
    "instead of asking.",
)
@click.option(
    "--folder",
    type=click.Path(path_type=Path, file_okay=False),
    help="Write a separate package there, to be installed with pip.",
)
@_FORCE
def robot(
    name: str | None,
    description: Path | None,
    folder: Path | None,
    force: bool,  # noqa: FBT001 - a click flag
) -> None:
    """Create a robot's client, its twin for the simulator, and a test of both.

    The twin works at once. In the client, you fill in the functions that talk to the hardware;
    each one describes what it must do.
    """
    from learnblock.new.robot import files_at_home, files_of_package  # noqa: PLC0415
    from learnblock.storage.home import home  # noqa: PLC0415 - `--help` needs none of it

    plan = _plan(name, description)
    files = files_of_package(plan, folder) if folder else files_at_home(plan, home())
    _write(files, force=force)
    renew_stubs()
    test = next(path for path in files if path.name.startswith("test_"))
    say("cli-new-next")
    if folder:
        print_command("pip", "install", "-e", f"{folder}[test]")
    print_command("learnblock", "run", "PROGRAM", "--robot", f"sim-{plan.name}")
    print_command("pytest", "-rs", test)
    say("cli-new-robot-test")


@new_group.command()
@click.argument("name")
@_FOLDER
@_FORCE
def skill(name: str, folder: Path | None, force: bool) -> None:  # noqa: FBT001 - a click flag
    """Create a skill with a test.

    The skill is a block at once.
    """
    from learnblock.new.skill import skill_files  # noqa: PLC0415
    from learnblock.storage.home import home  # noqa: PLC0415

    files = skill_files(name, folder or home())
    _write(files, force=force)
    renew_stubs()
    say("cli-new-skill", call=f"function.{name}()")


@new_group.command()
@click.argument("name")
@click.option(
    "--template",
    type=click.Choice(["field", "track", "maze"]),
    help="Make a field with obstacles, a track to follow or a maze.",
)
@click.option(
    "--size",
    type=click.IntRange(3, 8),
    default=5,
    show_default=True,
    help="How large a world from a template is.",
)
@click.option(
    "--seed",
    type=click.IntRange(0, 999_999),
    default=1,
    show_default=True,
    help="Which of the template's worlds: the same number makes the same world.",
)
@_FOLDER
@_FORCE
def world(
    *,
    name: str,
    template: "Template | None",
    size: int,
    seed: int,
    folder: Path | None,
    force: bool,
) -> None:
    """Create a world for the simulator, with one object of each kind, or from a template."""
    from learnblock.monitor.worlds import made_world  # noqa: PLC0415
    from learnblock.new.world import world_files  # noqa: PLC0415
    from learnblock.storage.home import home  # noqa: PLC0415

    world = made_world(template, size, seed) if template else None
    files = world_files(name, folder or home(), world)
    _write(files, force=force)
    world_argument = name if folder is None else str(next(iter(files)))
    say("cli-new-next")
    print_command("learnblock", "run", "PROGRAM", "--world", world_argument)


def _plan(name: str | None, description: Path | None) -> "RobotPlan":
    """The plan of the robot, from a file or from the user's answers."""
    from learnblock.cli.robot_questions import ask_plan  # noqa: PLC0415
    from learnblock.new.names import check_robot_name  # noqa: PLC0415
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
        say("cli-wrote", file=str(path))
