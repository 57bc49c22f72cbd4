"""What pupils' pages and the class exchange when two pupils play in one world."""

from typing import Literal

from msgspec import Struct

from learnblock.classroom.roster import PupilId
from learnblock.server.messages.base import Message, Own

# From a pupil's page.


class AskClassmates(Own, frozen=True):
    """Ask who can be invited; `Classmates` follows."""


class Invite(Own, frozen=True):
    """Invite a classmate to drive a robot in the world of the open project."""

    pupil: PupilId


class AnswerInvitation(Own, frozen=True):
    """Accept an invitation, or decline it."""

    on: bool


class LeaveWorld(Own, frozen=True):
    """Leave the shared world, or take the invitation back."""


# To it.


class Classmate(Struct, frozen=True):
    """A pupil who can be invited.

    Args:
        id: the pupil's.
        name: what the teacher calls the pupil.
    """

    id: str
    name: str


class Classmates(Message, frozen=True):
    """Who can be invited."""

    pupils: tuple[Classmate, ...] = ()


class InPair(Message, frozen=True):
    """With whom the pupil shares a world.

    Args:
        allowed: whether the teacher lets pupils share worlds.
        state: whether the pupil is alone, inviting, invited, a host or a guest.
        other: the name of the other pupil.
        robot: the name of the guest's robot.
        away: whether the guest's page does not show the world at the moment.
    """

    allowed: bool = False
    state: Literal["alone", "inviting", "invited", "host", "guest"] = "alone"
    other: str = ""
    robot: str = ""
    away: bool = False


# From the wall.


class LetShareWorlds(Message, frozen=True):
    """Let pupils play in each other's worlds, or no more."""

    on: bool


FromPlayer = AskClassmates | Invite | AnswerInvitation | LeaveWorld
ToPlayer = InPair | Classmates
