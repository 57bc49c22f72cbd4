"""Projects that have been read and can be opened."""

from collections.abc import Mapping
from dataclasses import dataclass, field

from learnblock import robots, running
from learnblock.blocks.known import all_configurations
from learnblock.errors import LearnBlockError
from learnblock.i18n import Phrase
from learnblock.project.document.document import Document
from learnblock.project.files.carried import Code
from learnblock.project.files.project import Project, ProjectPart
from learnblock.project.files.unpacking import only_read, unpacked
from learnblock.robots import RobotEntry
from learnblock.server import catalog
from learnblock.server.messages import WorldChoice
from learnblock.server.runs.guest_program import GuestProgram
from learnblock.server.sessions.library_versions import LibraryVersions
from learnblock.server.sessions.shown_blocks import ShownBlocks

#: An empty program.
EMPTY = "main:\n    pass\nend\n"
#: Used if the project's world is missing and its robot has no default world.
DEFAULT_WORLD = "empty"


@dataclass(frozen=True)
class PreparedPart:
    """One of the programs of a project, with the robots that run it.

    Args:
        name: the name of its robot; several are numbered.
        document: its program.
        robot: the kind of robot that it names, else the default.
        breakpoints: the ids of blocks.
        count: how many robots run it.
    """

    name: str
    document: Document
    robot: RobotEntry
    breakpoints: tuple[str, ...] = ()
    count: int = 1


@dataclass(frozen=True)
class Prepared:
    """A project whose slow parts have been loaded.

    Args:
        name: the name of the project.
        parts: its programs with their robots.
        world: the world that it names, else the default.
        shown_blocks: the block set of the palette.
        libraries: the versions with which it was made.
        tags: the numbers of tags that it uses instead of the user's.
        offered: the code that it carries and the user has not installed.
        remarks: the differences from the saved project, with reasons.
        notes: what has been added to the user's things.
        worlds: all worlds if one has been added; else none.
    """

    name: str
    parts: tuple[PreparedPart, ...]
    world: str
    shown_blocks: ShownBlocks
    libraries: LibraryVersions
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
    parts = [_prepared_part(part) for part in project.parts]
    world, no_world = _world(project.world, parts[0][0].robot)
    shown_blocks, no_set = _shown_blocks(project)
    libraries = LibraryVersions(project.libraries)
    on_libraries = libraries.remarks(project.carried.offered.libraries)
    return Prepared(
        name=project.name,
        parts=tuple(part for part, _ in parts),
        world=world,
        shown_blocks=shown_blocks,
        libraries=libraries,
        tags=project.tags,
        offered=project.carried.offered,
        remarks=(
            *unpacking.remarks,
            *(remark for _, no_robot in parts for remark in no_robot),
            *no_world,
            *no_set,
            *on_libraries,
        ),
        notes=unpacking.notes,
        worlds=catalog.world_choices() if unpacking.adds_world else (),
    )


def empty_part(name: str, robot: RobotEntry, count: int) -> PreparedPart:
    """An empty program for robots of one kind; this is slow."""
    return _prepared_part(ProjectPart(name, EMPTY, robot=robot.name, count=count))[0]


def guest_program(robot: RobotEntry, text: str, is_python: bool) -> GuestProgram:  # noqa: FBT001 - run in a thread
    """A guest's program for a robot; this is slow.

    Raises:
        LearnBlockError: it has errors there.
    """
    document = empty_part("guest", robot, 1).document
    document = document.with_text("python" if is_python else "blocktext", text)
    document = document.with_robot(
        robot.module, robot.load().known_equipment(), robot.load().drivetrain()
    )
    document.require_no_errors()
    return GuestProgram(document)


def loaded(name: str) -> RobotEntry:
    """Find and load a robot.

    Raises:
        LearnBlockError: it does not exist, or its module has an error.
    """
    entry = robots.find(name)
    entry.load()
    return entry


def _prepared_part(part: ProjectPart) -> tuple[PreparedPart, tuple[Phrase, ...]]:
    robot, no_robot = _robot(part.robot)
    document = Document.from_text(
        part.blocktext,
        robot.module,
        all_configurations(),
        part.workspace,
        part.python,
        equipment=robot.load().known_equipment(),
        drivetrain=robot.load().drivetrain(),
    )
    prepared = PreparedPart(part.name, document.settled(), robot, part.breakpoints, part.count)
    return prepared, no_robot


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
