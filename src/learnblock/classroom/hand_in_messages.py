"""The conversation of a class about what is handed in, checked, marked and handed back."""

from collections.abc import Mapping
from typing import Annotated, Any, Literal

from msgspec import Meta, Struct
from msgspec.structs import replace

from learnblock.classroom.hand_ins import (
    CheckedWork,
    HandedBack,
    HandInFile,
    Mark,
    Note,
    NotedLine,
    State,
)
from learnblock.classroom.roster import MOST_PUPILS, PupilId
from learnblock.i18n import Phrase
from learnblock.language import Workspace
from learnblock.lessons.lesson import LessonText
from learnblock.project.files.lesson_folder import LessonName, StepNumber
from learnblock.server.messages import GivenProgram
from learnblock.server.messages.base import Message, Own

Pupils = Annotated[tuple[PupilId, ...], Meta(max_length=MOST_PUPILS)]
#: What a pupil without a hand-in has done.
Without = Literal["not begun", "not handed in"]

# From a pupil's page, and to it; what a pupil hands in comes from the pupil's server.


class ImproveHandIn(Own, frozen=True):
    """The pupil improves what was handed back."""

    lesson: LessonName
    step: StepNumber


class OwnHandIn(Struct, frozen=True, omit_defaults=True):
    """A hand-in, as its pupil sees it.

    Args:
        lesson: the name of the lesson.
        step: the number of the step.
        at: when it was handed in, in seconds since 1970.
        waits: whether the teacher has not handed it back yet.
        improving: whether the pupil improves it.
        back: what was handed back last; None if nothing was.
    """

    lesson: str
    step: int
    at: float
    waits: bool = False
    improving: bool = False
    back: HandedBack | None = None


def own_hand_in(file: HandInFile) -> OwnHandIn:
    """A hand-in as its pupil sees it: nothing that the teacher has not handed back."""
    last = file.back[-1] if file.back else None
    checked = last.checked if last else None
    if last and checked:
        last = replace(last, checked=replace(checked, way=()))
    work = file.work
    return OwnHandIn(work.lesson, work.step, file.at, not last or file.is_new, file.improving, last)


class HandInRun(Message, frozen=True):
    """What to run beside a hand-in, for the teacher's page that shows the run.

    Args:
        lesson: the name of the lesson.
        step: the number of the step.
        program: the program.
        robot: the robot of the run that the list of hand-ins speaks of.
        variant: the variant of the world of that run.
    """

    lesson: str
    step: int
    program: GivenProgram
    robot: str
    variant: int = 0


class OwnHandIns(Message, frozen=True):
    """What the pupil has handed in, the oldest first."""

    hand_ins: tuple[OwnHandIn, ...] = ()


# From the wall.


class ReadHandIns(Message, frozen=True):
    """Show the hand-ins of a step; `HandInList` follows."""

    lesson: LessonName
    step: StepNumber


class ReadHandIn(Message, frozen=True):
    """Show a hand-in; `ShownHandIn` follows."""

    pupil: PupilId
    lesson: LessonName
    step: StepNumber


class CollectHandIns(Message, frozen=True):
    """Take the newest programs of pupils who have not handed in a step; `HandInList` follows."""

    lesson: LessonName
    step: StepNumber


class CheckHandIns(Message, frozen=True):
    """Run the checks of a step on all hand-ins; only what is missing is made."""

    lesson: LessonName
    step: StepNumber


class EndChecking(Message, frozen=True):
    """Make no further runs; the next check goes on with what is finished."""


class MarkHandIn(Message, frozen=True):
    """Keep a note and a mark, which are handed back later; `HandInList` follows.

    Args:
        pupil: whose hand-in it is.
        lesson: the name of the lesson.
        step: the number of the step.
        note: the note.
        mark: the mark.
        line: what the note is about; None if it is about the whole program.
    """

    pupil: PupilId
    lesson: LessonName
    step: StepNumber
    note: Note
    mark: Mark
    line: NotedLine | None = None


class HandBack(Message, frozen=True):
    """Show pupils their notes and marks; `HandInList` follows."""

    lesson: LessonName
    step: StepNumber
    pupils: Pupils


# To the wall.


class HandInStep(Struct, frozen=True, omit_defaults=True):
    """How many pupils have handed in a step.

    Args:
        lesson: the name of the lesson.
        title: of the lesson.
        step: the number of the step.
        step_title: its title.
        count: the hand-ins.
        to_check: how many of them have not been checked.
        to_mark: how many have been checked, and have neither note nor mark.
        marked: how many wait to be handed back.
    """

    lesson: str
    title: LessonText
    step: int
    step_title: LessonText
    count: int = 0
    to_check: int = 0
    to_mark: int = 0
    marked: int = 0


