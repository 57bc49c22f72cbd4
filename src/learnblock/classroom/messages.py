"""The conversation of a class: with the teacher's wall, and what a pupil's page exchanges with it.

The build writes the page's types from this module (`learnblock.classroom.typescript`).
"""

from typing import Annotated, Literal

from msgspec import Meta, Struct

from learnblock.classroom.hand_in_messages import (
    FromHandInPages,
    HandInRun,
    ImproveHandIn,
    OwnHandIns,
    Pupils,
    ToHandInPages,
)
from learnblock.classroom.hand_ins import State
from learnblock.classroom.pair_messages import FromPlayer, LetShareWorlds, ToPlayer
from learnblock.classroom.pins import Picture, Pictures
from learnblock.classroom.roster import PupilId
from learnblock.classroom.show_messages import (
    FromShower,
    LetShowPrograms,
    ProgramOffers,
    ShownToClassmate,
)
from learnblock.i18n import Phrase
from learnblock.lessons.lesson import LessonText
from learnblock.project.files.lesson_folder import LessonName
from learnblock.server.messages import Scene, Work
from learnblock.server.messages.base import Message, Name, Own, Teach

Hint = Annotated[str, Meta(min_length=1, max_length=300)]
#: What a pupil needs help with; it fits on a tile of the wall.
Question = Annotated[str, Meta(max_length=60)]
Writing = Literal["no", "asked", "yes"]

# Joining.


TypedWord = Annotated[str, Meta(max_length=60)]


class Join(Struct, frozen=True):
    """Come into the class.

    Args:
        word: the join word, as typed.
        name: the first name.
        pictures: the PIN; None for a pupil who is new.
        is_first_name: whether a name of several words has been confirmed to be a first name.
    """

    word: TypedWord
    name: Annotated[str, Meta(max_length=200)]
    pictures: Pictures | None = None
    is_first_name: bool = False


class TryWord(Struct, frozen=True):
    """Ask whether this is the join word.

    Args:
        word: as typed.
    """

    word: TypedWord


class Joined(Struct, frozen=True, omit_defaults=True):
    """The pupil is in.

    Args:
        address: of the pupil's page, relative to this one.
        pictures: the PIN of a new pupil, who has to remember it.
    """

    address: str
    pictures: tuple[Picture, ...] = ()


class NotJoined(Struct, frozen=True):
    """Why a pupil is not in."""

    message: Phrase


class AboutClass(Struct, frozen=True):
    """What everybody in the room may know.

    Args:
        title: the name of the class.
        open: whether new pupils can join.
        teaches: whether the teacher asks, who then also sees the wall.
        pupil: the first name of the pupil whose browser asks; empty if no pupil uses it.
        address: of that pupil's page.
    """

    title: str
    open: bool
    teaches: bool = False
    pupil: str = ""
    address: str = ""


# From a pupil's page, in addition to the messages of its own server.


class AskForHelp(Own, frozen=True):
    """Raise or lower the pupil's hand.

    Args:
        on: whether it is raised.
        question: what the pupil needs help with, in the pupil's words; empty if nothing is said.
    """

    on: bool
    question: Question = ""


class AskNews(Own, frozen=True):
    """Ask what happens in the class: if no answer comes, its computer may be asleep."""


class LetTeacherWrite(Own, frozen=True):
    """Let the teacher change the program, or no more."""

    on: bool


class AskToWrite(Teach, frozen=True):
    """The teacher asks to change the program, or no longer wants to."""

    on: bool


# To a page that shows a pupil's program.


class InClass(Message, frozen=True):
    """What happens in the class, for a page that shows a pupil's program.

    Args:
        name: the pupil's first name.
        role: what the page is to the program.
        eyes_up: whether all pages rest because the teacher speaks.
        hand: whether the pupil asks for help.
        writing: whether the teacher may write.
        question: what the pupil needs help with.
        hint: the teacher's last hint; empty if there is none.
        hints: how many there have been, so that the same words twice are two hints.
        title: the name of the class.
        lesson: the name of the lesson that was handed out to the pupil last; empty without one.
    """

    name: str
    role: Literal["pupil", "watcher", "helper"]
    eyes_up: bool
    hand: bool
    writing: Writing
    question: str = ""
    hint: str = ""
    hints: int = 0
    title: str = ""
    lesson: str = ""


# From the wall.


class EyesUp(Message, frozen=True):
    """Pause or resume all pages."""

    on: bool


class StopAll(Message, frozen=True):
    """Stop all programs."""


class SendHint(Message, frozen=True):
    """Show a hint on a pupil's page; `pupil` is None for all."""

    text: Hint
    pupil: PupilId | None = None


class HandOut(Message, frozen=True):
    """Open a lesson on pupils' pages.

    Args:
        lesson: its name.
        project: the name of the projects that are made for it.
        pupils: on whose pages; None for all.
        step: the step to go to; 0 for where each pupil is in the lesson.
    """

    lesson: LessonName
    project: Name
    pupils: Pupils | None = None
    step: Annotated[int, Meta(ge=0, le=30)] = 0


class RenewPin(Message, frozen=True):
    """Give a pupil new pictures; `NewPin` follows."""

    pupil: PupilId


class RemovePupils(Message, frozen=True):
    """Delete pupils with everything that they have made."""

    pupils: Pupils


class LetJoin(Message, frozen=True):
    """Let new pupils join, or no more."""

    on: bool


class AnswerKnocking(Message, frozen=True):
    """Let a few more new pupils join, or not those who have asked; see `Wall`."""

    on: bool


