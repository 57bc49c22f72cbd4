"""Handlers of messages about lessons that a teacher makes or changes, and about their notes."""

from collections.abc import Callable, Iterable, Iterator, Mapping
from typing import Any

import msgspec
from anyio import to_thread

from learnblock.blocks import block_sets
from learnblock.blocks.known import all_configurations
from learnblock.errors import LearnBlockError
from learnblock.i18n import Phrase
from learnblock.lessons import drafting, editing, packing, reading, texts
from learnblock.lessons.archive import SUFFIX
from learnblock.lessons.checks import Check
from learnblock.lessons.describing import describe
from learnblock.lessons.editing import EditedLesson, Examined
from learnblock.lessons.opened import OpenLesson
from learnblock.lessons.teachers_part import SolvedStep, WrongProgram, teachers_part
from learnblock.server import catalog, messages
from learnblock.server.pages.page import Handlers, Page
from learnblock.server.sessions import lesson_view
from learnblock.storage.learned_types import learned

HANDLERS = Handlers()


@HANDLERS.add
async def _make(page: Page, _: messages.MakeLesson) -> None:
    page.require_teacher()
    session = page.session
    programs = [
        drafting.Drafted(part.name, part.robot.name, part.document.blocktext)
        for part in session.parts
    ]
    shown = session.shown_blocks.name
    blocks = shown if shown in block_sets.BUILT_IN and shown != block_sets.EVERYTHING else ""

    def make() -> EditedLesson:
        return drafting.draft(session.name, session.world, programs, blocks)

    page.send(await to_thread.run_sync(_to_edit, make))


@HANDLERS.add
async def _change(page: Page, message: messages.ChangeLesson) -> None:
    page.require_teacher()

    def read() -> EditedLesson:
        return editing.edited_lesson(catalog.find_own(message.lesson))

    page.send(await to_thread.run_sync(_to_edit, read))


@HANDLERS.add
async def _copy(page: Page, message: messages.CopyLesson) -> None:
    page.require_teacher()

    def copy() -> EditedLesson:
        return editing.edited_lesson(catalog.copy_lesson(message.lesson))

    page.send(await to_thread.run_sync(_to_edit, copy))


def _to_edit(find: Callable[[], EditedLesson]) -> messages.LessonToEdit:
    return messages.LessonToEdit(find(), tuple(sorted(all_configurations())))


@HANDLERS.add
async def _examine(page: Page, message: messages.ExamineLesson) -> None:
    page.send(await to_thread.run_sync(_examined, message.edited, _saved(page, message.edited)))


@HANDLERS.add
async def _save(page: Page, message: messages.SaveLesson) -> None:
    page.require_teacher()
    edited = message.edited
    opened = await _assembled(page, edited)
    if opened is None:
        return

    def save() -> str:
        return catalog.add_lesson(opened.name, packing.pack(opened)).name

    page.send(messages.LessonSaved(await to_thread.run_sync(save)))


@HANDLERS.add
async def _try(page: Page, message: messages.TryLesson) -> None:
    if opened := await _assembled(page, message.edited):
        page.lesson_trial.start(opened)


@HANDLERS.add
async def _stop(page: Page, _: messages.StopTrying) -> None:
    page.lesson_trial.stop()


@HANDLERS.add
async def _export(page: Page, message: messages.ExportLesson) -> None:
    if not message.for_pupils:
        page.require_teacher()

    def pack() -> bytes:
        opened = catalog.find_own(message.lesson)
        return packing.pack(reading.for_pupils(opened) if message.for_pupils else opened)

    content = await to_thread.run_sync(pack)
    page.send(messages.LessonExported(f"{message.lesson}{SUFFIX}", content))


async def _assembled(page: Page, edited: EditedLesson) -> OpenLesson | None:
    """The lesson; None if it has mistakes, which were sent to the page."""
    saved = _saved(page, edited)
    examined = await to_thread.run_sync(_examined, edited, saved)
    if examined.problems:
        page.send(msgspec.structs.replace(examined, refused=True))
        return None

    def assemble() -> OpenLesson:
        name = edited.lesson or catalog.free_lesson_name(_title(edited))
        return editing.assemble(edited, name, saved)

    return await to_thread.run_sync(assemble)


