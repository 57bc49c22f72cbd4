"""A lesson as text, for ``learnblock lesson show``."""

from collections.abc import Iterator
from typing import Any

from learnblock.cli.console import text
from learnblock.cli.language import language
from learnblock.i18n import Phrase
from learnblock.lessons.describing import title_of
from learnblock.lessons.lesson import Step
from learnblock.lessons.opened import OpenLesson
from learnblock.lessons.teachers_part import SolvedStep, TeachersPart, WrongProgram
from learnblock.lessons.texts import Title, in_language


def lines_of(opened: OpenLesson, part: TeachersPart | None) -> Iterator[str]:
    """A lesson in the reader's language, line by line.

    Args:
        opened: the lesson.
        part: what it has for the teacher; None to leave that out.
    """
    lesson = opened.lesson
    yield in_language(lesson.title, language())
    robots = ", ".join(lesson.robots)
    level, minutes = lesson.level, lesson.minutes
    yield text(Phrase("lesson-show-head", level=level, minutes=minutes, robots=robots))
    for aim in lesson.aims:
        yield f"- {in_language(aim, language())}"
    if part is not None:
        yield from _notes(part)
    for number, step in enumerate(lesson.step, start=1):
        yield from _step(number, step)
        if part is not None:
            yield from _solved(part.steps[number - 1])


def as_object(opened: OpenLesson, part: TeachersPart | None) -> dict[str, Any]:
    """A lesson for tools; texts are in the reader's language."""
    lesson = opened.lesson
    fields: dict[str, Any] = {
        "name": opened.name,
        "title": in_language(lesson.title, language()),
        "level": lesson.level,
        "minutes": lesson.minutes,
        "robots": lesson.robots,
        "aims": [in_language(aim, language()) for aim in lesson.aims],
        "steps": [_step_object(step) for step in lesson.step],
    }
    if part is not None:
        fields["notes"] = in_language(part.notes, language()) if part.notes else ""
        for step, solved in zip(fields["steps"], part.steps, strict=True):
            step["solution"] = solved.solution
            step["wrong"] = [*map(_wrong_object, solved.wrong)]
    return fields


def _step(number: int, step: Step) -> Iterator[str]:
    title = in_language(step.title, language())
    yield ""
    phase = Phrase(f"page-lesson-phase-{step.phase}")
    yield text(Phrase("lesson-show-step", number=number, phase=phase, title=title))
    yield ""
    yield from _indented(in_language(step.text, language()))
    if step.check:
        yield ""
    for check in step.check:
        yield f"    * {title_of(check, language())}"


def _step_object(step: Step) -> dict[str, Any]:
    return {
        "title": in_language(step.title, language()),
        "phase": step.phase,
        "text": in_language(step.text, language()),
        "goals": [title_of(check, language()) for check in step.check],
    }


def _notes(part: TeachersPart) -> Iterator[str]:
    yield ""
    if not part.notes and not any(step.solution for step in part.steps):
        yield text(Phrase("lesson-show-no-part"))
    elif part.notes:
        yield text(Phrase("lesson-show-notes"))
        yield ""
        yield from _indented(in_language(part.notes, language()))


def _solved(solved: SolvedStep) -> Iterator[str]:
    if solved.solution:
        yield from _headed(text(Phrase("lesson-show-solution")), solved.solution)
    for wrong in solved.wrong:
        head = Phrase("lesson-show-wrong", check=_words(wrong.check))
        yield from _headed(text(head), wrong.program)
        yield from _headed(text(Phrase("lesson-show-hint")), "\n".join(map(_words, wrong.hint)))


def _wrong_object(wrong: WrongProgram) -> dict[str, Any]:
    return {
        "program": wrong.program,
        "check": _words(wrong.check),
        "hint": [*map(_words, wrong.hint)],
    }


def _words(title: Phrase | Title) -> str:
    return text(title) if isinstance(title, Phrase) else in_language(title, language())


def _headed(head: str, body: str) -> Iterator[str]:
    yield ""
    yield f"  {head}"
    yield ""
    yield from _indented(body)


def _indented(body: str) -> Iterator[str]:
    for line in body.strip("\n").split("\n"):
        yield f"    {line}" if line.strip() else ""
