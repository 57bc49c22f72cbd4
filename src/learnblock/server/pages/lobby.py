"""The entry point of pages, which greets them and connects them to their projects."""

from pathlib import Path

from anyio import to_thread
from starlette.websockets import WebSocket

from learnblock.i18n import Phrase
from learnblock.server import catalog
from learnblock.server.pages import (
    asking,
    block_sets,
    carrying,
    controlling,
    custom_blocks,
    editing,
    libraries,
    past,
    projecting,
    robot_making,
    settings,
    tags,
    world_editing,
)
from learnblock.server.pages.page import Page
from learnblock.server.projects.folder import ProjectFolder
from learnblock.server.sessions.sessions import Sessions

HANDLERS = {
    **projecting.HANDLERS,
    **past.HANDLERS,
    **editing.HANDLERS,
    **asking.HANDLERS,
    **controlling.HANDLERS,
    **world_editing.HANDLERS,
    **block_sets.HANDLERS,
    **tags.HANDLERS,
    **settings.HANDLERS,
    **libraries.HANDLERS,
    **carrying.HANDLERS,
    **custom_blocks.HANDLERS,
    **robot_making.HANDLERS,
}


class Lobby:
    """Serves every page.

    Args:
        folder: the projects folder.
        grace: seconds for which a project stays open without a page.
        read_only: why nothing may be written; None if it may.
    """

    def __init__(self, folder: Path, grace: float, read_only: Phrase | None = None) -> None:
        self._folder = folder
        self._read_only = read_only
        self._sessions = Sessions(ProjectFolder(folder, read_only=read_only is not None), grace)

    async def serve(self, socket: WebSocket) -> None:
        """Serve a page until it has disconnected."""
        page = Page(socket, self._sessions, HANDLERS)
        page.send(await to_thread.run_sync(catalog.welcome, str(self._folder), self._read_only))
        await page.serve()

    async def close(self) -> None:
        """End all programs, and save all projects."""
        await self._sessions.close()
