"""A driver's clock on which time passes only when a test lets it."""

import math
import threading
from collections.abc import Callable, Iterator
from concurrent.futures import Future
from contextlib import contextmanager
from dataclasses import dataclass
from time import monotonic
from typing import TypeVar

Result = TypeVar("Result")

#: Seconds after which a waiting thread looks again: an event tells only those that wait for it.
GLANCE = 0.001
#: Seconds for which a thread may work between two waits, so that a test fails instead of hanging.
LIMIT = 30.0
NANOSECONDS = 1_000_000_000


@dataclass(eq=False)
class _Wait:
    """A thread that waits until a moment, in nanoseconds, or until something else has happened."""

    thread: threading.Thread
    until: int
    has_happened: Callable[[], bool]
    is_over: bool = False

    @property
    def is_waiting(self) -> bool:
        return not self.is_over and not self.has_happened()


class ManualClock:
    """A `SteadyClock` for tests of a driver: threads wait until the test lets their time pass.

    >>> clock = ManualClock()
    >>> clock.advance(3600)
    >>> clock.now()
    3600.0

    Each waiting thread is woken at exactly its moment, one after another, and has done what it does
    and waits again before the next one is woken.
    """

    def __init__(self) -> None:
        # Whole numbers, so that ten tenths are one.
        self._now = 0
        self._waits: list[_Wait] = []
        self._changed = threading.Condition()

    # For drivers.

    def now(self) -> float:
        """Seconds that have passed."""
        return self._now / NANOSECONDS

    def sleep(self, seconds: float) -> None:
        """Wait until the test has let so many seconds pass."""
        self.wait(threading.Event(), seconds)

    def wait(self, event: threading.Event, seconds: float) -> bool:
        """Wait until the event is set or its time has come; return whether it is set."""
        with self._waiting(seconds, event.is_set) as wait:
            while not event.is_set() and not wait.is_over:
                with self._changed:
                    self._changed.wait(GLANCE)
        return event.is_set()

    def wait_for(
        self, condition: threading.Condition, predicate: Callable[[], bool], seconds: float
    ) -> bool:
        """Wait until the predicate holds or its time has come; return whether it holds."""
        with self._waiting(seconds, _never) as wait:
            while not predicate() and not wait.is_over:
                condition.wait(GLANCE)
        return predicate()

    # For tests.

    def advance(self, seconds: float) -> None:
        """Let time pass, and wake each thread whose time comes.

        Raises:
            TimeoutError: a thread that was woken neither waits again nor ends.
        """
        until = self._now + _nanoseconds(seconds)
        while wait := self._first(until):
            self._end(wait)
        with self._changed:
            self._now = until

    def block_until(self, waits: int) -> None:
        """Wait for real until so many threads wait for time to pass.

        Raises:
            TimeoutError: there are fewer.
        """
        self._require(lambda: len(self._waits) >= waits, f"{waits} threads wait")

    def run(self, call: Callable[[], Result]) -> Result:
        """Call a function, and let time pass whenever it waits; return what it returns.

        Time passes at once: what the function waits for doesn't come, unless another thread that
        waits on this clock brings it.

        Raises:
            Exception: the function raises it.
            TimeoutError: it neither waits on this clock nor returns.
        """
        outcome: Future[Result] = Future()

        def work() -> None:
            try:
                outcome.set_result(call())
            except BaseException as error:  # noqa: BLE001 - raised in the test
                outcome.set_exception(error)

        thread = threading.Thread(target=work, name="run by a manual clock", daemon=True)
        thread.start()
        while self._waits_again(thread):
            if wait := self._first(math.inf):
                self._end(wait)
        return outcome.result()

    @contextmanager
    def _waiting(self, seconds: float, has_happened: Callable[[], bool]) -> Iterator[_Wait]:
        with self._changed:
            until = self._now + _nanoseconds(seconds)
            wait = _Wait(threading.current_thread(), until, has_happened, until == self._now)
            self._waits.append(wait)
            self._changed.notify_all()
        try:
            yield wait
        finally:
            with self._changed:
                self._waits.remove(wait)
                self._changed.notify_all()

    def _first(self, until: float) -> _Wait | None:
        """The wait that ends first, if it ends by then."""
        self._require(
            lambda: all(wait.is_waiting for wait in self._waits), "threads notice their events"
        )
        with self._changed:
            due = (wait for wait in self._waits if wait.until <= until and not wait.is_over)
            return min(due, key=lambda wait: wait.until, default=None)

    def _end(self, wait: _Wait) -> None:
        with self._changed:
            self._now = max(self._now, wait.until)
            wait.is_over = True
            self._changed.notify_all()
        self._require(lambda: wait not in self._waits, f"{wait.thread.name} goes on")
        self._waits_again(wait.thread)

    def _waits_again(self, thread: threading.Thread) -> bool:
        """Whether a thread waits for time to pass, once it does or has ended."""

        def waits() -> bool:
            return any(wait.thread is thread and wait.is_waiting for wait in self._waits)

        self._require(
            lambda: waits() or not thread.is_alive(), f"{thread.name} waits again or ends"
        )
        with self._changed:
            return waits()

    def _require(self, condition: Callable[[], bool], what: str) -> None:
        deadline = monotonic() + LIMIT
        with self._changed:
            while not condition():
                if monotonic() > deadline:
                    raise TimeoutError(f"in vain: {what}")
                # The end of a thread notifies no one.
                self._changed.wait(GLANCE)


def _never() -> bool:
    """For a predicate, which only the thread that holds the condition may call."""
    return False


def _nanoseconds(seconds: float) -> int:
    """At least one for a time that isn't over, so that waiting for the rest of it ends."""
    return max(round(seconds * NANOSECONDS), 1) if seconds > 0 else 0
