"""An open project on disk: the project, its versions and its runs."""

import asyncio
from collections.abc import Awaitable, Callable, Coroutine, Sequence
from contextlib import AbstractAsyncContextManager
from functools import partial
from time import monotonic
from typing import Any, Protocol, TypeVar

from anyio import to_thread

from learnblock.errors import LearnBlockError, phrase_of, shortage
from learnblock.i18n import Phrase
from learnblock.project.files.folder import FileChangedError, FileState, ProjectFolder
from learnblock.project.files.history import PastRun, Reason
from learnblock.project.files.kept_runs import KeptRun
from learnblock.project.files.project import Project
from learnblock.runtime.log.blocks import EventBlock
from learnblock.server.sessions.periods import Periods

#: Seconds of changes after which a version is saved.
VERSION_PERIOD = 300.0

Value = TypeVar("Value")


class Saver:
    """Saves something within a second of a change, or at once on request.

    A save that fails is repeated until it succeeds.

    Args:
        write: saves it; returns whether that succeeded, and reports errors itself.
        periods: when it saves.
    """

    def __init__(self, write: Callable[[], Awaitable[bool]], periods: Periods) -> None:
        self._write = write
        self._periods = periods
        self._unsaved = False
        self._waiting: asyncio.Task[None] | None = None
        self._writing = asyncio.Lock()

    @property
    def is_saved(self) -> bool:
        """Whether everything is on disk."""
        return not self._unsaved and not self._writing.locked()

    def changed(self) -> None:
        """Record a change that is not on disk."""
        self._unsaved = True
        self._save_in(self._periods.save)

    def still(self) -> AbstractAsyncContextManager[None]:
        """A context in which nothing is saved."""
        return self._writing

    async def flush(self) -> None:
        """Try at once to save unsaved changes, and return when they are on disk."""
        if self._waiting:
            self._waiting.cancel()
            self._waiting = None
        async with self._writing:
            await self._save()

    def _save_in(self, seconds: float) -> None:
        if self._waiting is None:
            self._waiting = asyncio.create_task(self._later(seconds))

    async def _later(self, seconds: float) -> None:
        await asyncio.sleep(seconds)
        async with self._writing:
            # This save may miss later changes, so later changes start a new delay.
            self._waiting = None
            await self._save()
        if self._unsaved:
            self._save_in(self._periods.retry)

    async def _save(self) -> None:
        if not self._unsaved:
            return
        self._unsaved = False
        try:
            is_saved = await self._write()
        except Exception as error:
            # Without memory or threads not even the attempt is possible; the next one may be.
            self._unsaved = True
            if not shortage(error):
                raise
        else:
            self._unsaved |= not is_saved


class ArchivedProject(Protocol):
    """An open project, as far as it is saved."""

    #: Its name, and that of its file.
    name: str

    @property
    def project(self) -> Project:
        """The project in the form that is saved."""

    def saving(self) -> tuple[Project, Callable[[], None]]:
        """Return the project, and what confirms the last edit of each page once it is saved."""

    async def take_in(self, outside: Project) -> bool:
        """Merge the project as another program has saved it; return whether it lacks a change."""

    def kept_outside(self, version: str) -> None:
        """Tell every page which version has another program's change that could not be merged."""

    def runs_kept(self, runs: tuple[KeptRun, ...]) -> None:
        """Tell every page which runs are kept."""

    def failed(self, message: Phrase) -> None:
        """Tell every page what went wrong."""


