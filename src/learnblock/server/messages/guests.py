"""What a class and pupils' servers tell each other when two pupils play in one world.

The run is the host's; the guest's program drives one of its robots.
"""

from typing import Literal

from learnblock.server.messages.base import ForClass, FromReader, Name, ShortText, ToClass
from learnblock.server.messages.seats import GivenProgram

#: What a project lacks for a guest; empty if nothing.
Lack = Literal["", "project", "lesson", "robot"]


class FindGuestRobot(ForClass, FromReader, frozen=True):
    """Ask the host's server for a robot that a guest's program can drive; see `GuestRobot`."""


class GuestRobot(ToClass, frozen=True):
    """The robot of the open project for a guest.

    Args:
        project: the name of the project.
        tab: the name of the robot.
        lack: what the project lacks for a guest.
    """

    project: ShortText = ""
    tab: ShortText = ""
    lack: Lack = ""


class GiveProgram(ForClass, FromReader, frozen=True):
    """Ask the guest's server for the program that the page shows; see `ProgramGiven`."""


class ProgramGiven(ToClass, frozen=True):
    """The program that a page shows.

    Args:
        program: the program; None if none is open.
        mistakes: whether it has errors.
    """

    program: GivenProgram | None = None
    mistakes: bool = False


class KeepKeysApart(ForClass, frozen=True):
    """Hold the keys of this page, a guest's, for the robot that it shows, and for no other."""


class TakeGuest(ForClass, frozen=True):
    """Let the robot that this page of a guest shows run the guest's program; see `GuestTaken`.

    It does so until the page has gone.

    Args:
        name: of the guest.
        program: the guest's.
    """

    name: Name
    program: GivenProgram


class GuestTaken(ToClass, frozen=True):
    """Whether the guest's program is ready to run.

    Args:
        fits: whether it can run on the robot.
    """

    fits: bool = False
