"""What a pupil's server reports to the class's wall about a page."""

from typing import Annotated, Any, ClassVar, Literal

from msgspec import Meta, Struct

from learnblock.lessons.lesson import LessonText
from learnblock.project.files.lesson_folder import LessonName, Number, StepNumber
from learnblock.server.messages.base import Name, Own, Pace, StateName, Text, ToClass
from learnblock.server.messages.worlds import Scene

GoalState = Literal["open", "reached", "failed"]
#: A `Phrase` with texts by language, which only a page chooses.
Words = dict[str, Any]


class MissedCheck(Struct, frozen=True, omit_defaults=True):
    """What the last run missed of a lesson's step.

    Args:
        goal: the check, as the pupil reads it (`LessonWords`).
        reason: by how much, if that is known.
    """

    goal: Words
    reason: Words | None = None


class Work(Struct, frozen=True, omit_defaults=True):
    """What a page works on.

    Args:
        project: the open project.
        robot: its kind of robot.
        pose: x and y in mm, heading in degrees clockwise; None if unknown.
        way: where it has been in this run: x and y in mm, alternating.
        state: of the program.
        goals: the states of the goals of the world.
        lesson: the title of the open lesson.
        lesson_name: its name; empty without a lesson.
        step: the current step, from 1; 0 without a lesson.
        steps: the number of its steps.
        done: of each step, whether it is behind the pupil, or has given a star.
        stars: earned in the lesson.
        all_stars: those that there are to earn.
        tries: the runs of this step that have ended.
        missed: the first check that the last of them did not pass; None if it passed.
        error: why the last run ended, if not well, or what is wrong with the program.
    """

    project: str = ""
    robot: str = ""
    pose: tuple[float, float, float] | None = None
    way: tuple[float, ...] = ()
    state: StateName = "idle"
    goals: tuple[GoalState, ...] = ()
    lesson: LessonText = ""
    lesson_name: str = ""
    step: int = 0
    steps: int = 0
    done: tuple[bool, ...] = ()
    stars: int = 0
    all_stars: int = 0
    tries: int = 0
    missed: MissedCheck | None = None
    error: Words | None = None


class HandIn(Own, frozen=True):
    """Hand the program of the lesson's open step in; only in a class."""

    pace: ClassVar = Pace(minute=10, burst=5)


class GivenProgram(Struct, frozen=True, omit_defaults=True):
    """A program that is handed in.

    Args:
        text: in Block-Text or Python.
        is_python: whether it is Python.
        tags: the numbers of tags, by name, that its project uses.
    """

    text: Text
    is_python: bool = False
    tags: Annotated[dict[Name, int], Meta(max_length=1000)] = {}


class GivenWork(Struct, frozen=True, omit_defaults=True):
    """What a pupil hands in.

    Args:
        lesson: the name of the lesson.
        step: the number of the step.
        program: the pupil's program.
        tries: how often the pupil has run it in this step.
    """

    lesson: LessonName
    step: StepNumber
    program: GivenProgram
    tries: Number = 0


class WorkGiven(ToClass, frozen=True):
    """The pupil hands in what is open; the class keeps it."""

    work: GivenWork


class AtSeat(ToClass, frozen=True):
    """What a page works on; only on a connection that asks for it, and at most twice a second.

    Args:
        work: what it works on.
        successes: the number of new stars, new steps and runs that ended well.
        scene: its world, if that has changed since the last such message.
    """

    work: Work
    successes: int = 0
    scene: Scene | None = None
