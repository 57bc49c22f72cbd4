"""An asyncio event loop for drivers, which are threads that block.

Libraries for Bluetooth Low Energy, such as bleak, and many others are asynchronous.
"""

import asyncio
import selectors
import threading
from collections.abc import Callable, Coroutine
from concurrent.futures import CancelledError, Future
from contextlib import AbstractAsyncContextManager, AsyncExitStack
from typing import Any, Generic, TypeVar

from learnblock.closing import Closing
from learnblock.errors import RobotConnectionError
from learnblock.i18n import Phrase
from learnblock.timing import MONOTONIC, Deadline, SteadyClock

Result = TypeVar("Result")

#: Seconds for cancelled coroutines to finish, and then for what was entered to be left.
LEAVING = 1.0
#: Seconds for which a loop without timers waits; then it waits again.
_DAY = 24 * 3600.0
#: The errors of any connection; a library may have its own ones.
_FAILURES = OSError, EOFError


class EventLoop(Closing):
    """Runs coroutines in a thread of its own, each with a time limit.

        def connect(self):
            self.loop = EventLoop(self.settings.address, self.steady_clock, failures=(BleakError,))
            self.client = self.loop.enter(BleakClient(self.settings.address), seconds=5)
            self.loop.run(self.client.start_notify(DISTANCE, self.note_distance), seconds=1)
            self.add(Base(self.move))

        def move(self, adv, rot):
            self.loop.run(self.client.write_gatt_char(SPEED, packed(adv, rot)), seconds=1)

        def check_link(self):
            self.loop.check()

        def disconnect(self):
            self.loop.close()

    Callbacks are called in the loop's thread, and must return at once. All waiting in coroutines,
    such as `asyncio.sleep` and `asyncio.timeout`, goes by the clock too, so that a test can let it
    pass. As with every link of a driver, the first failure ends it: what still runs is cancelled,
    and the same error is raised from then on.

    Args:
        place: the robot's address, for errors.
        clock: the clock of its limits.
        failures: the library's own errors that mean a broken connection.
    """

    def __init__(
        self,
        place: str,
        clock: SteadyClock = MONOTONIC,
        failures: tuple[type[Exception], ...] = (),
    ) -> None:
        self.place = place
        self._clock = clock
        self._failures: tuple[type[Exception], ...] = (*_FAILURES, *failures)
        self._lock = threading.Lock()
        #: Held by a thread that calls a coroutine, until it has woken the loop.
        self._waking = threading.Lock()
        self._lost: Phrase | Exception | None = None
        self._closed = False
        self._entered = AsyncExitStack()
        self._started: set[Future[object]] = set()
        self._selector = _ClockSelector(clock)
        self._loop = _ClockLoop(clock, self._selector)
        self._loop.set_exception_handler(self._on_unhandled)
        self._thread = threading.Thread(target=self._work, name="event loop", daemon=True)
        self._thread.start()

    def run(self, coroutine: Coroutine[Any, Any, Result], seconds: float) -> Result:
        """Run a coroutine, and return its result.

        Raises:
            RobotConnectionError: the connection is lost or closed, or it takes longer than
                `seconds`, and is cancelled.
            Exception: the coroutine raises it.
        """
        call = self._submit(coroutine)
        try:
            return self._result(call, seconds)
        except (RobotConnectionError, CancelledError):
            self.check()
            self._require_open()
            raise
        except self._failures as error:
            self._lose(error)
            self.check()
            raise

    def start(self, coroutine: Coroutine[Any, Any, object]) -> None:
        """Let a coroutine run until it ends or this is closed; `check` raises its error.

        Raises:
            RobotConnectionError: the connection is lost or closed.
        """
        future = self._submit(coroutine).future
        # A loop holds its tasks weakly: one that waits for nothing else would be collected.
        self._started.add(future)
        future.add_done_callback(self._note_end)

    def enter(self, manager: AbstractAsyncContextManager[Result], seconds: float) -> Result:
        """Enter a context, such as a connection, which is left when this is closed.

        Raises:
            RobotConnectionError: as for `run`.
        """
        return self.run(self._entered.enter_async_context(manager), seconds)

    def check(self) -> None:
        """Check that nothing has failed so far.

        Raises:
            RobotConnectionError: the connection is lost.
            Exception: the driver's own coroutine or callback raised it.
        """
        if isinstance(self._lost, Phrase):
            raise RobotConnectionError(self._lost.code, **self._lost.values)
        if self._lost is not None:
            raise self._lost

    def close(self) -> None:
        """Cancel what runs, leave what was entered and end the thread; in two seconds at most."""
        with self._lock:
            was_closed, self._closed = self._closed, True
        if threading.current_thread() is self._thread:
            # A callback can't wait for its own end.
            if not was_closed:
                self._call_in_loop(self._leave()).future.add_done_callback(self._stop)
            return
        if not was_closed:
            self._end()
        self._thread.join(LEAVING)

    def _end(self) -> None:
        try:
            self._result(self._call_in_loop(self._leave()), 2 * LEAVING)
        except self._failures:
            # A lost connection can't be left in an orderly way, and `check` has reported it.
            pass
        finally:
            self._loop.call_soon_threadsafe(self._loop.stop)

    def _stop(self, _: Future[None]) -> None:
        self._loop.stop()

    def _result(self, call: "_Call[Result]", seconds: float) -> Result:
        """Wait for a result.

        Raises:
            TimeoutError: the time is over; the coroutine is cancelled.
        """
        deadline = Deadline.after(seconds, self._clock)
        try:
            # So that a test's clock can't pass before the coroutine waits; the loop may be blocked.
            call.settled.wait(seconds)
            if self._clock.wait(call.done, deadline.left):
                return call.future.result()
        except BaseException:
            # Also if a person interrupts this thread.
            call.future.cancel()
            raise
        call.future.cancel()
        raise TimeoutError

    def _submit(self, coroutine: Coroutine[Any, Any, Result]) -> "_Call[Result]":
        with self._lock:
            try:
                self._require_usable()
            except BaseException:
                # Else Python warns that it was never awaited.
                coroutine.close()
                raise
            return self._call_in_loop(coroutine)

    def _require_usable(self) -> None:
        if threading.current_thread() is self._thread:
            raise RuntimeError("A callback can't wait: use asyncio.create_task(...) there.")
        self.check()
        self._require_open()

    def _require_open(self) -> None:
        if self._closed:
            raise RobotConnectionError("robot-link-closed", place=self.place)

    def _call_in_loop(self, coroutine: Coroutine[Any, Any, Result]) -> "_Call[Result]":
        with self._waking:
            call = _Call(asyncio.run_coroutine_threadsafe(coroutine, self._loop))
            self._loop.call_soon_threadsafe(self._settle, call.settled)
        return call

    def _settle(self, settled: threading.Event) -> None:
        # The loop may run this before it has been woken, and would wait and be woken once more.
        with self._waking:
            self._selector.settling.append(settled)

    def _work(self) -> None:
        try:
            self._loop.run_forever()
        finally:
            self._loop.close()

    async def _leave(self) -> None:
        running = asyncio.all_tasks() - {asyncio.current_task()}
        for task in running:
            task.cancel()
        if running:
            await asyncio.wait(running, timeout=LEAVING)
        await self._entered.aclose()

    def _note_end(self, future: Future[object]) -> None:
        self._started.discard(future)
        error = None if future.cancelled() else future.exception()
        if isinstance(error, Exception):
            self._lose(error)

    def _on_unhandled(self, _: asyncio.AbstractEventLoop, context: dict[str, Any]) -> None:
        """Note an error of a callback, or of a task that no one awaits."""
        error = context.get("exception")
        if isinstance(error, Exception):
            self._lose(error)

    def _lose(self, error: Exception) -> None:
        with self._lock:
            if self._lost is None and not self._closed:
                self._lost = self._reason(error)
                self._loop.call_soon_threadsafe(self._cancel_tasks)

    def _cancel_tasks(self) -> None:
        for task in asyncio.all_tasks(self._loop):
            task.cancel()

    def _reason(self, error: Exception) -> Phrase | Exception:
        if isinstance(error, RobotConnectionError) or not isinstance(error, self._failures):
            return error
        if isinstance(error, TimeoutError):
            return Phrase("robot-link-silent", place=self.place)
        reason = getattr(error, "strerror", None) or str(error) or type(error).__name__
        return Phrase("robot-link-broke", place=self.place, reason=reason)


