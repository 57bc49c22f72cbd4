"""An open project on disk: the project, its versions and its runs."""

import asyncio
from collections.abc import Callable
from time import monotonic
from typing import Any, TypeVar

from anyio import to_thread

from learnblock.errors import LearnBlockError
from learnblock.i18n import Phrase
from learnblock.server.messages import PastRun
from learnblock.server.messages.problems import phrase_of
from learnblock.server.projects.folder import ProjectFolder
from learnblock.server.projects.history import Reason
from learnblock.server.projects.project_file import Project
from learnblock.server.sessions.saver import Saver

#: Seconds of changes after which a version is saved.
VERSION_PERIOD = 300.0

Value = TypeVar("Value")


class Archive:
    """Saves an open project; a failure is reported, and the project stays usable.

    A save that fails is reported once, and repeated until it succeeds.

    Args:
        folder: the folder of the projects.
        name: the name of the project.
        project: returns the project in its current state.
        saved: called before each save; the function that it returns is called after success.
        failed: called with the error.
    """

    def __init__(
        self,
        folder: ProjectFolder,
        name: str,
        project: Callable[[], Project],
        saved: Callable[[], Callable[[], None]],
        failed: Callable[[Phrase], None],
    ) -> None:
        self._folder = folder
        self._name = name
        self._project = project
        self._saved = saved
        self._failed = failed
        self._saver = Saver(self._write)
        self._is_failing = False
        self._on_disk = folder.state(name)
        self._version_kept = monotonic()
        self._tasks: set[asyncio.Task[Any]] = set()

    def changed(self) -> None:
        """Record that the project has changed since it was saved."""
        self._saver.changed()

    async def keep_version(self, reason: Reason) -> str:
        """Save a version; return its id, or "" if it can't be saved."""
        self._version_kept = monotonic()
        return await self._tried(self._folder.keep_version, self._project(), reason) or ""

    def add_run(self, run: PastRun) -> None:
        """Save the result of a run."""
        task = asyncio.create_task(self._tried(self._folder.add_run, self._name, run))
        self._tasks.add(task)
        task.add_done_callback(self._tasks.discard)

    async def close(self) -> None:
        """Save everything, and return when it is on disk."""
        await self._saver.flush()
        await asyncio.gather(*self._tasks)

    async def _write(self) -> bool:
        saved = self._saved()
        is_changed = await self._tried(self._save, self._project(), quietly=self._is_failing)
        self._is_failing = is_changed is None
        if self._is_failing:
            return False
        if is_changed:
            self._failed(Phrase("project-changed-outside", name=self._name))
        saved()
        if monotonic() - self._version_kept > VERSION_PERIOD:
            await self.keep_version("time")
        return True

    def _save(self, project: Project) -> bool:
        """Save the project; return whether another program had changed its file."""
        found = self._folder.state(self._name)
        is_changed = found not in (None, self._on_disk)
        if is_changed:
            self._folder.keep_file(self._name)
        self._folder.write(project)
        self._on_disk = self._folder.state(self._name)
        return is_changed

    async def _tried(
        self, action: Callable[..., Value], *args: object, quietly: bool = False
    ) -> Value | None:
        """Do something with files in a thread; report a failure unless `quietly`, as None."""
        try:
            return await to_thread.run_sync(action, *args)
        except (LearnBlockError, OSError) as error:
            if not quietly:
                self._failed(phrase_of(error))
            return None
