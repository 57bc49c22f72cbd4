"""Handlers of messages about what any lesson has for its teacher, also one of ours."""

from anyio import to_thread

from learnblock.blocks.known import all_configurations
from learnblock.lessons import editing
from learnblock.lessons.teachers_part import SolvedStep, WrongProgram, teachers_part
from learnblock.server import catalog, messages
from learnblock.server.pages.handlers import Handlers
from learnblock.server.pages.page import Page
from learnblock.server.pages.teaching import require_teacher
from learnblock.server.sessions.lesson_view import drawings_in, plain, words

HANDLERS = Handlers()


@HANDLERS.add
async def _read(page: Page, message: messages.ReadLessonNotes) -> None:
    require_teacher(page)
    page.send(await to_thread.run_sync(_notes, message.lesson))


def _notes(name: str) -> messages.LessonNotes:
    opened = catalog.find_whole(name)
    part = teachers_part(opened)
    return messages.LessonNotes(
        lesson=name,
        title=plain(opened.lesson.title),
        notes=dict(part.notes),
        drawings=drawings_in(part.notes.values()),
        steps=tuple(map(_step, part.steps)),
    )


def _step(solved: SolvedStep) -> messages.SolvedStep:
    return messages.SolvedStep(
        plain(solved.step.title), solved.solution, tuple(map(_wrong, solved.wrong))
    )


def _wrong(wrong: WrongProgram) -> messages.WrongProgram:
    return messages.WrongProgram(wrong.program, words(wrong.check), tuple(map(words, wrong.hint)))


@HANDLERS.add
async def _copy(page: Page, message: messages.CopyLesson) -> None:
    require_teacher(page)

    def copy() -> messages.LessonToEdit:
        edited = editing.edited_lesson(catalog.copy_lesson(message.lesson))
        return messages.LessonToEdit(edited, tuple(sorted(all_configurations())))

    page.send(await to_thread.run_sync(copy))
