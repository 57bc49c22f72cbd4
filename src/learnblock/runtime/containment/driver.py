"""Contains a robot's driver: the thread that calls it gives up the rights that it does not need.

Landlock and seccomp apply to a thread and to the threads and programs that it starts later. The
host of a run is a thread, so it can give up rights that the server's other threads keep.
"""

import glob
import os
import stat
import sys
import threading
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import Future
from contextlib import suppress
from contextvars import copy_context
from time import monotonic
from typing import Any, Generic, TypeVar

from learnblock.client import Rights
from learnblock.errors import LearnBlockError
from learnblock.runtime.escalation import Measure, escalate

Result = TypeVar("Result")
#: Seconds that a thread may take to finish once its function has returned.
_FINISHING = 0.1


# Why: docs/decisions.md, "A driver is contained as a thread"
def give_up(rights: Rights) -> None:
    """Permanently refuse this thread everything but reading, computing and these rights.

    A kernel that offers less refuses less: a driver works without its fence, too.
    """
    if sys.platform != "linux":
        return
    # They take time to load, and only Linux needs them.
    from learnblock.runtime.containment import landlock, seccomp  # noqa: PLC0415

    with suppress(OSError):
        landlock.restrict_writing(_writable(rights, landlock.DEVICE, landlock.FOLDER))
    with suppress(OSError):
        seccomp.restrict_driver(
            network=rights.network, programs=rights.programs, files=bool(rights.folders)
        )


class OwnThread(Generic[Result]):
    """A thread that calls a function, and may give up its rights, once it is started.

    No one has to wait for it: if it hangs in a driver, this process can end nevertheless.

    Args:
        function: the function.
    """

    def __init__(self, function: Callable[[], Result]) -> None:
        self._done: Future[Result] = Future()
        context = copy_context()
        self._thread = threading.Thread(
            target=_fulfil,
            args=(self._done, lambda: context.run(function)),
            name="host",
            daemon=True,
        )

    def start(self) -> None:
        """Start it; if this is interrupted, the function may be called nevertheless."""
        self._thread.start()

    def forestall(self) -> bool:
        """Keep the function from being called; return whether that was in time."""
        return self._done.cancel()

    def result(self, seconds: float | None = None) -> Result:
        """Wait for the function, and return its result.

        Raises:
            TimeoutError: it has not returned after so many seconds.
        """
        return self._done.result(seconds)

    def ends_within(self, seconds: float) -> bool:
        """Wait for its end; return whether it has ended."""
        self._thread.join(seconds)
        return not self._thread.is_alive()


def end_threads(threads: Iterable[OwnThread[Any]], measures: Iterable[Measure]) -> None:
    """End threads by one measure after another, unless they have ended.

    Raises:
        LearnBlockError: one has not ended, and is left behind.
    """
    running = [thread for thread in threads if not thread.forestall()]

    def ended(seconds: float) -> bool:
        deadline = monotonic() + seconds
        return all(thread.ends_within(max(0.0, deadline - monotonic())) for thread in running)

    if not ended(0) and not escalate(measures, ended):
        raise LearnBlockError("run-given-up")


def in_own_thread(
    function: Callable[[], Result],
    measures: Iterable[Measure] = (),
    seconds: float | None = None,
) -> Result:
    """Call a function in a thread that may give up its rights, and return its result.

    Args:
        function: the function.
        measures: end the function when this thread is interrupted, or has waited too long.
        seconds: the longest time to wait; None for no limit.

    Raises:
        LearnBlockError: no measure has ended the function.
        TimeoutError: it had to be ended, because it took too long.
    """
    if sys.platform != "linux":
        # Nothing to give up; and on Windows a waiting thread cannot be interrupted.
        return function()
    thread = OwnThread(function)
    try:
        thread.start()
        result = thread.result(seconds)
    except BaseException:
        # The function has failed or takes too long, or this thread was interrupted.
        end_threads([thread], [Measure(bool, _FINISHING), *measures])
        raise
    thread.ends_within(_FINISHING)
    return result


def _fulfil(done: "Future[Result]", function: Callable[[], Result]) -> None:
    if not done.set_running_or_notify_cancel():
        return
    try:
        done.set_result(function())
    except BaseException as error:  # noqa: BLE001 - raised again in the waiting thread
        done.set_exception(error)


def _writable(rights: Rights, device: int, folder: int) -> Iterator[tuple[str, int]]:
    """The files that a driver may change, each with what it may do with it."""
    for path in (os.devnull, *_devices(rights)):
        yield path, device
    for path in rights.folders:
        yield os.path.expanduser(path), folder  # noqa: PTH111 - Landlock takes text


def _devices(rights: Rights) -> Iterator[str]:
    """The device files of these patterns that exist now; never disks or other files."""
    for pattern in rights.devices:
        for path in glob.glob(pattern):  # noqa: PTH207 - absolute patterns
            with suppress(OSError):
                if stat.S_ISCHR(os.stat(path).st_mode):  # noqa: PTH116 - as above
                    yield path