class RenewWord(Message, frozen=True):
    """Take another join word."""


class ShowOnProjector(Message, frozen=True):
    """Show a pupil's world on the projector, without the name; None for the join word."""

    pupil: PupilId | None = None


# To the wall and the projector.


class Seat(Work, frozen=True, omit_defaults=True, kw_only=True):
    """What the wall shows of a pupil, besides the pupil's work.

    Args:
        id: the pupil's.
        name: what the teacher calls the pupil; empty on the projector.
        here: whether a page of the pupil is open.
        gone: seconds since the last one was closed.
        silent: seconds for which the pupil's server has not answered.
        begun: whether the pupil has done anything since the class was opened.
        hand: whether the pupil asks for help.
        waits: seconds for which the hand has been raised.
        question: what the pupil needs help with.
        hand_in: what is to be done with the pupil's hand-in in the open step; empty without one.
        lacks_lesson: whether the pupil's server has refused the lesson that was handed out last.
        shows: the project that the pupil shows the teacher; empty without one.
        shows_since: when it was shown, in seconds since 1970.
        scene: changes with the world, which `Plan` has.
        kept: how many numbers of the way the wall knows already; `way` has the others.
        quiet: seconds since the pupil last did something.
        stuck: seconds for which the pupil has worked without a new star or a run that ended well.
        writing: whether the teacher may write.
    """

    id: str
    name: str = ""
    here: bool = False
    gone: int = 0
    silent: int = 0
    begun: bool = False
    hand: bool = False
    waits: int = 0
    question: str = ""
    hand_in: State | Literal[""] = ""
    lacks_lesson: bool = False
    shows: str = ""
    shows_since: float = 0
    scene: int = 0
    kept: int = 0
    quiet: int = 0
    stuck: int = 0
    writing: Writing = "no"


class Plan(Message, frozen=True):
    """A pupil's world.

    Args:
        pupil: whose it is.
        number: `scene` in `Seat`.
        scene: what is in it.
    """

    pupil: str
    number: int
    scene: Scene


class LessonOffer(Struct, frozen=True, omit_defaults=True):
    """A lesson that can be handed out.

    Args:
        name: its name.
        title: its title.
        level: 1 (first drive) to 4.
        minutes: how long it takes.
        robots: the kinds of robots that it supports, the default first.
        steps: the titles of its steps.
        picture: the file of its picture; empty if it has none.
        own: whether it is one of the teacher's own.
    """

    name: str
    title: LessonText
    level: int
    minutes: int
    robots: tuple[str, ...]
    steps: tuple[LessonText, ...]
    picture: str = ""
    own: bool = False


class Offers(Message, frozen=True):
    """The lessons that can be handed out, once."""

    lessons: tuple[LessonOffer, ...]


class Wall(Message, frozen=True):
    """The class as a whole; `Seats` follow.

    The lesson on is the one that was handed out last, or with which the class begins.

    Args:
        title: the name of the class.
        word: the join word.
        address: by which pupils reach the class.
        open: whether new pupils can join.
        eyes_up: whether all pages rest.
        more: how many can join if the teacher lets more in.
        projected: the pupil on the projector; empty for the join word.
        pupils: the ids of all, in the order in which they joined.
        lesson: the name of the lesson on; empty without one.
        began: when it was handed out, in seconds since 1970; 0 if it was not.
        knocking: the first names of new pupils whom the teacher has to let in.
        sharing: whether pupils may play in each other's worlds.
        showing: whether pupils may show each other programs.
        shown: the last programs that they have shown each other, the newest first.
    """

    title: str
    word: str
    address: str
    open: bool
    eyes_up: bool
    more: int
    projected: str = ""
    pupils: tuple[str, ...] = ()
    lesson: str = ""
    began: float = 0
    knocking: tuple[str, ...] = ()
    sharing: bool = False
    showing: bool = False
    shown: tuple[ShownToClassmate, ...] = ()


class Seats(Message, frozen=True):
    """The pupils about whom something has changed."""

    seats: tuple[Seat, ...]


class NewPin(Message, frozen=True):
    """A pupil's new pictures, which the teacher tells."""

    name: str
    pictures: tuple[Picture, ...]


class Refused(Message, frozen=True):
    """Something that the teacher wanted could not be done."""

    message: Phrase


class Projected(Message, frozen=True):
    """What the projector shows: how to join, or a pupil's world without the name.

    Args:
        title: the name of the class.
        word: the join word.
        address: by which pupils reach the class.
        open: whether new pupils can join.
        here: how many pupils are here; no name is on the projector.
        joined: how many have joined.
        seat: the pupil whose world is shown, without the name; None for the join word.
        plan: the world.
    """

    title: str
    word: str
    address: str
    open: bool
    seat: Seat | None = None
    plan: Plan | None = None
    here: int = 0
    joined: int = 0


FromPupil = (
    AskNews | AskForHelp | LetTeacherWrite | AskToWrite | ImproveHandIn | FromPlayer | FromShower
)
ToPupil = InClass | OwnHandIns | HandInRun | ToPlayer | ProgramOffers
FromTeacher = (
    EyesUp
    | StopAll
    | SendHint
    | HandOut
    | RenewPin
    | RemovePupils
    | LetJoin
    | AnswerKnocking
    | RenewWord
    | ShowOnProjector
    | LetShareWorlds
    | LetShowPrograms
    | FromHandInPages
)
ToTeacher = Wall | Offers | Seats | Plan | NewPin | Refused | Projected | ToHandInPages
