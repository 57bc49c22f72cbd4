"""What is said of robots that people describe, to have them made."""

from typing import Annotated

from msgspec import Meta, Struct

from learnblock.server.messages.base import Message, ShortText
from learnblock.server.messages.projects import RobotChoice

#: Characters; a description of every device there is takes a tenth of it.
LONGEST_DESCRIPTION = 65_536

# The page speaks.


class BeginRobot(Message, frozen=True):
    """Ask for a description to begin with: `RobotBegun`."""


class MakeRobot(Message, frozen=True):
    """Make a robot from its description, with its twin and its test: `RobotMade`.

    Args:
        name: its id.
        description: TOML, as docs/new.md says.
    """

    name: ShortText
    description: Annotated[str, Meta(max_length=LONGEST_DESCRIPTION)]


# The server speaks.


class RobotBegun(Message, frozen=True):
    """A description to begin with."""

    description: str


class RobotProblem(Struct, frozen=True, omit_defaults=True):
    """Something wrong with a description; line 0 is none in particular."""

    message: str
    line: int = 0


class RobotMade(Message, frozen=True):
    """A robot is made and can be chosen; or, where there are problems, it is not.

    Args:
        name: its id; its twin is ``sim-`` and this.
        files: what was written, by their paths.
        problems: what is wrong with its description; then nothing was written.
    """

    name: str
    files: tuple[str, ...] = ()
    problems: tuple[RobotProblem, ...] = ()


class Robots(Message, frozen=True):
    """The robots there are; told to every page when there is a new one."""

    robots: tuple[RobotChoice, ...]
