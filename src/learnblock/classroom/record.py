"""A pupil over weeks: what the lessons' progress and the hand-ins say, for pupil and teacher."""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, field

from msgspec import Struct
from msgspec.structs import replace

from learnblock.classroom.hand_ins import HandInFile, HandInShelf
from learnblock.classroom.lesson_works import LessonWorkFile
from learnblock.classroom.pupil_folder import PROJECTS
from learnblock.classroom.roster import Pupil, Roster, names_of
from learnblock.errors import LearnBlockError
from learnblock.lessons.lesson import Lesson, LessonText, Step
from learnblock.lessons.opened import OpenLesson
from learnblock.lessons.texts import plain
from learnblock.project.files.folder import ProjectFolder
from learnblock.project.files.lesson_folder import GOALS, PUZZLE, QUIZ
from learnblock.project.files.lesson_work import LessonWork, lesson_works
from learnblock.server.catalog import find_lesson, star_names


class RecordedHandIn(Struct, frozen=True, omit_defaults=True):
    """A hand-in, with nothing that the teacher has not handed back.

    Args:
        step: the number of the step.
        title: of the step.
        at: when it was handed in, in seconds since 1970.
        marks: the marks that it was handed back with, the newest last.
        note: the last note that it was handed back with.
        improved: how often it was handed in again after it was handed back.
        waits: whether the teacher has not handed it back yet.
    """

    step: int
    title: LessonText
    at: float
    marks: tuple[str, ...] = ()
    note: str = ""
    improved: int = 0
    waits: bool = False


class RecordedAim(Struct, frozen=True, omit_defaults=True):
    """What pupils learn in a lesson.

    Args:
        say: the aim.
        reached: whether everything is earned that shows it.
        stars: how many of the stars that show it are earned.
        all_stars: how many stars show it.
        standards: what it is called in tables of standards.
    """

    say: LessonText
    reached: bool = False
    stars: int = 0
    all_stars: int = 0
    standards: tuple[str, ...] = ()


class RecordedLesson(Struct, frozen=True, omit_defaults=True):
    """A lesson that a pupil has begun.

    Args:
        name: its name.
        title: its title; its name if the lesson is gone.
        picture: the file of its picture; empty if it has none.
        at: when it was last worked on, in seconds since 1970.
        step: the farthest step that was reached.
        steps: how many it has; 0 if the lesson is gone.
        stars: how many are earned.
        all_stars: how many there are.
        done: whether everything is earned that the steps ask for.
        runs: how often a program was run.
        hints: how many levels of hints were taken.
        aims: what pupils learn in it.
        hand_ins: in the order of the steps.
    """

    name: str
    title: LessonText
    picture: str = ""
    at: float = 0.0
    step: int = 1
    steps: int = 0
    stars: int = 0
    all_stars: int = 0
    done: bool = False
    runs: int = 0
    hints: int = 0
    aims: tuple[RecordedAim, ...] = ()
    hand_ins: tuple[RecordedHandIn, ...] = ()


class PupilRecord(Struct, frozen=True, omit_defaults=True):
    """A pupil over all sessions of a class.

    Args:
        name: what the teacher calls the pupil; for the pupil, the first name.
        title: the name of the class.
        teaches: whether the teacher asks.
        lessons: those that the pupil has begun, in the order in which they were worked on.
    """

    name: str
    title: str
    teaches: bool = False
    lessons: tuple[RecordedLesson, ...] = ()


@dataclass
class _Shown:
    """What a pupil has done in a lesson, in all projects and hand-ins.

    Args:
        work: in all projects.
        hand_ins: by the number of the step.
    """

    work: LessonWork
    hand_ins: dict[int, HandInFile] = field(default_factory=dict)

    @property
    def at(self) -> float:
        """When it was last worked on."""
        return max([self.work.at, *(file.at for file in self.hand_ins.values())])

    @property
    def step(self) -> int:
        """The farthest step that was reached."""
        return max([self.work.step, *self.hand_ins])

    def earned(self, number: int, step: Step) -> set[str]:
        """The stars that are earned in a step."""
        return set(self.work.earned(number).intersection(star_names(step)))

    def needed(self, steps: Iterable[tuple[int, Step]]) -> tuple[int, int]:
        """How many of the stars that numbered steps ask for are earned, and how many there are."""
        counts = [
            (len(_needed(self.earned(number, step))), len(_needed(star_names(step))))
            for number, step in steps
        ]
        return sum(earned for earned, _ in counts), sum(asked for _, asked in counts)


