"""Tells the pages of a session, some times a second, what has changed in its world."""

import asyncio
from collections.abc import Awaitable, Callable
from time import monotonic
from typing import TYPE_CHECKING, Protocol

from anyio import to_thread

from learnblock.server import messages
from learnblock.server.runs import telemetry
from learnblock.server.runs.console import Console

if TYPE_CHECKING:
    from learnblock.robots.picture import Picture
    from learnblock.robots.stage import Stage
    from learnblock.server.pages.page import Page

#: Seconds between two looks at the world, and between two camera frames.
TELEMETRY_PERIOD = 1 / 20
CAMERA_PERIOD = 1 / 12
#: Seconds for which a world is looked at after something was done to it by hand.
ATTENTION = 1.5


class Reported(Protocol):
    """What is reported of."""

    @property
    def stage(self) -> "Stage | None": ...

    @property
    def active(self) -> bool:
        """Whether a program runs."""

    @property
    def block(self) -> str | None: ...

    @property
    def pages(self) -> "tuple[Page, ...]": ...


class Reporter:
    """Looks at the world while something moves in it, and sleeps while nothing does.

    Args:
        of: the world and who looks at it.
        console: what the program prints.
    """

    def __init__(self, of: Reported, console: Console) -> None:
        self._of = of
        self._console = console
        self._awake = asyncio.Event()
        self._watched = asyncio.Event()
        self._until = 0.0
        self._last: messages.Telemetry | None = None
        self._filmed: Picture | None = None
        self._tasks = (
            asyncio.create_task(_repeat(TELEMETRY_PERIOD, self._awake, self._look)),
            asyncio.create_task(_repeat(CAMERA_PERIOD, self._watched, self._film)),
        )

    def attend(self) -> None:
        """Something happens, or will in a moment."""
        self._until = monotonic() + ATTENTION
        self._awake.set()

    def watch(self) -> None:
        """A page has begun to watch the camera, or does so no more."""
        self._filmed = None
        watched = any(page.watching for page in self._of.pages)
        (self._watched.set if watched else self._watched.clear)()

    def greet(self) -> None:
        """Tell the world as it is, also where nothing moves: somebody has just come to see it."""
        self._last = None
        self.attend()

    def flush(self) -> None:
        """Tell what was printed so far."""
        if text := self._console.take():
            for page in self._of.pages:
                page.tell(messages.Printed(text))

    def close(self) -> None:
        """Look no more."""
        for task in self._tasks:
            task.cancel()

    async def _look(self) -> None:
        self.flush()
        stage = self._of.stage
        if stage and self._of.pages:
            await self._tell_world(stage)
        if not self._of.active and monotonic() > self._until:
            self._awake.clear()

    async def _tell_world(self, stage: "Stage") -> None:
        now = await to_thread.run_sync(telemetry.telemetry, stage, self._of.block)
        heard = telemetry.sounds(stage)
        changed, self._last = now != self._last, now
        for page in self._of.pages:
            if changed:
                page.tell(now)
            for sound in heard:
                page.tell(sound)

    async def _film(self) -> None:
        stage = self._of.stage
        watching = [page for page in self._of.pages if page.watching]
        if stage is None or not watching:
            self._watched.clear()
            return
        picture = await to_thread.run_sync(stage.camera)
        # The same object: nothing has moved since.
        if picture and picture is not self._filmed:
            self._filmed = picture
            for page in watching:
                page.tell(telemetry.camera_frame(picture), picture.jpeg)


async def _repeat(
    period: float, wanted: asyncio.Event, action: Callable[[], Awaitable[None]]
) -> None:
    """Do something every so many seconds while it is wanted."""
    loop = asyncio.get_running_loop()
    while True:
        await wanted.wait()
        began = loop.time()
        await action()
        await asyncio.sleep(max(0.0, began + period - loop.time()))
