"""Block-Text in notebooks: what the magic ``%%blocktext`` runs."""

import shlex
import sys
from argparse import ArgumentParser
from collections.abc import Sequence
from contextlib import chdir, redirect_stderr, suppress
from pathlib import Path
from tempfile import TemporaryDirectory

from learnblock import robots, running

#: The name of a cell in messages, and that of the picture of its run.
_CELL, _PICTURE = "cell.bt", "cell.svg"


class ProgramPicture:
    """A picture that notebooks show."""

    def __init__(self, svg: str) -> None:
        self._svg = svg

    def _repr_svg_(self) -> str:
        return self._svg

    def __repr__(self) -> str:
        return "<picture of a run>"


def blocktext(line: str, cell: str) -> ProgramPicture | None:
    """Run a cell in Block-Text, and show its world with the way that the robot drove.

        %%blocktext --robot sim-ev3 --world line

    Args:
        line: the options of `learnblock run`.
        cell: the program.
    """
    from learnblock.cli import main  # noqa: PLC0415 - a robot in a notebook needs none of it

    words = shlex.split(line)
    picture = ["--picture", _PICTURE] if _is_simulated(words) else []
    with TemporaryDirectory() as folder, chdir(folder):
        Path(_CELL).write_text(cell, "utf-8")
        # Notebooks show the standard error as a fault. The exit code is for shells.
        with suppress(SystemExit), redirect_stderr(sys.stdout):
            main(args=["run", *words, *picture, _CELL])
        drawn = Path(_PICTURE)
        return ProgramPicture(drawn.read_text("utf-8")) if drawn.exists() else None


def _is_simulated(words: Sequence[str]) -> bool:
    parser = ArgumentParser(add_help=False)
    parser.add_argument("--robot", default=running.DEFAULT_ROBOT)
    return robots.find(parser.parse_known_args(words)[0].robot).load().lockstep
