"""Programs with their robots, as they are named on the command line."""

import re
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import click

_ASSIGNED = re.compile(r"(?P<file>.+)@(?P<robot>[^@:]+)(?::(?P<count>[1-9][0-9]{0,3}))?")


@dataclass(frozen=True, slots=True)
class Assignment:
    """A program and its robots.

    Args:
        file: the program's file.
        robot: the name of the robot; None if it is not chosen here.
        count: how many such robots run it.
    """

    file: Path
    robot: str | None = None
    count: int = 1


class Assigned(click.Path):
    """``FILE``, ``FILE@ROBOT`` or ``FILE@ROBOT:COUNT``; a file with such a name comes first."""

    def __init__(self) -> None:
        super().__init__(exists=True, dir_okay=False)

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> Any:
        match = None if Path(value).is_file() else _ASSIGNED.fullmatch(str(value))
        if match is None:
            return Assignment(Path(str(super().convert(value, param, ctx))))
        file = Path(str(super().convert(match["file"], param, ctx)))
        return Assignment(file, match["robot"], int(match["count"] or 1))
