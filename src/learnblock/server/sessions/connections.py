"""The pages' connections to real robots, each of which has one user at a time."""

import asyncio
from collections import Counter
from collections.abc import AsyncIterator, Callable, Collection, Iterable, Mapping
from contextlib import asynccontextmanager
from typing import Any

from learnblock.errors import LearnBlockError
from learnblock.robots import RobotEntry
from learnblock.server.runs.connected import Connected
from learnblock.server.runs.nearby import Nearby
from learnblock.server.runs.viewers import Viewer

#: Seconds for a robot to disconnect. One that is still being connected takes as long as its driver
#: tries, which is too long at the end of the server.
_PATIENCE, _LAST_PATIENCE = 20.0, 3.0


class RobotConnections:
    """The robots that pages are connected to without a program.

    Args:
        running: returns the names of the robots on which programs run.
        patience: seconds for a robot to disconnect; then its driver is left behind.
        last_patience: the same at the end of the server.
    """

    def __init__(
        self,
        running: Callable[[], Iterable[str]],
        patience: float = _PATIENCE,
        last_patience: float = _LAST_PATIENCE,
    ) -> None:
        self._running = running
        self._patience = patience
        self._last_patience = last_patience
        self._held: dict[Viewer, Connected] = {}
        #: How many are about to use a robot.
        self._reserved: Counter[str] = Counter()
        self.nearby = Nearby(self.is_busy)

    def is_busy(self, robot: str) -> bool:
        """Whether a page or a program uses a robot, or is about to."""
        return (
            self._holder(robot) is not None or self._reserved[robot] > 0 or robot in self._running()
        )

    def of(self, page: Viewer) -> Connected:
        """The connection of a page.

        Raises:
            LearnBlockError: it has none.
        """
        if page not in self._held:
            raise LearnBlockError("connect-not-connected")
        return self._held[page]

    async def connect(
        self,
        page: Viewer,
        id: str,  # noqa: A002 - as in the message
        robot: RobotEntry,
        chosen: Mapping[str, Any],
    ) -> None:
        """Connect a page to a robot, replacing its previous one.

        Raises:
            LearnBlockError: it is already in use.
        """
        await self.disconnect(page)
        async with self.reserved(page, (robot.name,)):
            if robot.name in self._running():
                raise LearnBlockError("connect-used-by-run")
            connected = Connected(page, id, robot, chosen, self._ended)
            self._held[page] = connected
            connected.start()
        self.nearby.show()

    async def disconnect(self, page: Viewer) -> None:
        """Disconnect a page from its robot; return once the motors have stopped."""
        if connected := self._held.get(page):
            await connected.close(self._patience)

    def begin_to_disconnect(self, page: Viewer) -> None:
        """Disconnect a page from its robot, which `RobotConnected` reports."""
        if connected := self._held.get(page):
            connected.begin_to_close()

    @asynccontextmanager
    async def reserved(self, page: Viewer, robots: Collection[str]) -> AsyncIterator[None]:
        """Keep robots free for a page while it begins to use them.

        Its own connection ends. A connection that is ending is awaited, and so is a look at them:
        a Cozmo drops its connection when another program greets it.

        Raises:
            LearnBlockError: another page is connected to one of them.
        """
        self._reserved.update(robots)
        try:
            for robot in robots:
                await self._free(page, robot)
            yield
        finally:
            self._reserved.subtract(robots)

    async def _free(self, page: Viewer, robot: str) -> None:
        holder = self._holder(robot)
        if holder and holder.page is not page and not holder.closing:
            raise LearnBlockError("connect-used-by-page")
        if holder:
            await holder.close(self._patience)
        await self.nearby.finish_looking(robot)

    def left(self, page: Viewer) -> None:
        """Record that a page is gone: its robot stops."""
        self.nearby.leave(page)
        self.begin_to_disconnect(page)

    async def close(self) -> None:
        """Disconnect from every robot, and stop installing what one needs."""
        self.nearby.close()
        await self.nearby.installer.stop()
        held = tuple(self._held.values())
        await asyncio.gather(*(connected.close(self._last_patience) for connected in held))

    def _holder(self, robot: str) -> Connected | None:
        return next(
            (connected for connected in self._held.values() if connected.robot.name == robot), None
        )

    def _ended(self, connected: Connected) -> None:
        if self._held.get(connected.page) is connected:
            del self._held[connected.page]
            self.nearby.show()
