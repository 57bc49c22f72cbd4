"""The programs of a class, which the wall prints: the newest one of each pupil."""

from collections.abc import Iterator

from msgspec import Struct

from learnblock.classroom.pupil_folder import PROJECTS
from learnblock.classroom.roster import Pupil, Roster, names_of
from learnblock.errors import LearnBlockError
from learnblock.language import Workspace
from learnblock.lessons.drawing import LONGEST_DRAWING, drawing_of
from learnblock.project.files.folder import ProjectFolder


class PupilProgram(Struct, frozen=True, omit_defaults=True):
    """A program of a pupil.

    Args:
        pupil: what the teacher calls the pupil.
        project: the name of its project.
        blocktext: the program in Block-Text.
        blocks: its blocks; None if it has mistakes, or is too long to be drawn.
        places: the id of each block, with its first and last line in Block-Text, from 1.
    """

    pupil: str
    project: str
    blocktext: str
    blocks: Workspace | None = None
    places: tuple[tuple[str, int, int], ...] = ()


class ClassPrograms(Struct, frozen=True):
    """The programs of a class, in the order in which its pupils joined.

    Args:
        title: of the class.
        programs: of pupils who have made one.
    """

    title: str
    programs: tuple[PupilProgram, ...]


def class_programs(roster: Roster) -> ClassPrograms:
    """The newest program of each pupil; a project of several robots has one for each."""
    names = names_of(roster.pupils)
    programs = (
        program for pupil in roster.pupils for program in _newest(roster, pupil, names[pupil.id])
    )
    return ClassPrograms(roster.title, tuple(programs))


def _newest(roster: Roster, pupil: Pupil, name: str) -> Iterator[PupilProgram]:
    folder = ProjectFolder(roster.folder_of(pupil) / PROJECTS, read_only=True)
    for entry in folder.entries()[:1]:
        try:
            project = folder.read(entry.name)
        except LearnBlockError:
            # A damaged file must not keep the others from being printed.
            continue
        for part in project.parts:
            yield _program(name, project.name, part.blocktext)


def _program(pupil: str, project: str, blocktext: str) -> PupilProgram:
    drawing = drawing_of(blocktext) if len(blocktext) <= LONGEST_DRAWING else None
    if drawing is None:
        return PupilProgram(pupil, project, blocktext)
    places = tuple((block, line, drawing.ends[block]) for block, line in drawing.lines.items())
    return PupilProgram(pupil, project, blocktext, drawing.workspace, places)
