"""Saves a project soon after a change."""

import asyncio
from collections.abc import Awaitable, Callable
from contextlib import AbstractAsyncContextManager

#: Seconds from the first unsaved change to the save.
DELAY = 0.5
#: Seconds from a save that failed to the next attempt.
RETRY = 2.0


class Saver:
    """Saves something within a second of a change, or at once on request.

    A save that fails is repeated until it succeeds.

    Args:
        write: saves it; returns whether that succeeded, and reports errors itself.
        delay: seconds from a change to the save.
        retry: seconds from a failed save to the next.
    """

    def __init__(
        self, write: Callable[[], Awaitable[bool]], delay: float = DELAY, retry: float = RETRY
    ) -> None:
        self._write = write
        self._delay = delay
        self._retry = retry
        self._unsaved = False
        self._waiting: asyncio.Task[None] | None = None
        self._writing = asyncio.Lock()

    def changed(self) -> None:
        """Record a change that is not on disk."""
        self._unsaved = True
        self._save_in(self._delay)

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
            self._save_in(self._retry)

    async def _save(self) -> None:
        if self._unsaved:
            self._unsaved = False
            if not await self._write():
                self._unsaved = True