class _Call(Generic[Result]):
    """A coroutine that a thread waits for.

    Attributes:
        future: its result.
        settled: set once the loop has nothing left to do but wait.
        done: set at its end.
    """

    def __init__(self, future: Future[Result]) -> None:
        self.future = future
        self.settled = threading.Event()
        self.done = threading.Event()
        future.add_done_callback(lambda _: self.done.set())


class _ClockLoop(asyncio.SelectorEventLoop):
    """An event loop whose time is that of a driver's clock."""

    def __init__(self, clock: SteadyClock, selector: "_ClockSelector") -> None:
        self._steady_clock = clock
        super().__init__(selector)

    def time(self) -> float:
        return self._steady_clock.now()


class _ClockSelector(selectors.DefaultSelector):
    """Waits for sockets until a moment of a driver's clock.

    Attributes:
        settling: events to set once nothing is ready, added by the loop's thread.
    """

    def __init__(self, clock: SteadyClock) -> None:
        super().__init__()
        self._clock = clock
        self.settling: list[threading.Event] = []
        self._activity = _Activity(super().select, self.settling)

    def select(self, timeout: float | None = None) -> list[tuple[selectors.SelectorKey, int]]:
        if timeout is None or timeout > 0:
            self._clock.wait(self._activity, _DAY if timeout is None else timeout)
            self.settling[:] = [event for event in self.settling if not event.is_set()]
        return super().select(0)


class _Activity(threading.Event):
    """Set while a socket is ready, so that a clock can wait for sockets as for any event.

    Args:
        select: waits for sockets, as `selectors.BaseSelector.select`.
        settling: events that are set once a clock waits for this one, and nothing is ready.
    """

    def __init__(
        self, select: Callable[[float | None], object], settling: list[threading.Event]
    ) -> None:
        super().__init__()
        self._select = select
        self._settling = settling

    def is_set(self) -> bool:
        return self.wait(0)

    def wait(self, timeout: float | None = None) -> bool:
        if self._settling:
            if self._select(0):
                return True
            for event in self._settling:
                event.set()
        return bool(self._select(timeout))
