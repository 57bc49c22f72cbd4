"""Handlers of messages about the teacher's classes, which only a page on this computer sends."""

from anyio import to_thread

from learnblock.errors import LearnBlockError
from learnblock.server import messages
from learnblock.server.catalog.classes import ClassShelf
from learnblock.server.pages.page import Handlers, Page

HANDLERS = Handlers()


@HANDLERS.add
async def _list(page: Page, _: messages.ListClasses) -> None:
    page.send(messages.Classes(await to_thread.run_sync(_shelf(page).entries)))


@HANDLERS.add
async def _start(page: Page, message: messages.StartClass) -> None:
    wall = await to_thread.run_sync(_shelf(page).start, message)
    page.send(messages.ClassOpened(wall, message.request))
    await _list(page, messages.ListClasses())


@HANDLERS.add
async def _close(page: Page, message: messages.CloseClass) -> None:
    await to_thread.run_sync(_shelf(page).close, message.title)
    await _list(page, messages.ListClasses())


@HANDLERS.add
async def _delete(page: Page, message: messages.DeleteClass) -> None:
    await to_thread.run_sync(_shelf(page).delete, message.title)
    await _list(page, messages.ListClasses())


def _shelf(page: Page) -> ClassShelf:
    """The teacher's classes.

    Raises:
        LearnBlockError: the page is not at this computer, or its server has no classes.
    """
    if page.classes is None or not page.is_local:
        raise LearnBlockError("server-classes-only-here")
    return page.classes
