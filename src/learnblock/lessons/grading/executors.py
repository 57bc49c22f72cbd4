"""Where pieces are made: in processes of this computer, or on the workers of a Dask cluster."""

import multiprocessing
import os
import signal
import sys
from collections.abc import Callable, Iterator
from concurrent.futures import Executor, ProcessPoolExecutor
from contextlib import AbstractContextManager, contextmanager
from dataclasses import dataclass
from typing import Any

from learnblock.errors import LearnBlockError
from learnblock.installation import add_on
from learnblock.runtime.containment import kernel

#: Seconds to wait for the scheduler, and for its first worker.
PATIENCE = 20.0
#: How often a piece is tried on a cluster, each time on another worker if there is one.
TRIES = 3
#: Pieces that wait for each worker, so that it never waits for one.
AHEAD = 4


@dataclass(frozen=True, slots=True)
class Workers:
    """An executor.

    Args:
        executor: makes pieces.
        most: how many pieces it is given at the same time.
    """

    executor: Executor
    most: int


OpenWorkers = Callable[[], AbstractContextManager[Workers]]


@contextmanager
def local(processes: int) -> Iterator[Workers]:
    """Processes of this computer.

    Args:
        processes: how many pieces are made at the same time.
    """
    # Not forked: this process may have threads.
    context = multiprocessing.get_context("spawn")
    executor = ProcessPoolExecutor(processes, context, initializer=_begin, initargs=(os.getpid(),))
    try:
        yield Workers(executor, AHEAD * processes)
    finally:
        executor.shutdown(cancel_futures=True)


@contextmanager
def cluster(address: str) -> Iterator[Workers]:
    """The workers of a Dask cluster.

    Args:
        address: of its scheduler, such as ``tcp://192.168.1.7:8786``.

    Raises:
        LearnBlockError: the extra is not installed, or there is no scheduler or worker.
    """
    try:
        from distributed import Client  # noqa: PLC0415 - an extra
    except ImportError as error:
        raise LearnBlockError("grade-no-dask", command=add_on("cluster")) from error
    try:
        client: Any = Client(  # type: ignore[no-untyped-call] # Dask has few types
            address, timeout=PATIENCE, set_as_default=False
        )
    except (OSError, ValueError) as error:
        raise LearnBlockError("grade-no-scheduler", address=address) from error
    with client:
        try:
            client.wait_for_workers(1, timeout=PATIENCE)
        except TimeoutError as error:
            raise LearnBlockError("grade-no-workers", address=address) from error
        # Not pure: each piece is made, even if the cluster knows the result of an equal one.
        executor = client.get_executor(pure=False, retries=TRIES)
        try:
            yield Workers(executor, AHEAD * sum(client.nthreads().values()))
        finally:
            executor.shutdown(wait=False)


def _begin(parent: int) -> None:
    """Prepare a process of this computer.

    Args:
        parent: the process that started it.
    """
    # Ctrl-C is for the process that started it, which decides what is still made.
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    if sys.platform == "linux":
        kernel.die_with_parent(signal.SIGKILL)
        if os.getppid() != parent:
            # It was killed while this one was starting.
            os._exit(1)
