"""What a lesson has for its teacher, ready to be read: notes, solutions, typical wrong programs."""

from collections.abc import Mapping
from dataclasses import dataclass

from learnblock import language
from learnblock.errors import FileError
from learnblock.i18n import Phrase
from learnblock.lessons.describing import describe
from learnblock.lessons.editing import notes_of
from learnblock.lessons.lesson import Step, Wrong
from learnblock.lessons.opened import OpenLesson
from learnblock.lessons.texts import Title

_OF_THE_LESSON = "teacher-"


@dataclass(frozen=True, slots=True)
class WrongProgram:
    """A typical wrong program.

    Args:
        program: its text, in Block-Text.
        check: the check that it fails, as text.
        hint: the hint that it gets: the lesson's own levels, or the most general of ours.
    """

    program: str
    check: Phrase | Title
    hint: tuple[Phrase | Title, ...]


@dataclass(frozen=True, slots=True)
class SolvedStep:
    """A step with what only the teacher has.

    Args:
        number: its number.
        step: the step.
        solution: the solution in Block-Text; empty if there is none.
        wrong: typical wrong programs.
    """

    number: int
    step: Step
    solution: str
    wrong: tuple[WrongProgram, ...]


@dataclass(frozen=True, slots=True)
class TeachersPart:
    """What a lesson has for its teacher.

    Args:
        notes: the notes in Markdown, by language.
        steps: the steps.
    """

    notes: Mapping[str, str]
    steps: tuple[SolvedStep, ...]


def teachers_part(opened: OpenLesson) -> TeachersPart:
    """What a lesson has for its teacher; empty for a pupil's copy.

    Raises:
        LessonError: one of its files is missing or not UTF-8.
    """
    steps = (_solved(opened, number) for number in range(1, len(opened.lesson.step) + 1))
    return TeachersPart(notes_of(opened), tuple(steps))


def _solved(opened: OpenLesson, number: int) -> SolvedStep:
    step, teacher = opened.step(number), opened.teacher
    if teacher is None:
        return SolvedStep(number, step, "", ())
    file, text = teacher.solutions.get(str(number), ""), opened.solution(number)
    wrong = (_wrong(opened, step, program) for program in teacher.wrong if program.step == number)
    return SolvedStep(number, step, _blocktext(file, text or ""), tuple(wrong))


def _wrong(opened: OpenLesson, step: Step, wrong: Wrong) -> WrongProgram:
    text = opened.text(f"teacher/wrong/{wrong.program}")
    return WrongProgram(
        _blocktext(wrong.program, text), _check(step, wrong.check), _hint(step, wrong.hint)
    )


def _check(step: Step, name: str) -> Phrase | Title:
    """A check by its name or kind, in the lesson's words or in ours."""
    fitting = (check for check in step.check if name in (check.name, check.__struct_config__.tag))
    check = next(fitting, None)
    if check is None:
        return name
    return check.say or describe(check)


def _hint(step: Step, rule: str) -> tuple[Phrase | Title, ...]:
    """The level of a hint that fits every run: the others name lines and values of the program."""
    number = rule.removeprefix(_OF_THE_LESSON)
    if number == rule or not number.isdecimal():
        return (Phrase(f"{rule}-how"),)
    return step.hint[int(number) - 1].say if 0 < int(number) <= len(step.hint) else ()


def _blocktext(file: str, text: str) -> str:
    if not file.endswith(".py"):
        return text
    try:
        return language.format(language.from_python(text))
    except FileError:
        # Block-Text has no words for everything that Python has.
        return text
