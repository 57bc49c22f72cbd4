"""What a pupil's server reports to the class's wall about a page."""

from typing import Any, Literal

from msgspec import Struct

from learnblock.lessons.lesson import LessonText
from learnblock.server.messages.base import StateName, ToClass
from learnblock.server.messages.worlds import Scene

GoalState = Literal["open", "reached", "failed"]
#: A `Phrase` with texts by language, which only a page chooses.
Words = dict[str, Any]


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
        step: the current step, from 1; 0 without a lesson.
        steps: the number of its steps.
        stars: earned in the lesson.
        error: why the last run ended, if not well, or what is wrong with the program.
    """

    project: str = ""
    robot: str = ""
    pose: tuple[float, float, float] | None = None
    way: tuple[float, ...] = ()
    state: StateName = "idle"
    goals: tuple[GoalState, ...] = ()
    lesson: LessonText = ""
    step: int = 0
    steps: int = 0
    stars: int = 0
    error: Words | None = None


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
