"""Handlers of messages about the history of a project."""

from anyio import to_thread

from learnblock.server import messages
from learnblock.server.pages.handlers import Handlers
from learnblock.server.pages.page import Page

HANDLERS = Handlers()


@HANDLERS.add
async def _list_history(page: Page, _: messages.ListHistory) -> None:
    folder, name = page.sessions.folder, page.session.name
    versions = await to_thread.run_sync(folder.versions, name)
    runs = await to_thread.run_sync(folder.runs, name)
    page.send(messages.History(versions, runs))


@HANDLERS.add
async def _restore(page: Page, message: messages.Restore) -> None:
    folder, session = page.sessions.folder, page.session
    earlier = await to_thread.run_sync(folder.read_version, session.name, message.version)
    await session.restore(earlier)
