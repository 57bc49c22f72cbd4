"""Saves a project soon after a change."""

import asyncio
from collections.abc import Awaitable, Callable

#: Seconds from the first unsaved change to the save.
DELAY = 0.5


class Saver:
    """Saves something within a second of a change, or at once on request.

    Args:
        write: saves it, and reports errors itself.
        delay: the delay in seconds.
    """

    def __init__(self, write: Callable[[], Awaitable[None]], delay: float = DELAY) -> None:
        self._write = write
        self._delay = delay
        self._waiting: asyncio.Task[None] | None = None
        self._writing = asyncio.Lock()

    def changed(self) -> None:
        """Record a change that is not on disk."""
        if self._waiting is None:
            self._waiting = asyncio.create_task(self._later())

    async def flush(self) -> None:
        """Save unsaved changes at once, and return when they are on disk."""
        waiting, self._waiting = self._waiting, None
        if waiting:
            waiting.cancel()
        async with self._writing:
            if waiting:
                await self._write()

    async def _later(self) -> None:
        await asyncio.sleep(self._delay)
        async with self._writing:
            # This save may miss later changes, so later changes start a new delay.
            self._waiting = None
            await self._write()