class CheckProgress(Struct, frozen=True, omit_defaults=True):
    """How far a check is.

    Args:
        lesson: the name of the lesson.
        step: the number of the step.
        done: the runs that are finished.
        total: all runs; 0 while that is not known.
    """

    lesson: str
    step: int
    done: int = 0
    total: int = 0


class HandInSteps(Message, frozen=True):
    """The steps that can be handed in of the lessons on which the class works.

    Args:
        steps: in the order of the lessons and of their steps.
        revision: changes with every hand-in: read those that are shown again.
        checking: the check that is being made.
        failure: why the last check could not be finished.
    """

    steps: tuple[HandInStep, ...] = ()
    revision: int = 0
    checking: CheckProgress | None = None
    failure: Phrase | None = None


class WaitingHandIn(Struct, frozen=True, omit_defaults=True):
    """A hand-in that waits to be handed back, for the wall.

    Args:
        pupil: the id of the pupil.
        lesson: the name of the lesson.
        title: of the lesson.
        step: the number of the step.
        tries: how often the pupil has run it.
    """

    pupil: str
    lesson: str
    title: LessonText
    step: int
    tries: int = 0


class WaitingHandIns(Message, frozen=True):
    """What waits to be handed back, except for the work in the steps that pupils have open.

    Args:
        hand_ins: the newest first.
        more: how many there are besides.
    """

    hand_ins: tuple[WaitingHandIn, ...] = ()
    more: int = 0


class HandInLine(Struct, frozen=True, omit_defaults=True):
    """A hand-in in the list.

    Args:
        pupil: the id of the pupil.
        name: what the teacher calls the pupil.
        state: what is to be done with it.
        at: when it was handed in, in seconds since 1970.
        collected: whether the teacher has collected it.
        tries: how often the pupil has run it.
        checked: whether it was checked.
        stars: three if the step was done from all starts, two from more than half, one from some.
        missed: the first check that was missed; empty if none was.
        note: the teacher's note.
        mark: the teacher's mark.
        line: what the note is about; None if it is about the whole program.
    """

    pupil: str
    name: str
    state: State
    at: float
    collected: bool = False
    tries: int = 0
    checked: bool = False
    stars: int = 0
    missed: LessonText = ""
    note: str = ""
    mark: str = ""
    line: NotedLine | None = None


class PupilWithout(Struct, frozen=True):
    """A pupil who has not handed in.

    Args:
        pupil: the id of the pupil.
        name: what the teacher calls the pupil.
        state: whether the pupil has begun the step.
    """

    pupil: str
    name: str
    state: Without


class CommonMistake(Struct, frozen=True):
    """What most pupils miss.

    Args:
        missed: the check.
        count: how many pupils miss it.
    """

    missed: LessonText
    count: int


class HandInList(Message, frozen=True):
    """The hand-ins of a step.

    Args:
        lesson: the name of the lesson.
        title: of the lesson.
        step: the number of the step.
        step_title: its title.
        starts: in how many runs each program is tried.
        lines: the hand-ins, in the order in which the pupils joined.
        without: the pupils without one, who count under no mistake.
        often: what is missed most often by at least two pupils.
        notes: the teacher's last notes, the newest first.
    """

    lesson: str
    title: LessonText
    step: int
    step_title: LessonText
    starts: int
    lines: tuple[HandInLine, ...] = ()
    without: tuple[PupilWithout, ...] = ()
    often: CommonMistake | None = None
    notes: tuple[str, ...] = ()


class ShownHandIn(Message, frozen=True):
    """A hand-in with its program.

    Args:
        line: as in the list.
        lesson: the name of the lesson.
        step: the number of the step.
        program: the program.
        checked: what the checks said; None if they were not asked.
        back: what was handed back, the newest last.
        world: the contents of the world's file (`WorldFile`); None if the step has none.
        blocktext: the program in Block-Text; empty if it can't be written so.
        blocks: its blocks; None if it has mistakes, or is too long to be drawn.
        lines: the line of each block in Block-Text, by the id of the block.
    """

    line: HandInLine
    lesson: str
    step: int
    program: GivenProgram
    checked: CheckedWork | None = None
    back: tuple[HandedBack, ...] = ()
    world: dict[str, Any] | None = None
    blocktext: str = ""
    blocks: Workspace | None = None
    lines: Mapping[str, int] = {}


FromHandInPages = (
    ReadHandIns | ReadHandIn | CollectHandIns | CheckHandIns | EndChecking | MarkHandIn | HandBack
)
ToHandInPages = HandInSteps | HandInList | ShownHandIn | WaitingHandIns
