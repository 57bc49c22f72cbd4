"""The projects that are open."""

import asyncio
from collections.abc import Callable, Mapping
from dataclasses import replace

from anyio import to_thread

from learnblock.blocks import BlockConfiguration, all_configurations
from learnblock.errors import LearnBlockError
from learnblock.server.messages import Message, PaletteChanged
from learnblock.server.projects.folder import ProjectFolder
from learnblock.server.projects.project_file import Project, checked_name
from learnblock.server.sessions.own_files import OwnFiles
from learnblock.server.sessions.prepared import prepare
from learnblock.server.sessions.session import Session


class Sessions:
    """The projects that are open, by name.

    Args:
        folder: where projects are.
        grace: seconds for which a project stays open without a page: a page that is loaded again
            finds its program still running.
    """

    def __init__(self, folder: ProjectFolder, grace: float) -> None:
        self.folder = folder
        self._grace = grace
        self._open: dict[str, Session] = {}
        self._ending: dict[str, asyncio.Task[None]] = {}
        self._renewing: set[asyncio.Task[None]] = set()
        #: To see whether somebody has edited one by hand.
        self.own_files = OwnFiles()
        #: So that two pages that open the same project at once share it.
        self._opening = asyncio.Lock()

    async def open(self, name: str) -> Session:
        """The project of that name.

        Raises:
            LearnBlockError: there is none, or it cannot be read.
            OSError: likewise.
        """
        name = checked_name(name)
        return await self._opened(name, lambda: self.folder.read(name))

    async def start(self, project: Project) -> Session:
        """A new project, which is saved under a name that is free."""
        async with self._opening:
            project = await to_thread.run_sync(self._written, project)
        return await self._opened(project.name, lambda: project)

    async def delete(self, name: str) -> None:
        """Delete a project that no page shows.

        Raises:
            LearnBlockError: a page shows it, or there is none of that name.
        """
        name = checked_name(name)
        async with self._opening:
            session = self._open.get(name)
            if session and session.pages:
                raise LearnBlockError(f"the project {name} is open: close its pages first")
            if session:
                await self._close(session)
            await to_thread.run_sync(self.folder.delete, name)

    def left(self, session: Session) -> None:
        """A page has left; if it was the last, the project is closed after a while."""
        if not session.pages and session.name not in self._ending:
            self._ending[session.name] = asyncio.create_task(self._end_later(session))

    def tell(self, message: Message) -> None:
        """Tell every page of every project."""
        for session in self._open.values():
            session.tell(message)

    async def renew_blocks(self, own: Session | None) -> None:
        """Other skills are there than before: every program is read with them, every page told.

        Args:
            own: the project whose turn it is; the others take theirs when they can.
        """
        configurations = await to_thread.run_sync(all_configurations)
        if own:
            await own.know(configurations)
        for session in self._open.values():
            if session is not own:
                task = asyncio.create_task(_renew(session, configurations))
                self._renewing.add(task)
                task.add_done_callback(self._renewing.discard)
        self.tell(PaletteChanged())

    async def close(self) -> None:
        """Close them all: their programs end, and they are saved."""
        async with self._opening:
            for task in self._ending.values():
                task.cancel()
            await asyncio.gather(*(session.close() for session in self._open.values()))
            self._open.clear()

    async def _opened(self, name: str, read: Callable[[], Project]) -> Session:
        async with self._opening:
            self._keep_open(name)
            if name not in self._open:
                prepared = await to_thread.run_sync(lambda: prepare(read()))
                session = Session(self.folder, prepared)
                await session.set_the_stage()
                self._open[name] = session
            return self._open[name]

    def _written(self, project: Project) -> Project:
        named = replace(project, name=self.folder.free_name(project.name))
        self.folder.write(named)
        return named

    async def _end_later(self, session: Session) -> None:
        await asyncio.sleep(self._grace)
        async with self._opening:
            del self._ending[session.name]
            if not session.pages:
                await self._close(session)

    async def _close(self, session: Session) -> None:
        self._keep_open(session.name)
        del self._open[session.name]
        await session.close()

    def _keep_open(self, name: str) -> None:
        """It is not to be closed any more."""
        if ending := self._ending.pop(name, None):
            ending.cancel()


async def _renew(session: Session, configurations: Mapping[str, BlockConfiguration]) -> None:
    async with session.turn:
        await session.know(configurations)
