"""An open project on disk: itself, its versions and its runs."""

import asyncio
from collections.abc import Callable
from time import monotonic
from typing import Any, TypeVar

from anyio import to_thread

from learnblock.errors import LearnBlockError
from learnblock.server.messages import PastRun
from learnblock.server.pages.sentences import sentence
from learnblock.server.projects.folder import ProjectFolder
from learnblock.server.projects.history import Reason
from learnblock.server.projects.project_file import Project
from learnblock.server.sessions.saver import Saver

#: Seconds of changes after which a version is kept.
VERSION_PERIOD = 300.0

Value = TypeVar("Value")


class Archive:
    """Keeps an open project; what cannot be kept is told, and keeps nobody from going on.

    Args:
        folder: where.
        project: the project as it is now.
        saved: is called before each writing; what it returns is called when that has succeeded.
        failed: is told what went wrong.
    """

    def __init__(
        self,
        folder: ProjectFolder,
        project: Callable[[], Project],
        saved: Callable[[], Callable[[], None]],
        failed: Callable[[str], None],
    ) -> None:
        self._folder = folder
        self._project = project
        self._saved = saved
        self._failed = failed
        self._saver = Saver(self._write)
        self._version_kept = monotonic()
        self._tasks: set[asyncio.Task[Any]] = set()

    def changed(self) -> None:
        """The project is not as it was saved."""
        self._saver.changed()

    async def keep_version(self, reason: Reason) -> str:
        """Keep the project as it is; answer the version's id, "" if that cannot be."""
        self._version_kept = monotonic()
        return await self._tried(self._folder.keep_version, self._project(), reason) or ""

    def add_run(self, run: PastRun) -> None:
        """Keep how a run went."""
        task = asyncio.create_task(self._tried(self._folder.add_run, self._project().name, run))
        self._tasks.add(task)
        task.add_done_callback(self._tasks.discard)

    async def close(self) -> None:
        """Return when everything is on disk."""
        await self._saver.flush()
        await asyncio.gather(*self._tasks)

    async def _write(self) -> None:
        saved = self._saved()
        if await self._tried(self._written, self._project()):
            saved()
        if monotonic() - self._version_kept > VERSION_PERIOD:
            await self.keep_version("time")

    def _written(self, project: Project) -> bool:
        self._folder.write(project)
        return True

    async def _tried(self, action: Callable[..., Value], *args: object) -> Value | None:
        try:
            return await to_thread.run_sync(action, *args)
        except (LearnBlockError, OSError) as error:
            self._failed(sentence(error))
            return None
