"""What the pupils of a class have made in a lesson."""

from collections import Counter
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

from learnblock.classroom.pupil_folder import PROJECTS
from learnblock.classroom.roster import Pupil, Roster
from learnblock.errors import LearnBlockError
from learnblock.i18n import Phrase
from learnblock.server.projects.folder import ProjectFolder
from learnblock.server.projects.project import Project


class Collected(NamedTuple):
    """The work of a pupil.

    Args:
        pupil: the first name; of several pupils with one name, each with the id.
        file: the project's file; the folder of the projects if there is none.
        project: the program of the step; None if the pupil has not been there.
        problem: why the program can't be read; None if it can, or if there is none.
    """

    pupil: str
    file: Path
    project: Project | None
    problem: Phrase | None = None


def collect(roster: Roster, lesson: str, step: int) -> Iterator[Collected]:
    """The newest program of each pupil in a step of a lesson.

    Args:
        roster: the class.
        lesson: the name of the lesson.
        step: the number of the step.
    """
    bearers = Counter(pupil.name for pupil in roster.pupils)
    for pupil in roster.pupils:
        name = pupil.name if bearers[pupil.name] == 1 else f"{pupil.name} ({pupil.id})"
        yield _of(roster, pupil, name, lesson, step)


def _of(roster: Roster, pupil: Pupil, name: str, lesson: str, step: int) -> Collected:
    folder = ProjectFolder(roster.folder_of(pupil) / PROJECTS, read_only=True)
    for entry in folder.entries():
        progress = folder.lesson(entry.name).progress()
        if progress is None or progress.lesson != lesson:
            continue
        # The project is at its current step; those of other steps are kept in its folder.
        kept = folder.lesson(entry.name).program(step)
        file = folder.file(entry.name)
        if progress.step != step:
            return Collected(name, file, kept)
        try:
            return Collected(name, file, folder.read(entry.name))
        except LearnBlockError as error:
            return Collected(name, file, None, error.phrase)
    return Collected(name, folder.path, None)
