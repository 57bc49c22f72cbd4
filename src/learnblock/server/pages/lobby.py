"""The entry point of pages, which greets them and connects them to their projects."""

import asyncio
from collections.abc import Iterable
from functools import partial
from pathlib import Path

from anyio import to_thread
from starlette.websockets import WebSocket

from learnblock.i18n import Phrase
from learnblock.project.files.folder import ProjectFolder
from learnblock.server import catalog
from learnblock.server.catalog.classes import ClassShelf
from learnblock.server.pages import (
    asking,
    block_sets,
    class_lessons,
    connecting,
    containment,
    controlling,
    custom_blocks,
    editing,
    guests,
    kept,
    lesson_editor,
    lessons,
    libraries,
    looking,
    projecting,
    robot_making,
    settings,
    sharing,
    tabs,
    tags,
    world_editing,
)
from learnblock.server.pages.classes import HANDLERS as CLASS_HANDLERS
from learnblock.server.pages.page import Page
from learnblock.server.sessions.periods import Periods
from learnblock.server.sessions.sessions import Sessions

HANDLERS = {
    **projecting.HANDLERS,
    **sharing.HANDLERS,
    **editing.HANDLERS,
    **asking.HANDLERS,
    **controlling.HANDLERS,
    **looking.HANDLERS,
    **kept.HANDLERS,
    **lessons.HANDLERS,
    **class_lessons.HANDLERS,
    **guests.HANDLERS,
    **lesson_editor.HANDLERS,
    **world_editing.HANDLERS,
    **block_sets.HANDLERS,
    **tabs.HANDLERS,
    **tags.HANDLERS,
    **settings.HANDLERS,
    **libraries.HANDLERS,
    **containment.HANDLERS,
    **custom_blocks.HANDLERS,
    **robot_making.HANDLERS,
    **connecting.HANDLERS,
    **CLASS_HANDLERS,
}


class Lobby:
    """Serves every page.

    Args:
        folder: the projects folder.
        periods: how long an open project waits to be saved, and to be closed.
        read_only: why nothing may be written; None if it may.
        for_others: whether other computers can connect.
        for_one: whether all pages belong to one person, on any device.
        address: the address by which other devices reach this computer, if it is in a network.
        classes: the teacher's classes; None if there can't be any.
    """

    def __init__(
        self,
        folder: Path,
        periods: Periods,
        read_only: Phrase | None = None,
        *,
        for_others: bool = False,
        for_one: bool = False,
        address: str | None = None,
        classes: ClassShelf | None = None,
    ) -> None:
        self._folder = folder
        self._read_only = read_only
        self._should_warn = for_others
        self._for_one = for_one
        self._address = address
        self.classes = classes
        projects = ProjectFolder(folder, read_only=read_only is not None)
        self._sessions = Sessions(projects, periods, for_one=for_one)

    async def serve(
        self, socket: WebSocket, *, is_local: bool = False, has_seat: bool = False
    ) -> None:
        """Serve a page until it has disconnected.

        Args:
            socket: the page's websocket.
            is_local: whether its user is at this computer.
            has_seat: whether a class's wall shows what the page works on.
        """
        page = Page(
            socket,
            self._sessions,
            HANDLERS,
            is_local=is_local,
            is_alone=self._for_one,
            has_seat=has_seat,
            classes=self.classes,
        )
        warns = self._should_warn and is_local
        self._should_warn = self._should_warn and not warns
        folder = str(self._folder)
        welcome = partial(
            catalog.welcome,
            folder,
            self._read_only,
            warns=warns,
            teaches=is_local,
            address=self._address,
        )
        page.send(await to_thread.run_sync(welcome))
        await page.serve()

    async def close(self) -> None:
        """End all programs, and save all projects."""
        await self._sessions.close()
        if self.classes:
            await to_thread.run_sync(self.classes.end)

    def save_from_outside(
        self, loop: asyncio.AbstractEventLoop, seconds: float
    ) -> Iterable[Phrase]:
        """Save all projects from another thread: see `Sessions.save_from_outside`."""
        return self._sessions.save_from_outside(loop, seconds)
