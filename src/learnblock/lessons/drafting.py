"""The lesson with which an author begins: one step, made of a program and its world."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from learnblock import robots
from learnblock.errors import LearnBlockError
from learnblock.lessons.editing import EditedLesson, EditedStep, WrittenProgram
from learnblock.lessons.lesson import VERSION
from learnblock.robots.simulated import find_world

#: How long a new lesson takes, in minutes, until its author changes it.
MINUTES = 30


@dataclass(frozen=True)
class Drafted:
    """A robot with its program, of which a lesson is made."""

    name: str
    robot: str
    program: str


def draft(title: str, world: str, programs: Sequence[Drafted], blocks: str = "") -> EditedLesson:
    """A lesson with one step, in which the program is where pupils begin, and the solution.

    Args:
        title: the title of the lesson.
        world: the name of its world.
        programs: the programs in Block-Text, the pupil's first; the others are partners.
        blocks: the name of a built-in block set; empty for all blocks.
    """
    own, *others = programs
    step: dict[str, Any] = {
        "title": {},
        "phase": "make",
        "text": {},
        "world": world,
        "check": [{"kind": "goals" if _has_goals(world) else "ends"}],
    }
    if blocks:
        step["blocks"] = blocks
    if others:
        step["partners"] = [
            {"name": partner.name, "robot": _simulated(partner.robot), "program": _file(index)}
            for index, partner in enumerate(others)
        ]
    program = WrittenProgram(own.program)
    return EditedLesson(
        content={
            "lesson": VERSION,
            "title": title,
            "level": 1,
            "minutes": MINUTES,
            "aims": [{}],
            "robots": [_simulated(own.robot)],
            "step": [step],
        },
        steps=(EditedStep(program=program, solution=program),),
        programs={_file(index): partner.program for index, partner in enumerate(others)},
    )


def _file(index: int) -> str:
    return f"partner-{index + 1}.bt"


def _has_goals(world: str) -> bool:
    try:
        return bool(list(find_world(world).goal.all()))
    except LearnBlockError:
        # It is reported when the lesson is examined.
        return False


def _simulated(robot: str) -> str:
    """The simulated twin of a robot, which every class has."""
    twin = f"sim-{robot}"
    return twin if twin in robots.entries() else robot
