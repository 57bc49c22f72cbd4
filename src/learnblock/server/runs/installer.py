"""Installs what robots need besides LearnBlock, while the page goes on."""

import asyncio
import importlib
import re
from asyncio.subprocess import DEVNULL, PIPE, STDOUT, Process
from collections.abc import Awaitable, Callable, Sequence
from contextlib import suppress

from msgspec import structs

from learnblock.errors import LearnBlockError
from learnblock.i18n import Phrase
from learnblock.server import messages

#: Seconds for one add-on: the largest is 100 MB, on the network of a school.
_LONGEST = 900.0
#: Seconds in which an installer ends that is asked to.
_ENDING = 5.0
#: Characters of what an installer says that are kept, and shown.
_KEPT, _SHOWN = 4000, 120
#: What pip and uv say if they reach no package index.
_OFFLINE = re.compile(
    r"name resolution|dns error|NewConnectionError|ConnectTimeout|error trying to connect"
    r"|tcp connect error|connection refused|network is unreachable|No route to host",
    re.IGNORECASE,
)
#: Colours and cursor movements of a terminal.
_CONTROL = re.compile(r"\x1b\[[0-9;?]*[A-Za-z]")


class Installer:
    """Installs the add-on of one robot at a time.

    Args:
        changed: called when there is something new to show.
        refresh: reads again which robots lack an add-on.
        command: returns the words of the command that installs an extra.
    """

    def __init__(
        self,
        changed: Callable[[], object],
        refresh: Callable[[], Awaitable[object]],
        command: Callable[[str], Sequence[str]],
    ) -> None:
        self._changed = changed
        self._refresh = refresh
        self._command = command
        self._task: asyncio.Task[None] | None = None
        self._robot = ""
        self._said = ""
        self._problems: dict[str, Phrase] = {}

    def begin(self, robot: str) -> None:
        """Begin to install what a robot needs.

        Raises:
            LearnBlockError: another add-on is being installed.
        """
        if self._robot:
            raise LearnBlockError("connect-installs-another", robot=self._robot)
        self._robot, self._said = robot, ""
        self._problems.pop(robot, None)
        self._task = asyncio.create_task(self._run(robot))
        self._task.add_done_callback(self._ended)
        self._changed()

    async def stop(self) -> None:
        """Stop installing; what is installed already stays."""
        if self._task:
            self._task.cancel()
            await asyncio.wait([self._task])

    def shown(self, robot: str, add_on: messages.AddOn) -> messages.AddOn:
        """The add-on that a robot lacks, with what becomes of it."""
        if robot != self._robot:
            return structs.replace(add_on, problem=self._problems.get(robot))
        return structs.replace(add_on, installing=True, progress=self._last_line[:_SHOWN])

    @property
    def _last_line(self) -> str:
        lines = (line.strip() for line in reversed(self._said.splitlines()))
        return next(filter(None, lines), "")

    async def _run(self, robot: str) -> None:
        try:
            async with asyncio.timeout(_LONGEST):
                await self._install(self._command(robot))
            # New modules are found from now on; it is shown only if they are not.
            importlib.invalidate_caches()
            self._problems[robot] = Phrase("connect-installed-restart")
            await self._refresh()
        except LearnBlockError as error:
            self._problems[robot] = error.phrase
        except TimeoutError:
            self._problems[robot] = Phrase("connect-install-too-long", minutes=_LONGEST / 60)

    def _ended(self, _: "asyncio.Task[None]") -> None:
        self._robot = ""
        self._changed()

    async def _install(self, command: Sequence[str]) -> None:
        try:
            process = await asyncio.create_subprocess_exec(
                *command, stdin=DEVNULL, stdout=PIPE, stderr=STDOUT
            )
        except OSError as error:
            raise LearnBlockError("connect-no-installer", name=command[0]) from error
        try:
            await self._listen(process)
            if await process.wait():
                raise self._failure()
        finally:
            await _end(process)

    async def _listen(self, process: Process) -> None:
        assert process.stdout is not None  # noqa: S101 - it is a pipe
        while received := await process.stdout.read(_KEPT):
            text = _CONTROL.sub("", received.decode("utf-8", "replace")).replace("\r", "\n")
            self._said = (self._said + text)[-_KEPT:]
            self._changed()

    def _failure(self) -> LearnBlockError:
        if _OFFLINE.search(self._said):
            return LearnBlockError("connect-install-offline")
        return LearnBlockError("connect-install-failed", reason=self._last_line)


async def _end(process: Process) -> None:
    """End an installer that has not ended, by force if it must be."""
    if process.returncode is not None:
        return
    with suppress(ProcessLookupError):
        process.terminate()
        try:
            async with asyncio.timeout(_ENDING):
                await process.wait()
        except TimeoutError:
            process.kill()
            await process.wait()
