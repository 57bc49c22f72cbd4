"""When a project is written: soon after it has changed."""

import asyncio
from collections.abc import Awaitable, Callable

#: Seconds from the first change that is not on disk to the writing of all.
DELAY = 0.5


class Saver:
    """Has something written within a second of its change, and at once when asked.

    Args:
        write: writes it; tells of errors itself.
        delay: seconds.
    """

    def __init__(self, write: Callable[[], Awaitable[None]], delay: float = DELAY) -> None:
        self._write = write
        self._delay = delay
        self._waiting: asyncio.Task[None] | None = None
        self._writing = asyncio.Lock()

    def changed(self) -> None:
        """Something is not on disk."""
        if self._waiting is None:
            self._waiting = asyncio.create_task(self._later())

    async def flush(self) -> None:
        """Write at once what is not on disk, and return when it is."""
        waiting, self._waiting = self._waiting, None
        if waiting:
            waiting.cancel()
        async with self._writing:
            if waiting:
                await self._write()

    async def _later(self) -> None:
        await asyncio.sleep(self._delay)
        async with self._writing:
            # From here on a change is a new one, which this writing may miss.
            self._waiting = None
            await self._write()
