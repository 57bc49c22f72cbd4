"""Messages about new robots, which are generated from a description."""

from typing import Annotated

from msgspec import Meta, Struct

from learnblock.i18n import Phrase
from learnblock.server.messages.base import Computer, FromReader, ShortText, ToPage
from learnblock.server.messages.projects import RobotChoice

#: The limit in characters; a description with every kind of device takes a tenth of it.
LONGEST_DESCRIPTION = 65_536

# From the page.


class BeginRobot(Computer, FromReader, frozen=True):
    """Ask for a description template; the reply is `RobotBegun`."""


class MakeRobot(Computer, frozen=True):
    """Generate a robot, its twin and its test from a description; the reply is `RobotMade`.

    Args:
        name: the id of the robot.
        description: TOML, as described in docs/add-a-robot.md.
    """

    name: ShortText
    description: Annotated[str, Meta(max_length=LONGEST_DESCRIPTION)]


# To the page.


class RobotBegun(ToPage, frozen=True):
    """A description template."""

    description: str


class RobotProblem(Struct, frozen=True, omit_defaults=True):
    """A mistake in a description; line 0 means the whole text."""

    message: Phrase
    line: int = 0


class RobotMade(ToPage, frozen=True):
    """A robot was generated and can be chosen, unless there are problems.

    Args:
        name: the id of the robot; its twin has the prefix ``sim-``.
        files: the paths of its files.
        problems: the mistakes in its description; if there are any, no file was written.
    """

    name: str
    files: tuple[str, ...] = ()
    problems: tuple[RobotProblem, ...] = ()


class Robots(ToPage, frozen=True):
    """All robots; sent to every page when there is a new one."""

    robots: tuple[RobotChoice, ...]
