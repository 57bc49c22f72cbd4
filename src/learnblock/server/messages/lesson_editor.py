"""Messages about lessons that a teacher makes or changes on the page.

They contain the teacher's part, so a saved lesson is opened only for a user at the server's
own computer.
"""

from typing import Literal

from msgspec import Struct, field

from learnblock.i18n import Phrase
from learnblock.language.workspace.blocks import Workspace
from learnblock.lessons.editing import EditedLesson
from learnblock.lessons.lesson import LessonText
from learnblock.project.files.lesson_folder import LessonName
from learnblock.server.messages.base import Computer, FromReader, Name, ToPage
from learnblock.server.messages.lessons import LessonWords

# From the page.


class MakeLesson(Computer, FromReader, frozen=True):
    """Ask for a lesson made from the open project: `LessonToEdit`."""


class ChangeLesson(Computer, FromReader, frozen=True):
    """Ask for a lesson of the user's, to change it: `LessonToEdit`."""

    lesson: LessonName


class ReadLessonNotes(Computer, FromReader, frozen=True):
    """Ask for a lesson's part for the teacher: `LessonNotes`."""

    lesson: LessonName


class MakeWorksheet(Computer, FromReader, frozen=True):
    """Ask for a lesson on paper, with its solutions: `WorksheetMade`.

    Args:
        lesson: its name.
        language: of the sheet.
    """

    lesson: LessonName
    language: Name = "en"


class CopyLesson(Computer, frozen=True):
    """Add a copy of a lesson to the user's, to change it: `LessonToEdit`."""

    lesson: LessonName


class ExamineLesson(Computer, FromReader, frozen=True):
    """Ask for the mistakes in a lesson and its checks in words: `LessonExamined`."""

    edited: EditedLesson


class SaveLesson(Computer, frozen=True):
    """Save a lesson in the user's folder: `LessonSaved`, or `LessonExamined` if it has mistakes."""

    edited: EditedLesson


class TryLesson(Computer, FromReader, frozen=True):
    """Try the solutions of a lesson that need not be saved.

    `LessonTried` follows, again and again; or `LessonExamined` if the lesson has mistakes.
    """

    edited: EditedLesson


class StopTrying(Computer, FromReader, frozen=True):
    """Stop what `TryLesson` began."""


class ExportLesson(Computer, FromReader, frozen=True):
    """Ask for a lesson of the user's as a file: `LessonExported`.

    Args:
        lesson: its name.
        for_pupils: whether the teacher's part is left out.
    """

    lesson: LessonName
    for_pupils: bool = True


# From the server.


class LessonToEdit(ToPage, frozen=True):
    """A lesson to make or to change.

    Args:
        edited: the lesson.
        skills: the names of the skills that checks may ask for.
    """

    edited: EditedLesson
    skills: tuple[str, ...] = ()


class WrongProgram(Struct, frozen=True, omit_defaults=True):
    """A typical wrong program.

    Args:
        program: its text, in Block-Text.
        check: the check that it fails.
        hint: the hint that it gets.
    """

    program: str
    check: LessonWords
    hint: tuple[LessonWords, ...] = ()


class SolvedStep(Struct, frozen=True, omit_defaults=True):
    """A step with its teacher's part.

    Args:
        title: its title.
        solution: the solution in Block-Text; empty if there is none.
        wrong: typical wrong programs.
    """

    title: LessonText
    solution: str = ""
    wrong: tuple[WrongProgram, ...] = ()


class LessonNotes(ToPage, frozen=True):
    """A lesson's part for the teacher.

    Args:
        lesson: its name.
        title: its title.
        notes: the notes in Markdown, by language.
        drawings: the blocks of the notes, by their Block-Text.
        steps: its steps.
    """

    lesson: str
    title: LessonText
    notes: dict[str, str] = field(default_factory=dict)
    drawings: dict[str, Workspace] = field(default_factory=dict)
    steps: tuple[SolvedStep, ...] = ()


class LessonProblem(Struct, frozen=True, omit_defaults=True):
    """A mistake in a lesson.

    Args:
        path: where it is, such as ``["step", 0, "title"]``; empty for the whole lesson.
        message: what is wrong and what to do.
    """

    path: tuple[str | int, ...]
    message: Phrase


class ExaminedStep(Struct, frozen=True, omit_defaults=True):
    """What is known about a step.

    Args:
        checks: what each check asks for, in words; None for one with mistakes.
        goals: the names of the goals of its world.
        lines: the names of the lines in its world.
    """

    checks: tuple[Phrase | None, ...] = ()
    goals: tuple[str, ...] = ()
    lines: tuple[str, ...] = ()


class LessonExamined(ToPage, frozen=True):
    """What is known about a lesson that is being edited.

    Args:
        problems: its mistakes.
        steps: its steps.
        drawings: the blocks of its texts, by their Block-Text.
        refused: whether it was not saved or tried because of the mistakes.
    """

    problems: tuple[LessonProblem, ...] = ()
    steps: tuple[ExaminedStep, ...] = ()
    drawings: dict[str, Workspace] = field(default_factory=dict)
    refused: bool = False


class LessonSaved(ToPage, frozen=True):
    """A lesson is saved under this name."""

    lesson: str


class TriedProgram(Struct, frozen=True, omit_defaults=True):
    """The result of one of the teacher's programs.

    Args:
        sort: a solution, a program that should fail, or checks without a solution.
        step: the number of its step.
        right: in how many attempts it did what it should.
        attempts: how many attempts were made.
        problems: what is wrong.
    """

    sort: Literal["solution", "wrong", "none"]
    step: int
    right: int = 0
    attempts: int = 0
    problems: tuple[Phrase, ...] = ()


class LessonTried(ToPage, frozen=True):
    """How far the trial of a lesson's solutions has come.

    Args:
        programs: those that have been tried.
        done: how many attempts were made.
        count: how many there are.
        running: whether it is still running.
        problem: why it could not continue.
    """

    programs: tuple[TriedProgram, ...] = ()
    done: int = 0
    count: int = 0
    running: bool = False
    problem: Phrase | None = None


class LessonExported(ToPage, frozen=True):
    """A lesson as a file."""

    filename: str
    content: bytes


class WorksheetMade(ToPage, frozen=True):
    """A lesson on paper: a page to print, in one file."""

    filename: str
    content: bytes
