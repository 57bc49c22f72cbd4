"""What the pupils of a class have made in a lesson, as if they had handed it in."""

from collections import Counter
from collections.abc import Iterator
from pathlib import Path

from learnblock.classroom.pupil_folder import PROJECTS
from learnblock.classroom.roster import Pupil, Roster
from learnblock.errors import LearnBlockError
from learnblock.i18n import Phrase
from learnblock.lessons.grading.values import HandedIn
from learnblock.project.files.folder import ProjectFolder
from learnblock.project.files.project import Project
from learnblock.project.files.unpacking import tags_used


def collect(roster: Roster, lesson: str, step: int) -> Iterator[HandedIn]:
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


def _of(roster: Roster, pupil: Pupil, name: str, lesson: str, step: int) -> HandedIn:
    folder = ProjectFolder(roster.folder_of(pupil) / PROJECTS, read_only=True)
    for entry in folder.entries():
        progress = folder.lesson(entry.name).progress()
        if progress is None or progress.lesson != lesson:
            continue
        file = folder.file(entry.name)
        # The project is at its current step; the program of another one is kept beside it.
        if progress.step != step:
            return _handed_in(name, file, folder.lesson(entry.name).program(step))
        try:
            return _handed_in(name, file, folder.read(entry.name))
        except LearnBlockError as error:
            return HandedIn(name, str(file), reason=error.phrase)
    return _handed_in(name, folder.path, None)


def _handed_in(pupil: str, file: Path, project: Project | None) -> HandedIn:
    if project is None:
        reason = Phrase("grade-not-begun")
        return HandedIn(pupil, str(file), reason=reason, absence="not begun")
    part = project.parts[0]
    return HandedIn(pupil, str(file), part.text, part.is_python, dict(tags_used(project)))
