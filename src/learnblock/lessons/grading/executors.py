"""Where pieces are made: in processes of this computer, or on the workers of a Dask cluster."""

import asyncio
import logging
import multiprocessing
import os
import signal
import sys
from collections.abc import Callable, Iterator
from concurrent.futures import BrokenExecutor, Executor, Future, ProcessPoolExecutor
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
        BrokenExecutor: the scheduler was lost.
    """
    try:
        from distributed import Client  # noqa: PLC0415 - an extra
    except ImportError as error:
        raise LearnBlockError("grade-no-dask", command=add_on("cluster")) from error
    with _unlogged("distributed.client"):
        try:
            client: Any = Client(  # type: ignore[no-untyped-call] # Dask has few types
                address, timeout=PATIENCE, set_as_default=False
            )
        except (OSError, ValueError) as error:
            raise LearnBlockError("grade-no-scheduler", address=address) from error
        try:
            yield Workers(_Cluster(client), AHEAD * _threads(client, address))
        finally:
            _close(client)


def _close(client: Any) -> None:
    """Close a client, which cancels what is still being made."""
    try:
        client.close()
    except RuntimeError:
        # It was connecting to a lost scheduler again, and fails to since it is closed.
        if client.status != "closed":
            raise


def _threads(client: Any, address: str) -> int:
    """How many pieces the workers make at the same time, once there is a worker."""
    try:
        client.wait_for_workers(1, timeout=PATIENCE)
        return sum(client.nthreads().values())
    except TimeoutError as error:
        raise LearnBlockError("grade-no-workers", address=address) from error
    except OSError as error:
        raise BrokenExecutor from error


class _Cluster(Executor):
    """Gives pieces to a cluster.

    With Dask's own executor, a piece whose result was on its way never ends if its scheduler is
    lost. Here it ends with `BrokenExecutor`.

    Args:
        client: of the cluster.
    """

    def __init__(self, client: Any) -> None:
        self._client = client

    def submit(self, fn: Callable[..., Any], /, *args: Any, **options: Any) -> Future[Any]:
        """Have a function called by a worker."""
        call = self._made(fn, args, options)
        return asyncio.run_coroutine_threadsafe(call, self._client.loop.asyncio_loop)

    async def _made(self, function: Callable[..., Any], args: Any, options: Any) -> Any:
        piece = None
        try:
            # Not pure: each piece is made, even if the cluster knows the result of an equal one.
            piece = self._client.submit(function, *args, pure=False, retries=TRIES, **options)
            return await piece
        except Exception as error:
            if piece is not None and piece.status == "error":
                raise
            raise BrokenExecutor from error


@contextmanager
def _unlogged(name: str) -> Iterator[None]:
    """Leave out what a library logs about errors of which the grading itself tells."""
    logger = logging.getLogger(name)
    before, logger.disabled = logger.disabled, True
    try:
        yield
    finally:
        logger.disabled = before


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
