"""Handlers of what a class at a hub sends on behalf of a pupil's page."""

from anyio import to_thread

from learnblock.project.files.lesson_work import lesson_works
from learnblock.server import catalog, messages
from learnblock.server.pages.page import Handlers, Page

HANDLERS = Handlers()


@HANDLERS.add
async def _take_lesson(page: Page, message: messages.GiveLesson) -> None:
    page.require_class()
    await to_thread.run_sync(catalog.take_lesson, message.lesson, message.content)


@HANDLERS.add
async def _read_work(page: Page, _: messages.ReadLessonWork) -> None:
    page.require_class()
    works = await to_thread.run_sync(lesson_works, page.sessions.folder)
    page.give(messages.LessonWorkRead(works))
