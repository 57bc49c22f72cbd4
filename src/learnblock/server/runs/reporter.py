"""Reports changes in the world to the pages of a session, several times a second."""

import asyncio
import math
from collections.abc import Awaitable, Callable, Iterator, Sequence
from time import monotonic
from typing import TYPE_CHECKING, Protocol, TypeVar

from anyio import CapacityLimiter, to_thread

from learnblock.runtime.recorder import Collision
from learnblock.server import messages
from learnblock.server.runs import telemetry
from learnblock.server.runs.console import Console, message_of
from learnblock.server.runs.telemetry import Drawn
from learnblock.server.runs.viewers import Viewers
from learnblock.why.wording import thing_phrase

if TYPE_CHECKING:
    from learnblock.monitor import Monitor
    from learnblock.monitor.monitor import Picture

Found = TypeVar("Found")
#: Seconds between two reports of the world, and between two camera frames.
TELEMETRY_PERIOD = 1 / 20
CAMERA_PERIOD = 1 / 12
#: Seconds for which a world is watched after the user moved something in it.
ATTENTION = 1.5
#: Seconds of the robot's time without a touch after which a thing counts as bumped into again.
APART = 1.0


class ReportedRobot(Protocol):
    """A robot in its world, the program that it runs, and the pages that show them."""

    @property
    def viewers(self) -> Viewers:
        """The pages that show the robot."""

    @property
    def readers(self) -> Viewers:
        """The pages that show the console."""

    @property
    def monitor(self) -> "Monitor | None":
        """The monitor of the robot; None if there is no robot."""

    @property
    def active(self) -> bool:
        """Whether its program runs."""

    @property
    def running_line(self) -> messages.RunningLine:
        """The line that its program has come to."""

    @property
    def collisions(self) -> Sequence[Collision]:
        """What it has bumped into in this run, or the last one."""

    def check(self) -> None:
        """Notice a run that was lost."""


class Reporter:
    """Watches the world while something moves in it, and sleeps otherwise.

    Args:
        robot: the robot in its world, its program and its pages.
        console: the output of the program, which other robots may run too.
    """

    def __init__(self, robot: ReportedRobot, console: Console) -> None:
        self._robot = robot
        self._console = console
        self._awake = asyncio.Event()
        self._watched = asyncio.Event()
        self._until = 0.0
        #: The last message of each type; equal ones are not sent again.
        self._last: dict[type[messages.ToPage], messages.ToPage] = {}
        self._filmed: Picture | None = None
        self._drawn = Drawn()
        self._bumps = Bumps()
        self._start()

    def begin(self) -> None:
        """Follow a run from its start."""
        self._bumps = Bumps()
        self.attend()

    def attend(self) -> None:
        """Watch the world, because something moves in it or is about to."""
        self._until = monotonic() + ATTENTION
        self._awake.set()

    def watch(self) -> None:
        """Send camera frames, or stop, after a page has started or stopped watching."""
        self._filmed = None
        watched = any(page.watching for page in self._robot.viewers)
        (self._watched.set if watched else self._watched.clear)()

    def greet(self) -> None:
        """Report the world once more, even if nothing moves, for a page that has just opened it."""
        self._last.clear()
        self._drawn.forget()
        self.attend()

    def flush(self) -> None:
        """Send the output so far, and what the robot has bumped into."""
        if printed := message_of(self._console.take()):
            self._robot.readers.send(printed)
        for bump in self._bumps.news(self._robot.collisions):
            self._robot.viewers.send(bump)

    def start_again(self) -> None:
        """Leave behind a look at a robot that may hang, because its run was given up."""
        self.close()
        self._start()

    def _start(self) -> None:
        # A separate limiter, so that a look that hangs takes no thread from other work.
        self._limiter = CapacityLimiter(2)
        self._tasks = (
            asyncio.create_task(_repeat(TELEMETRY_PERIOD, self._awake, self._look)),
            asyncio.create_task(_repeat(CAMERA_PERIOD, self._watched, self._film)),
        )

    def close(self) -> None:
        """Stop watching."""
        for task in self._tasks:
            task.cancel()

    async def _look(self) -> None:
        self._robot.check()
        self.flush()
        monitor = self._robot.monitor
        if self._robot.viewers:
            self._send(self._robot.running_line)
        if monitor and self._robot.viewers:
            await self._report_world(monitor)
        if not self._robot.active and monotonic() > self._until:
            self._awake.clear()

    async def _report_world(self, monitor: "Monitor") -> None:
        state = await self._in_thread(telemetry.telemetry, monitor)
        if monitor is not self._robot.monitor:
            # The robot is in another world by now, which the pages already show.
            return
        self._send(state)
        drawing = self._drawn.news(monitor.strokes())
        if drawing:
            for page in self._robot.viewers:
                page.send(drawing)
        # After the state, which may reveal a broken link.
        self._send(telemetry.link(monitor))
        for sound in telemetry.sounds(monitor):
            for page in self._robot.viewers:
                page.send(sound)

    def _send(self, message: messages.ToPage) -> None:
        """Send a message to every page, unless it is the same as the last of its type."""
        if self._last.get(type(message)) == message:
            return
        self._last[type(message)] = message
        for page in self._robot.viewers:
            page.send(message)

    async def _film(self) -> None:
        monitor = self._robot.monitor
        watching = [page for page in self._robot.viewers if page.watching]
        if monitor is None or not watching:
            self._watched.clear()
            return
        picture = await self._in_thread(monitor.camera)
        # The same object means that nothing has moved since.
        if picture and picture is not self._filmed and monitor is self._robot.monitor:
            self._filmed = picture
            for page in watching:
                page.send(telemetry.camera_frame(picture), picture.jpeg)

    async def _in_thread(self, function: Callable[..., Found], *args: object) -> Found:
        return await to_thread.run_sync(
            function, *args, abandon_on_cancel=True, limiter=self._limiter
        )


async def _repeat(
    period: float, wanted: asyncio.Event, action: Callable[[], Awaitable[None]]
) -> None:
    """Repeat an action at an interval while its condition is true."""
    loop = asyncio.get_running_loop()
    while True:
        await wanted.wait()
        began = loop.time()
        await action()
        await asyncio.sleep(max(0.0, began + period - loop.time()))


class Bumps:
    """What a robot has bumped into in a run."""

    def __init__(self) -> None:
        self._seen = 0
        #: When it last touched each thing, in seconds of the robot's time.
        self._touched: dict[str, float] = {}

    def news(self, collisions: Sequence[Collision]) -> Iterator[messages.Bumped]:
        """The bumps since the last call.

        Args:
            collisions: all of the run so far.
        """
        new, self._seen = collisions[self._seen :], len(collisions)
        for bump in new:
            before, self._touched[bump.thing] = self._touched.get(bump.thing, -math.inf), bump.time
            if bump.time - before >= APART:
                yield messages.Bumped(bump.time, thing_phrase(bump.thing))
