"""What pupils' pages and the class exchange when pupils show their programs."""

from typing import Annotated

from msgspec import Meta, Struct

from learnblock.classroom.roster import PupilId
from learnblock.project.files.share_link import LONGEST_LINK
from learnblock.server.messages.base import Message, Own

# From a pupil's page.


class ShowTeacher(Own, frozen=True):
    """Show the open project on the wall, until the teacher looks at it."""


class AskViewers(Own, frozen=True):
    """Ask to whom a program can be shown; `Classmates` follows."""


class ShowClassmate(Own, frozen=True):
    """Offer a classmate a copy of a project.

    Args:
        pupil: the classmate.
        link: holds the project.
    """

    pupil: PupilId
    link: Annotated[str, Meta(max_length=LONGEST_LINK)]


class AnswerOffer(Own, frozen=True):
    """Open the copy of a project that a classmate offers, or decline it.

    Args:
        pupil: the classmate.
        on: whether to open it.
    """

    pupil: PupilId
    on: bool


# To it.


class ProgramOffer(Struct, frozen=True):
    """A project that a classmate shows.

    Args:
        pupil: the classmate's id.
        name: what the teacher calls the classmate.
        project: the name of the project.
    """

    pupil: str
    name: str
    project: str


class ProgramOffers(Message, frozen=True):
    """What classmates show the pupil.

    Args:
        allowed: whether the teacher lets pupils show each other programs.
        offers: those without an answer, the oldest first.
    """

    allowed: bool = False
    offers: tuple[ProgramOffer, ...] = ()


# From the wall, and to it.


class LetShowPrograms(Message, frozen=True):
    """Let pupils show each other programs, or no more."""

    on: bool


class ShownToClassmate(Struct, frozen=True):
    """A program that a pupil has shown a classmate.

    Args:
        pupil: the id of the pupil.
        classmate: the id of the classmate.
        project: the name of the project.
    """

    pupil: str
    classmate: str
    project: str


FromShower = ShowTeacher | AskViewers | ShowClassmate | AnswerOffer
