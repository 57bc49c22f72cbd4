"""The runs that the teacher sees beside hand-ins, on a server of the teacher's own.

It has the limits of a pupil's server. Its folder is deleted some time after the last look.
"""

import asyncio
import shutil
from collections.abc import AsyncIterator, Awaitable, Callable, Iterable
from contextlib import asynccontextmanager
from pathlib import Path
from typing import Protocol

from learnblock.classroom.hand_in_messages import HandInRun
from learnblock.classroom.hand_ins import HandInFile
from learnblock.classroom.servers import PupilServers, ServerAddress
from learnblock.lessons.reading import named_lesson
from learnblock.server import messages

#: The folder in that of the class.
FOLDER = "hand-in-runs"
#: Names the server among those of pupils, whose ids are longer.
_SERVER = "hand-ins"
#: The path of its page, as `Servers` has it.
PATH = f"/p/{_SERVER}/"
#: The name of the projects with the programs.
_PROJECT = "Hand-in"
#: Seconds after which the server is stopped that no page uses.
_GRACE = 120.0


class RunPage(Protocol):
    """A page that shows a run."""

    async def restart(self) -> None:
        """Close its connection; it connects again."""


Give = Callable[[str, Iterable[Path]], Awaitable[None]]


class HandInRuns:
    """The server on which what was handed in runs; one for the class.

    Args:
        folder: of the class.
        servers: start it.
        give: puts a lesson into folders if it is one of the teacher's own.
        grace: seconds after which it is stopped when no page uses it.
    """

    def __init__(
        self, folder: Path, servers: PupilServers, give: Give, *, grace: float = _GRACE
    ) -> None:
        self.folder = folder / FOLDER
        self._servers = servers
        self._give = give
        self._grace = grace
        self._uses = 0
        self._pages: set[RunPage] = set()
        self._lock = asyncio.Lock()
        self._ending: asyncio.Task[None] | None = None

    @asynccontextmanager
    async def page(self, page: RunPage, lesson: str) -> AsyncIterator[ServerAddress]:
        """Use the server for a page that shows a run in a lesson.

        Raises:
            LearnBlockError: the lesson can't be read, or the server does not start.
            OSError: it can't be given the lesson.
        """
        async with self.used() as place:
            await self._give(lesson, [self.folder])
            self._pages.add(page)
            try:
                yield place
            finally:
                self._pages.discard(page)

    @asynccontextmanager
    async def used(self) -> AsyncIterator[ServerAddress]:
        """Use the server.

        Raises:
            LearnBlockError: it does not start.
        """
        if self._ending:
            self._ending.cancel()
        self._uses += 1
        try:
            async with self._lock:
                place = await self._servers.place(_SERVER, self.folder)
            yield place
        finally:
            self._uses -= 1
            if not self._uses:
                self._ending = asyncio.create_task(self._end_later())

    async def forget(self) -> None:
        """Stop the server, and delete what it has made; its pages connect again.

        Raises:
            OSError: some of it can't be deleted.
        """
        async with self._lock:
            for page in list(self._pages):
                await page.restart()
            await self._servers.stop(_SERVER)
            await asyncio.to_thread(self.delete)

    async def close(self) -> None:
        """End with the class, whose servers have ended.

        Raises:
            OSError: some files can't be deleted.
        """
        if self._ending:
            self._ending.cancel()
        await asyncio.to_thread(self.delete)

    def delete(self) -> None:
        """Delete what the server has made; it must have ended.

        Raises:
            OSError: some of it can't be deleted.
        """
        if self.folder.exists():
            shutil.rmtree(self.folder)

    async def _end_later(self) -> None:
        await asyncio.sleep(self._grace)
        await self.forget()


def wanted_run(file: HandInFile) -> HandInRun:
    """What to run of a hand-in: in the world of the run that the list speaks of.

    Raises:
        LearnBlockError: the lesson or the step is gone.
    """
    work, checked = file.work, file.checked
    [usual, *_] = named_lesson(work.lesson).robots(work.step)
    robot = checked.robot if checked else ""
    variant = checked.variant if checked else 0
    return HandInRun(work.lesson, work.step, work.program, robot or usual, variant)


async def beginning(run: HandInRun) -> Iterable[messages.Message]:
    """What the server gets first, before the page sends it the program."""
    tags = [messages.SaveTags(dict(run.program.tags))] if run.program.tags else []
    # The program of another hand-in may still run.
    stop = messages.Stop()
    return [messages.StartLesson(run.lesson, _PROJECT), stop, messages.ShowStep(run.step), *tags]
