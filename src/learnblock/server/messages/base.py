"""Types that all messages share, and who may send a message in a class."""

from enum import StrEnum
from typing import Annotated, ClassVar, Literal, NamedTuple

from msgspec import Meta, MsgspecError, Struct, json

from learnblock.project.document.views import LONGEST_TEXT

#: The limit in characters of other files, such as blocks or a library.
LONGEST_FILE = 1_000_000
#: The limit of a file with a picture in it: a world, or a project with its world.
LONGEST_CONTENT = 3_500_000

StateName = Literal["idle", "starting", "running", "paused", "held", "input", "done", "ended"]
Text = Annotated[str, Meta(max_length=LONGEST_TEXT)]
FileText = Annotated[str, Meta(max_length=LONGEST_FILE)]
Name = Annotated[str, Meta(min_length=1, max_length=100)]
#: A name or an empty string.
ShortText = Annotated[str, Meta(max_length=100)]
Coordinate = Annotated[float, Meta(ge=-5000, le=5000)]


class Message(Struct, tag_field="kind", omit_defaults=True, frozen=True):
    """A message of the conversation."""


class ToPage(Message, frozen=True):
    """A message to a page."""


class ToClass(Message, frozen=True):
    """A message to the server of a class, which takes it out of those to a page."""


class Role(StrEnum):
    """The role of a page in a class towards the program that it shows."""

    #: The pupil who owns the program.
    PUPIL = "pupil"
    #: The teacher, who only watches.
    WATCHER = "watcher"
    #: The teacher, allowed by the pupil to write.
    HELPER = "helper"


class Pace(NamedTuple):
    """How often something may be done: on average in a minute, and at once."""

    minute: float
    burst: int


# Why: docs/decisions.md, "A message says who may send it"
class FromPage(Message, frozen=True, kw_only=True):
    """A message from a page; its base is a class below, by who may send it in a class.

    Args:
        request: the page's number for it if it waits for the answer, which repeats the number:
            `Done`, `Failed`, or its `answer`.
    """

    #: Who may send it in a class.
    roles: ClassVar[frozenset[Role]]
    #: How often a person may send it in a class; None if it costs no more than others.
    pace: ClassVar[Pace | None] = None
    #: The kind of message that may answer a request besides `Done` and `Failed`, if there is one.
    answer: ClassVar[str] = ""

    request: Annotated[int, Meta(ge=0)] = 0

    def __init_subclass__(cls) -> None:
        """Refuse a message whose base does not say who may send it.

        Raises:
            TypeError: its base is not one of the roles below.
        """
        super().__init_subclass__()
        if not hasattr(cls, "roles"):
            raise TypeError(f"{cls.__name__} needs a base that says who may send it, such as Look")


class FromReader:
    """One that a page may also send while another server has the right to write.

    It writes neither to the projects nor to the user's folder. Robot, world, breakpoints and block
    set hold for a session, and are not saved.
    """

    __slots__ = ()


class Look(FromPage, FromReader, frozen=True):
    """Everyone who sees the program may send it."""

    roles: ClassVar = frozenset(Role)


class Write(FromPage, frozen=True):
    """Those who may change and run the program: the pupil, and a teacher allowed to write."""

    roles: ClassVar = frozenset({Role.PUPIL, Role.HELPER})


class Own(FromPage, frozen=True):
    """The pupil, the only one with the projects, the blocks and the stars."""

    roles: ClassVar = frozenset({Role.PUPIL})


class Teach(FromPage, frozen=True):
    """The teacher."""

    roles: ClassVar = frozenset({Role.WATCHER, Role.HELPER})


class Computer(FromPage, frozen=True):
    """No page in a class may send it: computer, robots and lessons are the teacher's.

    The teacher uses them in a separate LearnBlock.
    """

    roles: ClassVar = frozenset[Role]()


class ForClass(FromPage, frozen=True):
    """No page may send it, only the server of a class on behalf of a pupil's page."""

    roles: ClassVar = frozenset[Role]()


class Head(Struct, frozen=True):
    """What a refusal repeats of a message from a page, see `FromPage`."""

    kind: str = ""
    request: int = 0


_heads = json.Decoder(Head)


def head_of(text: str | bytes) -> Head:
    """The head of a message, also of one that is otherwise wrong; empty if it has none."""
    try:
        return _heads.decode(text)
    except (MsgspecError, UnicodeError, RecursionError):
        return Head()
