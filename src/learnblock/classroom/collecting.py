"""What the pupils of a class have handed in, or have made so far, in a step of a lesson."""

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from learnblock.classroom.hand_ins import HandInShelf
from learnblock.classroom.pupil_folder import PROJECTS
from learnblock.classroom.roster import Pupil, Roster, names_of
from learnblock.errors import LearnBlockError
from learnblock.i18n import Phrase
from learnblock.lessons.grading.plan import Plan, planned
from learnblock.lessons.grading.values import Absence, HandedIn
from learnblock.lessons.opened import OpenLesson
from learnblock.lessons.reading import named_lesson
from learnblock.project.files.folder import ProjectFolder
from learnblock.project.files.lesson_folder import Progress
from learnblock.project.files.project import Project
from learnblock.project.files.unpacking import tags_used
from learnblock.server.messages import GivenProgram, GivenWork


@dataclass(frozen=True, slots=True)
class MadeWork:
    """What a pupil has made in a step.

    Args:
        file: where it was found.
        work: the program; None if there is none.
        reason: why there is none.
        has_begun: whether the pupil has reached the step.
    """

    file: Path
    work: GivenWork | None = None
    reason: Phrase | None = None
    has_begun: bool = True


def collect(
    roster: Roster, opened: OpenLesson, step: int, *, only_handed_in: bool = False
) -> Iterator[HandedIn]:
    """What each pupil has handed in in a step; of who has not, the newest program.

    Args:
        roster: the class.
        opened: the lesson.
        step: the number of the step.
        only_handed_in: whether the programs of those are left out who have not handed in.
    """
    shelf = HandInShelf(roster.folder)
    names = names_of(roster.pupils)
    for pupil in roster.pupils:
        name = names[pupil.id]
        if file := shelf.read(pupil.id, opened.name, step):
            path = shelf.path_of(pupil.id, opened.name, step)
            yield _handed_in(name, path, file.work.program)
            continue
        made = made_by(roster, pupil, opened, step)
        if not made.has_begun:
            yield _absent(name, made.file, "not begun", "grade-not-begun")
        elif only_handed_in:
            yield _absent(name, made.file, "not handed in", "grade-not-handed-in")
        elif made.work:
            yield _handed_in(name, made.file, made.work.program)
        else:
            yield HandedIn(name, str(made.file), reason=made.reason)


def plan_of(roster: Roster, lesson: str, step: int) -> Plan:
    """The plan of a check: a row for each pupil, in the order in which they joined.

    Raises:
        LearnBlockError: there is no such lesson or step.
    """
    opened = named_lesson(lesson)
    return planned(opened, step, collect(roster, opened, step, only_handed_in=True))


def made_by(roster: Roster, pupil: Pupil, opened: OpenLesson, step: int) -> MadeWork:
    """The newest program of a pupil in a step of a lesson."""
    folder = ProjectFolder(roster.folder_of(pupil) / PROJECTS, read_only=True)
    for entry in folder.entries():
        lesson = folder.lesson(entry.name)
        progress = lesson.progress()
        if progress is None or progress.lesson != opened.name:
            continue
        file = folder.file(entry.name)
        group, current = opened.group(step), opened.group(min(progress.step, _last(opened)))
        # The project is at its current step; the program of other ones is kept beside it.
        if group != current:
            left = lesson.program(group)
            if left is not None and (group == step or _reached(progress) >= step):
                return _made(file, left, opened.name, step, progress)
        elif _reached(progress) >= step:
            try:
                project = folder.read(entry.name)
            except LearnBlockError as error:
                return MadeWork(file, reason=error.phrase)
            return _made(file, project, opened.name, step, progress)
        return MadeWork(file, has_begun=False)
    return MadeWork(folder.path, has_begun=False)


def _last(opened: OpenLesson) -> int:
    return len(opened.lesson.step)


def _reached(progress: Progress) -> int:
    """The last step in which a pupil was, or did something."""
    return max(progress.step, *map(int, progress.steps), 1)


def _made(file: Path, project: Project, lesson: str, step: int, progress: Progress) -> MadeWork:
    part = project.parts[0]
    program = GivenProgram(part.text, part.is_python, dict(tags_used(project)))
    return MadeWork(file, GivenWork(lesson, step, program, progress.of(step).runs))


def _handed_in(pupil: str, file: Path, program: GivenProgram) -> HandedIn:
    return HandedIn(pupil, str(file), program.text, program.is_python, dict(program.tags))


def _absent(pupil: str, file: Path, absence: Absence, code: str) -> HandedIn:
    return HandedIn(pupil, str(file), reason=Phrase(code), absence=absence)
