"""A project that has been read, and is about to be opened."""

from dataclasses import dataclass

from learnblock import robots, running
from learnblock.blocks import all_configurations
from learnblock.errors import LearnBlockError
from learnblock.robots import RobotEntry
from learnblock.server import catalog
from learnblock.server.pages.sentences import sentence
from learnblock.server.program.document import Document
from learnblock.server.projects.project_file import Project
from learnblock.server.sessions.library_versions import LibraryVersions
from learnblock.server.sessions.shown_blocks import ShownBlocks

#: Where there is neither the world that a project names nor one that its robot likes.
DEFAULT_WORLD = "empty"


@dataclass(frozen=True)
class Prepared:
    """A project with all that takes its time to be read.

    Args:
        name: the project's.
        document: its program.
        robot: the one it names, or else our default.
        world: likewise.
        shown_blocks: which the palette shows.
        libraries: which versions it was made with.
        breakpoints: ids of blocks.
        remarks: what could not be as it was saved.
    """

    name: str
    document: Document
    robot: RobotEntry
    world: str
    shown_blocks: ShownBlocks
    libraries: LibraryVersions
    breakpoints: tuple[str, ...] = ()
    remarks: tuple[str, ...] = ()


def prepare(project: Project) -> Prepared:
    """Read a project's program, and find its robot and its world; it takes a while."""
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
    return Prepared(
        name=project.name,
        document=settled(document),
        robot=robot,
        world=world,
        shown_blocks=shown_blocks,
        libraries=libraries,
        breakpoints=tuple(project.breakpoints),
        remarks=(*no_robot, *no_world, *no_set, *libraries.remarks()),
    )


def settled(document: Document) -> Document:
    """A document that has thought about everything it is going to be asked."""
    _ = document.problems, document.places, document.workspace
    return document


def loaded(name: str) -> RobotEntry:
    """A robot that can be used.

    Raises:
        LearnBlockError: there is none of that name, or its module is wrong.
    """
    entry = robots.find(name)
    entry.load()
    return entry


def _robot(name: str) -> tuple[RobotEntry, tuple[str, ...]]:
    try:
        return loaded(name), ()
    except LearnBlockError as error:
        default = running.DEFAULT_ROBOT
        return loaded(default), (f"{sentence(error)}; the project now uses {default}",)


def _world(name: str, robot: RobotEntry) -> tuple[str, tuple[str, ...]]:
    if not name:
        return catalog.usual_world(robot) or DEFAULT_WORLD, ()
    try:
        catalog.check_world_name(name)
    except LearnBlockError as error:
        return DEFAULT_WORLD, (f"{sentence(error)}; the project now uses {DEFAULT_WORLD}",)
    return name, ()


def _shown_blocks(project: Project) -> tuple[ShownBlocks, tuple[str, ...]]:
    try:
        return ShownBlocks.of(project), ()
    except LearnBlockError as error:
        everything = ShownBlocks(carried=project.block_sets)
        return everything, (f"{sentence(error)}; the project now shows all blocks",)
