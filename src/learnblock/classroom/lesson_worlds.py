"""The worlds of lessons, which the wall shows of pupils who have not opened theirs."""

import asyncio

import msgspec

from learnblock import robots
from learnblock.errors import LearnBlockError
from learnblock.lessons.reading import named_lesson
from learnblock.monitor.worlds import world_lines, world_values
from learnblock.robots.simulated import SimulatedRobot, find_world
from learnblock.server.messages import Scene

#: A lesson and a step, from 1.
_Place = tuple[str, int]


class LessonWorlds:
    """Keeps what was read: pupils who have been handed the same lesson share its world."""

    def __init__(self) -> None:
        self._scenes: dict[_Place, Scene | None] = {}

    async def read(self, lesson: str, step: int = 1) -> None:
        """Read the world of a step; of a lesson that can't be read, there is none."""
        if lesson:
            self._scenes[lesson, step] = await asyncio.to_thread(_scene, lesson, step)

    def of(self, lesson: str, step: int = 1) -> Scene | None:
        """The world of a step, with the robot at its start; None if it has not been read."""
        return self._scenes.get((lesson, step))


def _scene(lesson: str, step: int) -> Scene | None:
    try:
        opened = named_lesson(lesson)
        robot = robots.find(opened.robots(step)[0]).load()
        if not issubclass(robot, SimulatedRobot):
            return None
        look = robot.description()
        world = opened.described_world(step) or find_world(look.world)
    except (LearnBlockError, OSError):
        # The pupil who opens the lesson reads why.
        return None
    first = next(iter(world.start), None)
    return Scene(
        name=world.name,
        world=world_values(world),
        lines=world_lines(world),
        robots=((look.name, msgspec.to_builtins(look)),),
        start=(first.x, first.y, first.heading) if first else None,
    )
