"""Where pages come in: they are greeted here, and from here they open their projects."""

from pathlib import Path

from anyio import to_thread
from starlette.websockets import WebSocket

from learnblock.server import catalog
from learnblock.server.pages import (
    asking,
    block_sets,
    controlling,
    editing,
    libraries,
    own_blocks,
    past,
    projecting,
    robot_making,
    settings,
    tags,
    world_editing,
)
from learnblock.server.pages.page import Page
from learnblock.server.projects.folder import ProjectFolder
from learnblock.server.sessions.open_projects import Sessions

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
    **own_blocks.HANDLERS,
    **robot_making.HANDLERS,
}


class Lobby:
    """Serves every page.

    Args:
        folder: where the projects are.
        grace: seconds for which a project stays open without a page.
    """

    def __init__(self, folder: Path, grace: float) -> None:
        self._folder = folder
        self._sessions = Sessions(ProjectFolder(folder), grace)

    async def serve(self, socket: WebSocket) -> None:
        """Return when the page has gone."""
        page = Page(socket, self._sessions, HANDLERS)
        page.tell(await to_thread.run_sync(catalog.welcome, str(self._folder)))
        await page.serve()

    async def close(self) -> None:
        """End every program, and save every project."""
        await self._sessions.close()