class Archive:
    """Saves an open project; a failure is reported, and the project stays usable.

    A save that fails is reported once, and repeated until it succeeds. What another program changes
    in the file is merged into the project. In a folder that is only read, the project follows the
    file, and nothing is saved.

    Args:
        folder: the folder of the projects.
        project: the project.
        periods: when it is saved, and its file looked at.
    """

    def __init__(self, folder: ProjectFolder, project: ArchivedProject, periods: Periods) -> None:
        self._folder = folder
        self._project = project
        self._periods = periods
        self._saver = Saver(self._write, periods)
        self._is_failing = False
        self._on_disk = folder.state(project.name)
        self._version_kept = monotonic()
        self._tasks: set[asyncio.Task[Any]] = set()
        self._watching = asyncio.create_task(self._watch())

    def changed(self) -> None:
        """Record that the project has changed since it was saved."""
        if not self._folder.read_only:
            self._saver.changed()

    async def keep_version(self, reason: Reason, project: Project | None = None) -> str:
        """Save a version; return its id, or "" if it can't be saved.

        Args:
            reason: why.
            project: what to save; the current project by default.
        """
        if self._folder.read_only:
            return ""
        if project is None:
            project = self._project.project
            self._version_kept = monotonic()
        return await self._tried(self._folder.keep_version, project, reason) or ""

    def add_run(self, run: PastRun) -> None:
        """Save the result of a run."""
        if not self._folder.read_only:
            self._later(self._tried(self._folder.add_run, self._project.name, run))

    def keep_logs(self, began: float, version: str, logs: Sequence[tuple[EventBlock, ...]]) -> None:
        """Keep the logs of a run's programs, and report it.

        Args:
            began: when the run began, in seconds since 1970.
            version: the version of the project that ran.
            logs: that of each program.
        """
        if logs and not self._folder.read_only:
            self._later(self._keep_logs(began, version, logs))

    async def _keep_logs(
        self, began: float, version: str, logs: Sequence[tuple[EventBlock, ...]]
    ) -> None:
        kept_runs = self._folder.kept_runs(self._project.name)
        for blocks in logs:
            await self._tried(partial(kept_runs.add, began, blocks, version=version))
        if (runs := await self._tried(kept_runs.runs)) is not None:
            self._project.runs_kept(runs)

    def _later(self, saving: Coroutine[Any, Any, object]) -> None:
        task = asyncio.create_task(saving)
        self._tasks.add(task)
        task.add_done_callback(self._tasks.discard)

    async def flush(self) -> None:
        """Save what has changed, and return when it is on disk."""
        await self._saver.flush()

    async def rename(self, name: str) -> None:
        """Rename the project, its file and its history.

        Raises:
            LearnBlockError: the name is taken, or the file can't be renamed.
        """
        await self.settle()
        async with self._saver.still():
            await to_thread.run_sync(self._folder.rename, self._project.name, name)
            self._project.name = name
            self._on_disk = self._folder.state(name)

    async def close(self) -> None:
        """Save everything, and return when it is on disk."""
        self._watching.cancel()
        await self.settle()
        # There may no longer be a thread for it.
        self.save_here()

    async def settle(self) -> None:
        """Save what has changed and what is still to be kept of runs."""
        await self.flush()
        await asyncio.gather(*self._tasks)

    def save_here(self) -> Phrase | None:
        """Save what has changed in this thread, because the event loop can't.

        Returns:
            Why that was not possible; None if everything is saved.
        """
        if self._folder.read_only or self._saver.is_saved:
            return None
        try:
            project, _ = self._project.saving()
            try:
                self._folder.write_whole(project, self._on_disk)
            except FileChangedError:
                # Nothing can be merged now, but both are kept.
                self._folder.keep_version(project, "conflict")
        except Exception as error:  # noqa: BLE001 - the event loop may be in the middle of a change
            return phrase_of(error)
        return None

    async def _watch(self) -> None:
        """Save soon after another program has changed the file; saving first merges that change."""
        while True:
            await asyncio.sleep(self._periods.watch)
            if not await to_thread.run_sync(self._found_outside):
                continue
            if self._folder.read_only:
                await self._follow()
            else:
                self._saver.changed()

    async def _follow(self) -> None:
        """Show what the server that writes has saved."""
        await self._take_in()
        _, saved = self._project.saving()
        saved()

    async def _write(self) -> bool:
        await self._take_in()
        project, saved = self._project.saving()
        try:
            state = await self._tried(
                self._folder.write_whole, project, self._on_disk, quietly=self._is_failing
            )
        except FileChangedError:
            # Another program was faster, so take that in first.
            return await self._write()
        self._is_failing = state is None
        if state is None:
            return False
        self._on_disk = state
        saved()
        if monotonic() - self._version_kept > VERSION_PERIOD:
            await self.keep_version("time")
        return True

    async def _take_in(self) -> None:
        """Merge what another program has changed in the file."""
        state = await to_thread.run_sync(self._found_outside)
        if state is None:
            return
        outside = await self._tried(self._folder.read, self._project.name)
        self._on_disk = state
        is_lost = outside is None or await self._project.take_in(outside)
        if is_lost and not self._folder.read_only:
            version = await self._tried(self._folder.keep_file, self._project.name)
            self._project.kept_outside(version or "")

    def _found_outside(self) -> FileState | None:
        """The state of the file if another program has changed it."""
        state = self._folder.state(self._project.name)
        return None if state == self._on_disk else state

    async def _tried(
        self, action: Callable[..., Value], *args: object, quietly: bool = False
    ) -> Value | None:
        """Access files in a thread; on failure, report it unless `quietly`, and return None."""
        try:
            return await to_thread.run_sync(action, *args)
        except Exception as error:
            if not isinstance(error, LearnBlockError | OSError) and not shortage(error):
                raise
            if not quietly:
                self._project.failed(phrase_of(error))
            return None
