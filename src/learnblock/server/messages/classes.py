"""Messages about the teacher's classes, for *For teachers* on the start page."""

from typing import Annotated, ClassVar

from msgspec import Meta, Struct

from learnblock.blocks.block_sets import EVERYTHING, BuiltIn
from learnblock.i18n import Phrase
from learnblock.project.files.lesson_folder import LessonName
from learnblock.server.messages.base import Computer, ShortText, ToPage

#: The name of a class; the classroom says which are allowed.
ClassTitle = Annotated[str, Meta(min_length=1, max_length=40)]

# From the page.


class ListClasses(Computer, frozen=True):
    """Ask for the teacher's classes; the reply is `Classes`."""


class StartClass(Computer, frozen=True):
    """Open a class on this computer; the reply is `ClassOpened`, and `Classes` follows.

    Args:
        title: its name; a class of this name is opened again.
        lesson: with which pupils begin who have no project yet; None for none.
        project: the name of the projects that are made for the lesson.
        blocks: the block set of the projects that pupils begin themselves; a lesson has its own.
    """

    answer: ClassVar = "ClassOpened"

    title: ClassTitle
    lesson: LessonName | None = None
    project: ShortText = ""
    blocks: BuiltIn = EVERYTHING


class CloseClass(Computer, frozen=True):
    """Have a class save everything and close; `Classes` follows."""

    title: ClassTitle


class DeleteClass(Computer, frozen=True):
    """Delete a closed class with everything that its pupils have made; `Classes` follows."""

    title: ClassTitle


# To the page.


class ClassEntry(Struct, frozen=True, omit_defaults=True):
    """A class of the teacher's.

    Args:
        title: its name.
        pupils: how many have joined.
        used: when it was last used, in seconds since 1970.
        lesson: with which new pupils begin; None for none.
        project: the name of the projects that are made for it.
        blocks: the block set of the projects that pupils begin themselves.
        wall: the address of its wall while it is open; empty if it is closed.
        problem: why its file can't be read; None if it can.
    """

    title: str
    pupils: int = 0
    used: float = 0.0
    lesson: str | None = None
    project: str = ""
    blocks: BuiltIn = EVERYTHING
    wall: str = ""
    problem: Phrase | None = None


class Classes(ToPage, frozen=True):
    """The teacher's classes: the open ones first, then those that were used last."""

    classes: tuple[ClassEntry, ...]


class ClassOpened(ToPage, frozen=True):
    """A class is open.

    Args:
        wall: the address of its wall, with the teacher's key.
        request: as in `FromPage`.
    """

    wall: str
    request: int = 0
