"""Projects that have been read and can be opened."""

from collections.abc import Mapping
from dataclasses import dataclass, field

from learnblock import robots, running
from learnblock.blocks.known import all_configurations
from learnblock.errors import LearnBlockError
from learnblock.i18n import Phrase
from learnblock.robots import RobotEntry
from learnblock.server import catalog
from learnblock.server.messages import WorldChoice
from learnblock.server.program.document import Document
from learnblock.server.projects.carried import Code
from learnblock.server.projects.project_file import Project
from learnblock.server.projects.unpacking import only_read, unpacked
from learnblock.server.sessions.library_versions import LibraryVersions
from learnblock.server.sessions.shown_blocks import ShownBlocks

#: Used if the project's world is missing and its robot has no default world.
DEFAULT_WORLD = "empty"


@dataclass(frozen=True)
class Prepared:
    """A project whose slow parts have been loaded.

    Args:
        name: the name of the project.
        document: its program.
        robot: the robot that it names, else the default.
        world: the world that it names, else the default.
        shown_blocks: the block set of the palette.
        libraries: the versions with which it was made.
        breakpoints: the ids of blocks.
        tags: the numbers of tags that it uses instead of the user's.
        offered: the code that it carries and the user has not installed.
        remarks: the differences from the saved project, with reasons.
        notes: what has been added to the user's things.
        worlds: all worlds if one has been added; else none.
    """

    name: str
    document: Document
    robot: RobotEntry
    world: str
    shown_blocks: ShownBlocks
    libraries: LibraryVersions
    breakpoints: tuple[str, ...] = ()
    tags: Mapping[str, int] = field(default_factory=dict)
    offered: Code = field(default_factory=Code)
    remarks: tuple[Phrase, ...] = ()
    notes: tuple[Phrase, ...] = ()
    worlds: tuple[WorldChoice, ...] = ()


def prepare(project: Project, *, read_only: bool = False) -> Prepared:
    """Unpack and read a project, and find its robot and world; this is slow.

    Args:
        project: the project.
        read_only: whether nothing that it carries may be added to the user's things.
    """
    unpacking = only_read(project) if read_only else unpacked(project)
    project = unpacking.project
    robot, no_robot = _robot(project.robot)
    world, no_world = _world(project.world, robot)
    document = Document.from_text(
        project.blocktext,
        robot.module,
        all_configurations(),
        project.workspace,
        project.python,
        devices=robot.load().known_devices(),
    )
    shown_blocks, no_set = _shown_blocks(project)
    libraries = LibraryVersions(project.libraries)
    on_libraries = libraries.remarks(project.carried.offered.libraries)
    return Prepared(
        name=project.name,
        document=document.settled(),
        robot=robot,
        world=world,
        shown_blocks=shown_blocks,
        libraries=libraries,
        breakpoints=tuple(project.breakpoints),
        tags=project.tags,
        offered=project.carried.offered,
        remarks=(*unpacking.remarks, *no_robot, *no_world, *no_set, *on_libraries),
        notes=unpacking.notes,
        worlds=catalog.world_choices() if unpacking.adds_world else (),
    )


def loaded(name: str) -> RobotEntry:
    """Find and load a robot.

    Raises:
        LearnBlockError: it does not exist, or its module has an error.
    """
    entry = robots.find(name)
    entry.load()
    return entry


def _robot(name: str) -> tuple[RobotEntry, tuple[Phrase, ...]]:
    try:
        return loaded(name), ()
    except LearnBlockError as error:
        default = running.DEFAULT_ROBOT
        return loaded(default), (
            Phrase("project-robot-replaced", problem=error.phrase, robot=default),
        )


def _world(name: str, robot: RobotEntry) -> tuple[str, tuple[Phrase, ...]]:
    if not name:
        return catalog.usual_world(robot) or DEFAULT_WORLD, ()
    try:
        catalog.check_world_name(name)
    except LearnBlockError as error:
        return DEFAULT_WORLD, (
            Phrase("project-world-replaced", problem=error.phrase, world=DEFAULT_WORLD),
        )
    return name, ()


def _shown_blocks(project: Project) -> tuple[ShownBlocks, tuple[Phrase, ...]]:
    try:
        return ShownBlocks.of(project), ()
    except LearnBlockError as error:
        everything = ShownBlocks(carried=project.block_sets)
        return everything, (Phrase("project-blocks-replaced", problem=error.phrase),)
