"""What contains a robot's driver: the thread that calls it gives up what it does not need.

Landlock and seccomp apply to a thread and to the threads and programs that it starts later. The
host of a run is a thread, so it can give up rights that the server's other threads keep.
"""

import glob
import os
import stat
import sys
import threading
from collections.abc import Callable, Iterator
from concurrent.futures import Future
from contextlib import suppress
from contextvars import copy_context
from typing import TypeVar

from learnblock.client import Rights

Result = TypeVar("Result")


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


def in_own_thread(function: Callable[[], Result], stop: Callable[[], object]) -> Result:
    """Call a function in a thread that may give up its rights, and return its result.

    Args:
        function: the function.
        stop: makes the function return soon; called when this thread is interrupted.
    """
    if sys.platform != "linux":
        # Nothing to give up; and on Windows a waiting thread cannot be interrupted.
        return function()
    done: Future[Result] = Future()
    context = copy_context()
    thread = threading.Thread(
        target=_fulfil, args=(done, lambda: context.run(function)), name="host", daemon=True
    )
    thread.start()
    try:
        return done.result()
    finally:
        if not done.done():
            stop()
        thread.join()


def _fulfil(done: "Future[Result]", function: Callable[[], Result]) -> None:
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
