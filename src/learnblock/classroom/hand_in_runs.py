"""The runs of hand-ins, on servers apart from pupils' work: the teacher's, and a pupil's own.

Each has the limits of a pupil's server. Its folder is deleted some time after the last look.
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
#: The names of servers among those of pupils, whose ids have no such form.
_TEACHERS, _PUPILS = "hand-ins", "hand-in-{}"
#: The paths of their pages, as `Servers` has them.
TEACHERS_PATH, PUPILS_PATH = f"/p/{_TEACHERS}/", f"/p/{_PUPILS.format('{owner}')}/"
#: The name of the projects with the programs.
_PROJECT = "Hand-in"
#: Seconds after which a server is stopped that no page uses: the teacher looks at one hand-in after
#: the other, and pupils are many.
_GRACE, _PUPILS_GRACE = 120.0, 20.0


class RunPage(Protocol):
    """A page that shows a run."""

    async def restart(self) -> None:
        """Close its connection; it connects again."""


Give = Callable[[str, Iterable[Path]], Awaitable[None]]


class HandInRuns:
    """The servers on which what was handed in runs.

    Args:
        folder: of the class.
        servers: start them.
        give: puts a lesson into folders if it is one of the teacher's own.
    """

    def __init__(self, folder: Path, servers: PupilServers, give: Give) -> None:
        self.folder = folder / FOLDER
        self._servers = servers
        self._give = give
        self.teachers = self._server(_TEACHERS, _GRACE)
        self._pupils: dict[str, RunServer] = {}

    def of_pupil(self, pupil: str) -> "RunServer":
        """The server on which a pupil sees what the pupil has handed in."""
        if pupil not in self._pupils:
            self._pupils[pupil] = self._server(_PUPILS.format(pupil), _PUPILS_GRACE)
        return self._pupils[pupil]

    def _server(self, name: str, grace: float) -> "RunServer":
        return RunServer(name, self.folder / name, self._servers, self._give, grace)

    async def forget(self, pupil: str) -> None:
        """Delete what has run of a pupil; the pages that show runs connect again.

        Raises:
            OSError: some of it can't be deleted.
        """
        await self.teachers.forget()
        if server := self._pupils.pop(pupil, None):
            await server.forget()

    async def close(self) -> None:
        """End with the class, whose servers have ended.

        Raises:
            OSError: some files can't be deleted.
        """
        for server in (self.teachers, *self._pupils.values()):
            server.end()
        await asyncio.to_thread(self.delete)

    def delete(self) -> None:
        """Delete what the servers have made; they must have ended.

        Raises:
            OSError: some of it can't be deleted.
        """
        _delete(self.folder)


class RunServer:
    """A server on which what was handed in runs.

    Args:
        name: among those of pupils.
        folder: its folder.
        servers: start it.
        give: puts a lesson into folders if it is one of the teacher's own.
        grace: seconds after which it is stopped when no page uses it.
    """

    def __init__(
        self, name: str, folder: Path, servers: PupilServers, give: Give, grace: float
    ) -> None:
        self.folder = folder
        self._name = name
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
                place = await self._servers.place(self._name, self.folder)
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
            await self._servers.stop(self._name)
            await asyncio.to_thread(_delete, self.folder)

    def end(self) -> None:
        """End with the class, whose servers end anyway."""
        if self._ending:
            self._ending.cancel()

    async def _end_later(self) -> None:
        await asyncio.sleep(self._grace)
        await self.forget()


def _delete(folder: Path) -> None:
    if folder.exists():
        shutil.rmtree(folder)


def wanted_run(file: HandInFile, *, is_teacher: bool) -> HandInRun:
    """The program of a hand-in, with the robot and the variant of the run that its reader sees.

    Raises:
        LearnBlockError: the lesson or the step is gone.
    """
    work = file.work
    last = file.back[-1] if file.back else None
    # A pupil sees nothing of a check before it is handed back.
    checked = file.checked if is_teacher else last and last.checked
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