def _saved(page: Page, edited: EditedLesson) -> OpenLesson | None:
    """The saved lesson to change; None for a new one.

    Raises:
        LearnBlockError: it is missing, or the page may not change it.
    """
    if not edited.lesson:
        return None
    page.require_teacher()
    return catalog.find_own(edited.lesson)


def _title(edited: EditedLesson) -> str:
    title = edited.content.get("title")
    texts = [title] if isinstance(title, str) else [*title.values()] if title else []
    return next((text for text in texts if isinstance(text, str)), "")


def _examined(edited: EditedLesson, saved: OpenLesson | None) -> messages.LessonExamined:
    examined = editing.examine(edited, edited.lesson or "lesson", saved)
    steps = examined.content.get("step")
    tables = [step for step in steps if isinstance(step, dict)] if isinstance(steps, list) else []
    return messages.LessonExamined(
        problems=tuple(
            messages.LessonProblem(problem.path, problem.message) for problem in examined.problems
        ),
        steps=tuple(_examined_step(examined, index, step) for index, step in enumerate(tables)),
        drawings=lesson_view.drawings_in(_texts(tables)),
    )


def _examined_step(
    examined: Examined, index: int, step: Mapping[str, Any]
) -> messages.ExaminedStep:
    checks = step.get("check")
    words = tuple(map(_words, checks)) if isinstance(checks, list) else ()
    if examined.lesson is None:
        return messages.ExaminedStep(words)
    try:
        opened = OpenLesson("lesson", examined.lesson, None, examined.files)
        world = opened.described_world(index + 1)
    except LearnBlockError:
        # It is among the problems.
        return messages.ExaminedStep(words)
    if world is None:
        return messages.ExaminedStep(words)
    goals = tuple(goal.name for _, _, goal in world.goal.all())
    return messages.ExaminedStep(words, goals, tuple(line.name for line in world.line))


def _words(check: object) -> Phrase | None:
    try:
        return describe(msgspec.convert(check, learned(Check)))
    except (msgspec.ValidationError, ValueError):
        return None


def _texts(steps: Iterable[Mapping[str, Any]]) -> Iterator[str]:
    for step in steps:
        text = step.get("text")
        for translation in text.values() if isinstance(text, dict) else [text]:
            if isinstance(translation, str) and len(translation) <= texts.LONGEST:
                yield translation


@HANDLERS.add
async def _read_notes(page: Page, message: messages.ReadLessonNotes) -> None:
    page.require_teacher()
    page.send(await to_thread.run_sync(_notes, message.lesson))


@HANDLERS.add
async def _make_worksheet(page: Page, message: messages.MakeWorksheet) -> None:
    page.require_teacher()

    def make() -> bytes:
        from learnblock.lessons.worksheet import worksheet  # noqa: PLC0415 - the page opens before

        return worksheet(reading.named_lesson(message.lesson), message.language).encode()

    content = await to_thread.run_sync(make)
    page.send(messages.WorksheetMade(f"{message.lesson}.html", content))


def _notes(name: str) -> messages.LessonNotes:
    opened = reading.named_lesson(name)
    part = teachers_part(opened)
    return messages.LessonNotes(
        lesson=name,
        title=texts.plain(opened.lesson.title),
        notes=dict(part.notes),
        drawings=lesson_view.drawings_in(part.notes.values()),
        steps=tuple(map(_step, part.steps)),
    )


def _step(solved: SolvedStep) -> messages.SolvedStep:
    return messages.SolvedStep(
        texts.plain(solved.step.title), solved.solution, tuple(map(_wrong, solved.wrong))
    )


def _wrong(wrong: WrongProgram) -> messages.WrongProgram:
    return messages.WrongProgram(
        wrong.program, lesson_view.words(wrong.check), tuple(map(lesson_view.words, wrong.hint))
    )
