"""What the pupils of a class have made in a lesson."""

from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

from learnblock.classroom.pupil_folder import PROJECTS
from learnblock.classroom.roster import Pupil, Roster
from learnblock.errors import LearnBlockError
from learnblock.server.projects.folder import ProjectFolder
from learnblock.server.projects.project import Project


class Collected(NamedTuple):
    """The work of a pupil.

    Args:
        pupil: the first name, with the id, since two pupils may have one name.
        file: the project's file; the folder of the projects if there is none.
        project: the program of the step; None if the pupil has not been there.
    """

    pupil: str
    file: Path
    project: Project | None


def collect(roster: Roster, lesson: str, step: int) -> Iterator[Collected]:
    """The newest program of each pupil in a step of a lesson.

    Args:
        roster: the class.
        lesson: the name of the lesson.
        step: the number of the step.
    """
    return (_of(roster, pupil, lesson, step) for pupil in roster.pupils)


def _of(roster: Roster, pupil: Pupil, lesson: str, step: int) -> Collected:
    name = f"{pupil.name} ({pupil.id})"
    folder = ProjectFolder(roster.folder_of(pupil) / PROJECTS, read_only=True)
    for entry in folder.entries():
        progress = folder.lesson(entry.name).progress()
        if progress is None or progress.lesson != lesson:
            continue
        # The project is at its current step; the program of another one is kept beside it.
        kept = folder.lesson(entry.name).program(step)
        project = _project(folder, entry.name) if progress.step == step else kept
        return Collected(name, folder.file(entry.name), project)
    return Collected(name, folder.path, None)


def _project(folder: ProjectFolder, name: str) -> Project | None:
    try:
        return folder.read(name)
    except LearnBlockError:
        # A damaged file is no work that could be graded.
        return None
