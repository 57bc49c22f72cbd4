"""Handlers of messages about lessons."""

from contextlib import nullcontext
from pathlib import PurePath

from anyio import to_thread
from msgspec.structs import replace

from learnblock.errors import LearnBlockError
from learnblock.lessons.archive import received_files
from learnblock.lessons.key_presses import recorded_keys
from learnblock.lessons.texts import plain
from learnblock.project.files.lesson_folder import Progress
from learnblock.server import catalog, messages
from learnblock.server.pages.page import Handlers, Page
from learnblock.server.sessions import lesson_stage
from learnblock.server.sessions.coach import Coach
from learnblock.storage.archive import zipped

HANDLERS = Handlers()


@HANDLERS.add
async def _list(page: Page, _: messages.ListLessons) -> None:
    page.send(await to_thread.run_sync(_lessons, page))


def _lessons(page: Page) -> messages.Lessons:
    """The lessons, with the progress of the user's own projects."""
    folder = page.sessions.folder
    choices, problems = catalog.lesson_choices()
    begun: dict[str, messages.LessonChoice] = {}
    # The user continues with the project that was changed last.
    for entry in reversed(folder.entries()):
        progress = folder.lesson(entry.name).progress()
        lesson = next(
            (choice for choice in choices if progress and choice.name == progress.lesson), None
        )
        if progress is None or lesson is None or not _is_own(page, progress):
            continue
        earned = sum(len(step.stars) for step in progress.steps.values())
        before = begun.get(lesson.name, lesson)
        begun[lesson.name] = replace(
            lesson,
            earned=min(max(earned, before.earned), lesson.stars),
            step=progress.step,
            project=entry.name,
        )
    return messages.Lessons(tuple(begun.get(choice.name, choice) for choice in choices), problems)


def _is_own(page: Page, progress: Progress) -> bool:
    """Whether a project was begun in the page's browser, or by its user on any device.

    Projects from before browsers identified themselves belong to the server's own computer.
    """
    if page.is_alone:
        return True
    return progress.browser == page.browser or (page.is_local and not progress.browser)


@HANDLERS.add
async def _introduce(page: Page, message: messages.Introduce) -> None:
    page.browser = message.browser


@HANDLERS.add
async def _start(page: Page, message: messages.StartLesson) -> None:
    before = page.session if page.has_session else None
    await _open_lesson(page, message)
    if message.step:
        # The page has the turn of the project that it showed before.
        async with nullcontext() if page.session is before else page.session.turn:
            await _coach(page).show_step(message.step)
        await _tell_worlds(page)


async def _open_lesson(page: Page, message: messages.StartLesson) -> None:
    opened = await to_thread.run_sync(catalog.find_lesson, message.lesson)
    listed = await to_thread.run_sync(_lessons, page)
    begun = next((choice.project for choice in listed.lessons if choice.name == message.lesson), "")
    if begun and not message.again:
        await page.move_to(await page.sessions.open(begun))
        return
    page.new_projects.take()
    project = await to_thread.run_sync(
        lesson_stage.beginning, opened, 1, message.name, message.robot
    )
    session = await page.sessions.start(project)
    await session.begin_lesson(opened, page.browser)
    await page.move_to(session)
    await _tell_worlds(page)


@HANDLERS.add
async def _show_step(page: Page, message: messages.ShowStep) -> None:
    await _coach(page).show_step(message.step)
    await _tell_worlds(page)


async def _tell_worlds(page: Page) -> None:
    """Send the worlds again: a step may have added one of the lesson's worlds."""
    page.send(messages.Worlds(await to_thread.run_sync(catalog.world_choices)))


@HANDLERS.add
async def _restart_step(page: Page, _: messages.RestartStep) -> None:
    await _coach(page).restart_step()


@HANDLERS.add
async def _check(page: Page, _: messages.CheckStep) -> None:
    with page.sessions.starting(page.session):
        await _coach(page).check()


@HANDLERS.add
async def _stop_checking(page: Page, _: messages.StopChecking) -> None:
    _coach(page).stop_checking()


@HANDLERS.add
async def _hand_in(page: Page, _: messages.HandIn) -> None:
    page.give(messages.WorkGiven(await _coach(page).work()))


@HANDLERS.add
async def _show_variant(page: Page, message: messages.ShowVariant) -> None:
    with page.sessions.starting(page.session):
        coach = _coach(page)
        await coach.show_variant(message.robot, message.variant)
        player = page.session.parts.first.players[0]
        await page.session.runs.run(player, paused=False, keys=recorded_keys(coach.step.keys))


@HANDLERS.add
async def _take_hint(page: Page, _: messages.TakeHint) -> None:
    await _coach(page).take_hint()


@HANDLERS.add
async def _answer_quiz(page: Page, message: messages.AnswerQuiz) -> None:
    page.send(await _coach(page).answer_quiz(message.choices))


@HANDLERS.add
async def _answer_puzzle(page: Page, message: messages.AnswerPuzzle) -> None:
    page.send(await _coach(page).answer_puzzle(message.order))


@HANDLERS.add
async def _import(page: Page, message: messages.ImportLesson) -> None:
    page.require_teacher()
    await _add(page, PurePath(message.filename.replace("\\", "/")).stem, message.content)


@HANDLERS.add
async def _import_folder(page: Page, message: messages.ImportLessonFolder) -> None:
    page.require_teacher()

    def pack() -> bytes:
        return zipped(received_files(message.name, message.files))

    await _add(page, message.name, await to_thread.run_sync(pack))


async def _add(page: Page, name: str, content: bytes) -> None:
    opened = await to_thread.run_sync(catalog.add_lesson, name, content)
    page.send(messages.LessonImported(opened.name, plain(opened.lesson.title)))
    await _list(page, messages.ListLessons())


@HANDLERS.add
async def _delete(page: Page, message: messages.DeleteLesson) -> None:
    page.require_teacher()
    await to_thread.run_sync(catalog.delete_lesson, message.lesson)
    await _list(page, messages.ListLessons())


def _coach(page: Page) -> Coach:
    """The guide of the open project through its lesson.

    Raises:
        LearnBlockError: it has no lesson.
    """
    coach = page.session.coach
    if coach is None:
        raise LearnBlockError("server-lesson-none")
    return coach
