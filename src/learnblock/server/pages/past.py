"""Handlers of messages about the history of a project."""

from collections.abc import Mapping

from anyio import to_thread

from learnblock.server import messages
from learnblock.server.pages.page import Handler, Page


async def _list_history(page: Page, _: messages.ListHistory) -> None:
    folder, name = page.sessions.folder, page.session.name
    versions = await to_thread.run_sync(folder.versions, name)
    runs = await to_thread.run_sync(folder.runs, name)
    page.send(messages.History(versions, runs))


async def _restore(page: Page, message: messages.Restore) -> None:
    folder, session = page.sessions.folder, page.session
    earlier = await to_thread.run_sync(folder.read_version, session.name, message.version)
    await session.restore(earlier)


HANDLERS: Mapping[type, Handler] = {
    messages.ListHistory: _list_history,
    messages.Restore: _restore,
}
