"""The programs in a file, which may be a project; reading them changes nothing of the user's."""

from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING

from learnblock import running
from learnblock.errors import FileError
from learnblock.i18n import Phrase
from learnblock.project.files import ENDING
from learnblock.running import Source
from learnblock.shell import command_line

if TYPE_CHECKING:
    from learnblock.project.files.project import Project, ProjectPart

#: Called with what a reader should know of a file.
Report = Callable[[Phrase], object]


@dataclass(frozen=True)
class ProgramFile:
    """A program, with the settings of its run from its project.

    Args:
        source: the program.
        robot: the name of the robot; None for a program without a project.
        world: the name of the world, or the path of the world that the project brings.
        tags: the numbers of tags that it uses instead of the user's.
        name: the name of the robot in a project with several; else empty.
        count: how many robots of the project run it.
    """

    source: Source
    robot: str | None = None
    world: str | None = None
    tags: Mapping[str, int] = field(default_factory=dict)
    name: str = ""
    count: int = 1


@contextmanager
def opened(path: Path, report: Report) -> Iterator[ProgramFile]:
    """Read a program or a project, whose world exists until the end; of several robots, the first.

    See `opened_all`.

    Raises:
        FileError: it is invalid.
        OSError: it can't be read.
    """
    with opened_all(path, report) as programs:
        yield programs[0]


def robots_in(path: Path) -> int:
    """How many robots a file is for; 1 for a program, and for a project that is invalid."""
    if path.suffix.lower() != ENDING:
        return 1
    try:
        return _project(path).count_robots()
    except FileError:
        # Reading it will report why.
        return 1


@contextmanager
def opened_all(path: Path, report: Report) -> Iterator[tuple[ProgramFile, ...]]:
    """Read a program, or the programs of a project, whose world exists until the end.

    Args:
        path: the file.
        report: called with the code that a project brings and the user has not installed.

    Raises:
        FileError: one is invalid.
        OSError: it can't be read.
    """
    if path.suffix.lower() != ENDING:
        yield (ProgramFile(running.read(path)),)
        return
    from learnblock.project.files import unpacking  # noqa: PLC0415 - programs need none of it

    project = _project(path)
    if offered := unpacking.offered_code(project):
        names = (*offered.blocks, *offered.libraries)
        command = command_line("learnblock", "open", path)
        report(Phrase("project-code", file=str(path), names=names, command=command))
    tags = unpacking.tags_used(project)
    with _world(project) as world:
        yield tuple(_program_files(path, project, world, tags))


def read(path: Path, report: Report) -> Source:
    """Read the program of a file, which may be a project.

    Raises:
        FileError: it is invalid.
        OSError: it can't be read.
    """
    with opened(path, report) as program:
        return program.source


def _project(path: Path) -> "Project":
    from learnblock.project.files.project_file import LARGEST, decode  # noqa: PLC0415 - as above

    with path.open("rb") as file:
        return decode(file.read(LARGEST + 1), path.stem)


def _program_files(
    path: Path, project: "Project", world: str | None, tags: Mapping[str, int]
) -> Iterator[ProgramFile]:
    if not project.has_several:
        yield ProgramFile(_source(path, project.parts[0]), project.robot, world, tags)
        return
    for part in project.parts:
        source = _source(path.with_name(f"{path.name} ({part.name})"), part)
        yield ProgramFile(source, part.robot, world, tags, part.name, part.count)


def _source(path: Path, part: "ProjectPart") -> Source:
    return running.source_of(path, part.text, is_python=part.is_python)


@contextmanager
def _world(project: "Project") -> Iterator[str | None]:
    from learnblock.extensions import worlds  # noqa: PLC0415 - as above
    from learnblock.project.files.unpacking import is_at_home  # noqa: PLC0415 - as above

    carried = project.carried.world
    is_newer_here = is_at_home(project) and project.world in worlds.own_names()
    if carried is None or carried.name != project.world or is_newer_here:
        yield project.world or None
        return
    packed = worlds.PackedWorld(carried.name, "\n".join(carried.file), carried.picture)
    with worlds.staged(packed) as file:
        yield str(file)