def record_of(
    roster: Roster,
    shelf: HandInShelf,
    pupil: Pupil,
    *,
    teaches: bool,
    kept: LessonWorkFile | None = None,
) -> PupilRecord:
    """What a pupil has done in the class.

    Args:
        roster: the class.
        shelf: its hand-ins.
        pupil: the pupil.
        teaches: whether the teacher asks.
        kept: where the work in lessons is kept, if not in the pupil's projects.
    """
    if kept:
        works = kept.works() or ()
    else:
        folder = ProjectFolder(roster.folder_of(pupil) / PROJECTS, read_only=True)
        works = lesson_works(folder)
    shown = _with_hand_ins(works, shelf.of_pupil(pupil.id))
    lessons = (_lesson(name, lesson) for name, lesson in shown.items())
    return PupilRecord(
        names_of(roster.pupils).get(pupil.id, pupil.name) if teaches else pupil.name,
        roster.title,
        teaches,
        tuple(sorted(lessons, key=lambda lesson: (lesson.at, lesson.name))),
    )


def _with_hand_ins(
    works: Iterable[LessonWork], hand_ins: Mapping[tuple[str, int], HandInFile]
) -> Mapping[str, _Shown]:
    shown = {work.lesson: _Shown(work) for work in works}
    for (lesson, step), file in hand_ins.items():
        shown.setdefault(lesson, _Shown(LessonWork(lesson))).hand_ins[step] = file
    return shown


def _lesson(name: str, shown: _Shown) -> RecordedLesson:
    opened: OpenLesson | None = None
    # What was done in a lesson that is gone is still shown.
    with suppress(LearnBlockError, OSError):
        opened = find_lesson(name)
    steps = opened.lesson.step if opened else ()
    hand_ins = (_hand_in(file, steps) for _, file in sorted(shown.hand_ins.items()))
    recorded = RecordedLesson(
        name,
        name,
        at=shown.at,
        step=shown.step,
        runs=shown.work.runs,
        hints=shown.work.hints,
        hand_ins=tuple(hand_ins),
    )
    if opened is None:
        return recorded
    earned, needed = shown.needed(enumerate(steps, 1))
    return replace(
        recorded,
        title=plain(opened.lesson.title),
        picture=opened.lesson.picture or "",
        steps=len(steps),
        stars=sum(len(shown.earned(number, step)) for number, step in enumerate(steps, 1)),
        all_stars=sum(len(list(star_names(step))) for step in steps),
        done=0 < needed == earned,
        aims=tuple(_aims(opened.lesson, shown)),
    )


def _hand_in(file: HandInFile, steps: Sequence[Step]) -> RecordedHandIn:
    number, back = file.work.step, file.back
    return RecordedHandIn(
        number,
        plain(steps[number - 1].title) if number <= len(steps) else "",
        file.at,
        marks=tuple(given.mark for given in back if given.mark),
        note=back[-1].note if back else "",
        improved=len(back) - (not file.is_new),
        waits=file.is_new,
    )


def _aims(lesson: Lesson, shown: _Shown) -> Iterator[RecordedAim]:
    by_aim = {evidence.aim: evidence for evidence in lesson.evidence}
    for number, aim in enumerate(lesson.aims, 1):
        evidence = by_aim.get(number)
        steps = [
            (place, step)
            for place, step in enumerate(lesson.step, 1)
            if evidence is None or place in evidence.steps
        ]
        earned, needed = shown.needed(steps)
        standards = evidence.standards if evidence else ()
        yield RecordedAim(plain(aim), 0 < needed == earned, earned, needed, standards)


def _needed(stars: Iterable[str]) -> set[str]:
    """The stars without those for more than was asked."""
    return {star for star in stars if star in {GOALS, QUIZ, PUZZLE}}
