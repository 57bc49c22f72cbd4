"""The sessions: one for each open project."""

import asyncio
import logging
from collections.abc import Callable, Coroutine, Iterator, Mapping
from concurrent.futures import CancelledError
from contextlib import contextmanager, suppress
from typing import Any

from anyio import to_thread

from learnblock.blocks import BlockConfiguration
from learnblock.blocks.known import all_configurations
from learnblock.errors import LearnBlockError
from learnblock.i18n import Phrase
from learnblock.project.files.folder import ProjectFolder
from learnblock.project.files.project import Project, checked_name, is_same_program
from learnblock.runtime.containment.survey import AttemptResult, survey
from learnblock.server.messages import PaletteChanged, ToPage
from learnblock.server.sessions.connections import RobotConnections
from learnblock.server.sessions.periods import Periods
from learnblock.server.sessions.prepared import prepare
from learnblock.server.sessions.quota import new_projects
from learnblock.server.sessions.session import Session
from learnblock.storage.block_files import BlockFiles

#: The projects of one person whose programs may run at once.
MOST_RUNS = 8
_log = logging.getLogger(__name__)


# Why: docs/decisions.md, "One project is one session"
class Sessions:
    """The sessions, by project name.

    Args:
        folder: the folder of the projects.
        periods: how long an open project waits to be saved, and to be closed.
        for_one: whether all pages belong to one person, who may run some programs at once.
    """

    def __init__(self, folder: ProjectFolder, periods: Periods, *, for_one: bool = False) -> None:
        self.folder = folder
        self.new_projects = new_projects()
        self._for_one = for_one
        self._starting: list[Session] = []
        self._periods = periods
        self._open: dict[str, Session] = {}
        self._ending: dict[str, asyncio.Task[None]] = {}
        self._renewing: set[asyncio.Task[None]] = set()
        #: Notices changes that the user makes by hand.
        self.block_files = BlockFiles()
        self._findings: tuple[AttemptResult, ...] = ()
        self._surveying = asyncio.Lock()
        #: The robots that pages are connected to without a program.
        self.connections = RobotConnections(self._running_robots)
        #: Lets two pages that open the same project at once share it.
        self._opening = asyncio.Lock()

    async def open(self, name: str) -> Session:
        """Open a project.

        Raises:
            LearnBlockError: it does not exist, or can't be read.
            OSError: it can't be read.
        """
        name = checked_name(name)
        return await self._opened(name, lambda: self.folder.read(name))

    async def start(self, project: Project) -> Session:
        """Save a new project under a free name, and open it."""
        async with self._opening:
            project = await to_thread.run_sync(self.folder.add, project)
        return await self._opened(project.name, lambda: project)

    async def rename(self, session: Session, name: str) -> None:
        """Rename an open project; the pages that show it follow.

        Raises:
            LearnBlockError: the name is invalid or taken, or the file can't be renamed.
        """
        name = checked_name(name)
        async with self._opening:
            await self._rename(session, name)

    async def rename_unshown(self, project: str, name: str) -> None:
        """Rename a project that no page shows.

        Raises:
            LearnBlockError: a page shows it, or its file can't be read or renamed.
            OSError: its file can't be read.
        """
        name = checked_name(name)
        session = await self.open(project)
        async with self._opening:
            if session.viewers:
                raise LearnBlockError("project-in-use", name=project)
            try:
                await self._rename(session, name)
            finally:
                self.left(session)

    async def _rename(self, session: Session, name: str) -> None:
        self._keep_open(session.name)
        before = session.name
        await session.rename(name)
        del self._open[before]
        self._open[name] = session

    async def find_unchanged(self, project: Project) -> str | None:
        """The name of a project that was created like this one, and is unchanged."""
        for name in await to_thread.run_sync(self.folder.taken_names, project.name):
            with suppress(LearnBlockError):
                other = await self._project(name)
                if is_same_program(other, project):
                    return name
        return None

    async def _project(self, name: str) -> Project:
        session = self._open.get(name)
        return session.project if session else await to_thread.run_sync(self.folder.read, name)

    async def delete(self, name: str) -> None:
        """Delete a project that no page shows.

        Raises:
            LearnBlockError: a page shows it, or it does not exist.
        """
        name = checked_name(name)
        async with self._opening:
            session = self._open.get(name)
            if session and session.viewers:
                raise LearnBlockError("project-in-use", name=name)
            if session:
                await self._close(session)
            await to_thread.run_sync(self.folder.delete, name)

    def left(self, session: Session) -> None:
        """Record that a page has left; after the last one, the project is closed with a delay."""
        if not session.viewers and session.name not in self._ending:
            self._ending[session.name] = asyncio.create_task(self._end_later(session))

    async def contained(self) -> tuple[AttemptResult, ...]:
        """How programs are contained on this computer, tried out for the first page that asks."""
        async with self._surveying:
            self._findings = self._findings or await to_thread.run_sync(survey)
        return self._findings

    @contextmanager
    def starting(self, session: Session) -> Iterator[None]:
        """Start the programs of a project, or check them.

        Raises:
            LearnBlockError: the programs of too many other projects run.
        """
        if self._for_one and len(self._running(session)) >= MOST_RUNS:
            raise LearnBlockError("server-too-many-runs", most=MOST_RUNS)
        self._starting.append(session)
        try:
            yield
        finally:
            self._starting.remove(session)

    def _running(self, own: Session) -> list[Session]:
        """The other projects with programs that run, are checked, or are about to."""
        return [
            session
            for session in self._open.values()
            if session is not own and (session.is_running or session in self._starting)
        ]

    @property
    def uses_network(self) -> bool:
        """Whether a program is running that may use the network."""
        return any(session.runs.uses_network for session in self._open.values())

    def send(self, message: ToPage) -> None:
        """Send a message to every page of every project."""
        for session in self._open.values():
            session.viewers.send(message)

    def tags_changed(self, before: Mapping[str, int], after: Mapping[str, int]) -> None:
        """Use the user's tag names in every project where the user has just changed them."""
        for session in self._open.values():
            session.tags_changed(before, after)

    async def leave_world(self, own: Session, name: str) -> None:
        """Choose the usual world in every project that is in a world which is to be deleted.

        Args:
            own: the session whose turn it is; it must be able to leave.
            name: the name of the world.

        Raises:
            LearnBlockError: a program is running in it.
        """
        await own.robots.leave_world(name)
        for session in self._open.values():
            if session is not own and session.world == name:
                self._later(_leave_world(session, name))

    async def renew_blocks(self, own: Session | None) -> None:
        """Read every program with changed skills, and notify every page.

        Args:
            own: the session whose turn it is; the others follow when it is their turn.
        """
        configurations = await to_thread.run_sync(all_configurations)
        if own:
            await own.know(configurations)
        for session in self._open.values():
            if session is not own:
                self._later(_renew(session, configurations))
        self.send(PaletteChanged())

    async def close(self) -> None:
        """Close all sessions: end their programs, and save their projects."""
        # At the same time: neither a robot nor a disk that hangs may hold up the other.
        stopping = [session.runs.stop() for session in self._open.values()]
        await asyncio.gather(
            self._save(), self.connections.close(), *stopping, return_exceptions=True
        )
        async with self._opening:
            for task in self._ending.values():
                task.cancel()
            sessions = tuple(self._open.values())
            closing = [session.close() for session in sessions]
            results = await asyncio.gather(*closing, return_exceptions=True)
            for session, failure in zip(sessions, results, strict=True):
                if isinstance(failure, Exception):
                    _log.error("a project was not closed", exc_info=failure)
                    # What kept it from closing, such as a lack of threads, kept it from saving.
                    if problem := session.archive.save_here():
                        _log.error("a project was not saved: %s", problem)
            self._open.clear()

    async def _save(self) -> None:
        saving = [session.archive.settle() for session in self._open.values()]
        await asyncio.gather(*saving, return_exceptions=True)

    def save_from_outside(
        self, loop: asyncio.AbstractEventLoop, seconds: float
    ) -> tuple[Phrase, ...]:
        """Save all projects from another thread, because the event loop may hang.

        Args:
            loop: the event loop, which does it if it still can.
            seconds: how long that may take in all.

        Returns:
            What could not be saved, and why.
        """
        if loop.is_running():
            # Half of the time is left for what the event loop leaves behind.
            with suppress(TimeoutError, CancelledError):
                asyncio.run_coroutine_threadsafe(self._save(), loop).result(seconds / 2)
        return tuple(
            problem
            for session in tuple(self._open.values())
            if (problem := session.archive.save_here())
        )

    async def _opened(self, name: str, read: Callable[[], Project]) -> Session:
        async with self._opening:
            self._keep_open(name)
            if name not in self._open:
                prepared = await to_thread.run_sync(
                    lambda: prepare(read(), read_only=self.folder.read_only)
                )
                session = Session(self.folder, prepared, self._periods)
                await session.robots.set_the_stage()
                await session.resume_lesson()
                await session.resume_link()
                self._open[name] = session
            return self._open[name]

    def _running_robots(self) -> Iterator[str]:
        """The names of the robots on which programs run."""
        for session in self._open.values():
            if session.runs.active:
                yield from session.parts.kinds

    def _later(self, change: Coroutine[Any, Any, None]) -> None:
        task = asyncio.create_task(change)
        self._renewing.add(task)
        task.add_done_callback(self._renewing.discard)

    async def _end_later(self, session: Session) -> None:
        await asyncio.sleep(self._periods.grace)
        async with self._opening:
            del self._ending[session.name]
            if not session.viewers:
                await self._close(session)

    async def _close(self, session: Session) -> None:
        self._keep_open(session.name)
        # Until then, `uses_network` takes its program into account.
        await session.runs.stop()
        del self._open[session.name]
        await session.close()

    def _keep_open(self, name: str) -> None:
        """Cancel closing a project."""
        if ending := self._ending.pop(name, None):
            ending.cancel()


async def _leave_world(session: Session, name: str) -> None:
    async with session.turn:
        # A program that still runs there has loaded its world already.
        with suppress(LearnBlockError):
            await session.robots.leave_world(name)


async def _renew(session: Session, configurations: Mapping[str, BlockConfiguration]) -> None:
    async with session.turn:
        await session.know(configurations)
