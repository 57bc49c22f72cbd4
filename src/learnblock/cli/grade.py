"""The command that grades a class's programs by a lesson's checks."""

import sys
from pathlib import Path
from typing import Any

import click

from learnblock.cli.console import ExitCode, usage_error

_HANDED_IN = click.Path(exists=True, path_type=Path)
_FOLDER = click.Path(file_okay=False, path_type=Path)


@click.command()
@click.argument("handed_in", nargs=-1, type=_HANDED_IN, metavar="[HANDED_IN]...")
@click.option(
    "--class",
    "class_name",
    metavar="NAME",
    help="Grade this class: each pupil's hand-in or, without one, the newest program of the step.",
)
@click.option(
    "--only-handed-in",
    is_flag=True,
    help="With --class: leave out pupils who have not handed in.",
)
@click.option(
    "--lesson", required=True, metavar="LESSON", help="The lesson's name, file or folder."
)
@click.option(
    "--step", type=click.IntRange(min=1), help="The step  [default: the last one with checks]"
)
@click.option(
    "--variants",
    type=click.IntRange(0, 1000),
    help="Also try this many variants of the world  [default: the step's]",
)
@click.option("--robots", metavar="NAME,NAME", help="The robots  [default: the step's]")
@click.option(
    "--jobs", type=click.IntRange(1, 1024), help="Runs at once  [default: the processors]"
)
@click.option("--scheduler", metavar="ADDRESS", help="Run on the Dask cluster at this address.")
@click.option("--out", required=True, type=_FOLDER, help="The folder for the results.")
def grade_command(handed_in: tuple[Path, ...], robots: str | None, **choices: Any) -> None:
    """Grade a class's programs by a lesson's checks.

    HANDED_IN are programs (.bt, .py or .learnblock), or folders or zips with one program or one
    folder for each pupil, as Moodle and Google Classroom give them; or --class names a class of
    `learnblock class`. The results are results.csv and results.html in the folder of --out. The
    same command again makes only what is missing. No mark is final: the teacher decides.

    \b
    learnblock grade square-4b.zip --lesson 1-03-square --out results
    learnblock grade class-4b --lesson line-follower --variants 10 --out results
    learnblock grade --class 7b --lesson 1-03-square --out results
    learnblock grade class-4b --lesson tags.lblesson --robots sim-ebo,sim-thymio --out results
    learnblock grade class-4b --lesson tags --scheduler tcp://192.168.1.7:8786 --out results
    """  # noqa: D301 - click wants the character itself
    if choices["jobs"] and choices["scheduler"]:
        raise usage_error("grade-jobs-or-scheduler")
    if bool(handed_in) == bool(choices["class_name"]):
        raise usage_error("grade-files-or-class")
    # Imported here because `--help` needs none of it.
    from learnblock.cli.grading import Choices, grade  # noqa: PLC0415

    robot_names = None if robots is None else tuple(filter(None, robots.split(",")))
    finished = grade(handed_in, Choices(robots=robot_names, **choices))
    sys.exit(ExitCode.WELL if finished else ExitCode.INTERRUPTED)
