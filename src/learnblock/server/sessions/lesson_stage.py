"""The program, world, robots and blocks with which a step of a lesson begins."""

from collections.abc import Iterator
from dataclasses import replace

from learnblock import robots
from learnblock.blocks import block_sets
from learnblock.blocks.block_sets import BlockNames, BlockSet
from learnblock.i18n import Phrase, in_each_language
from learnblock.lessons.reading import OpenLesson
from learnblock.project.files.project import Project, ProjectPart
from learnblock.server import catalog
from learnblock.server.sessions.prepared import DEFAULT_WORLD, EMPTY

#: The name of the block set of a step.
_SET = "lesson"


def world_here(opened: OpenLesson, number: int, robot: str) -> str:
    """The local name of a step's world; the lesson's own worlds are installed.

    Raises:
        LearnBlockError: the lesson's world is invalid.
        OSError: it can't be written.
    """
    name = opened.world(number)
    if name is None:
        return catalog.usual_world(robots.find(robot)) or DEFAULT_WORLD
    if name not in opened.own_worlds:
        return name
    from learnblock.extensions import worlds  # noqa: PLC0415 - it loads the simulator

    packed = worlds.PackedWorld(name, opened.text(f"worlds/{name}.toml"))
    picture = opened.files.get(f"worlds/{worlds.picture_name(packed)}")
    return worlds.install(replace(packed, picture=picture))


def blocks_of(opened: OpenLesson, number: int) -> BlockSet | None:
    """The blocks that a step shows; None for those of the step before."""
    chosen = opened.blocks(number)
    if chosen is None:
        return None
    if isinstance(chosen, str):
        known = block_sets.built_in()
        return known.get(chosen, known[block_sets.EVERYTHING])
    title = in_each_language(Phrase("lesson-blocks"))
    return BlockSet(_SET, title=title, show=BlockNames(blocks=tuple(chosen)))


def beginning(opened: OpenLesson, number: int, name: str, robot: str) -> Project:
    """The project with which a step begins.

    Args:
        opened: the lesson.
        number: the number of the step.
        name: the name of the project.
        robot: the user's robot, used if the step supports it.
    """
    file = opened.start(opened.group(number))
    source = opened.program(file) if file else EMPTY
    known = opened.robots(number)
    chosen = next((choice for choice in (robot, f"sim-{robot}") if choice in known), known[0])
    mine = ProjectPart(name, source, robot=chosen)
    project = Project(name, world=world_here(opened, number, chosen))
    return project.with_parts([mine, *_partners(opened, number)])


def _partners(opened: OpenLesson, number: int) -> Iterator[ProjectPart]:
    """The other robots of a step, with their programs."""
    for partner in opened.step(number).partners:
        robot = robots.find(partner.robot).name
        yield ProjectPart(partner.name, opened.program(partner.program), robot=robot)
