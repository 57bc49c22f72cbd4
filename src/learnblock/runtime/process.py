"""The place where a program runs: a separate process, or a thread of the host."""

import contextlib
import ctypes
import os
import socket
import struct
import subprocess
import sys
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Protocol

from learnblock.errors import ProgramStopped
from learnblock.runtime.activity import Activity, of_process, of_thread
from learnblock.runtime.containment.scratch import Usage
from learnblock.runtime.limits import Limits
from learnblock.runtime.link import Link, SocketLink
from learnblock.runtime.messages import FromChild, FromHost
from learnblock.runtime.standby import Standby

#: Seconds in which a program has to read the answer to its question.
LONGEST_SENDING = 10


@contextmanager
def one_processor() -> Iterator[None]:
    """Keep this thread, and the processes it starts, on one processor.

    Host and programs take turns, so a second processor gains nothing, and waking a process on
    another one costs ten times as much. Only Linux allows the choice.
    """
    if sys.platform != "linux":
        yield
        return
    before = os.sched_getaffinity(0)
    present = ctypes.CDLL(None).sched_getcpu()
    os.sched_setaffinity(0, {present} if present in before else before)
    try:
        yield
    finally:
        os.sched_setaffinity(0, before)


class Worker(Protocol):
    """The worker that runs a program at the other end of `link`."""

    link: Link[FromChild]

    def interrupt(self) -> None:
        """Raise ProgramStopped in the program."""

    def abort(self) -> None:
        """Kill the program at once, from any thread, even if its host hangs; `kill` cleans up."""

    def kill(self) -> None:
        """End the program and everything it has started."""

    def wait(self, timeout: float) -> int | None:
        """Its exit status (negative: the signal that killed it), or None if it is still running."""

    def usage(self, limits: Limits) -> Usage:
        """Return the resources it uses."""

    def activity(self) -> Activity | None:
        """Return what it has done so far; None if the system does not report it."""


# Why: docs/decisions.md, "A program runs as a light child of a robot host"
class ProcessWorker:
    """A process of its own.

    Args:
        standby: the process, if it has been started before.
    """

    def __init__(self, standby: Standby | None = None) -> None:
        self._standby = standby or Standby()
        if standby:
            standby.join_processors()
        _limit_sending(self._standby.connection)
        self.link: Link[FromChild] = SocketLink(self._standby.connection, FromChild)

    @property
    def process(self) -> int:
        """The number of its process."""
        return self._standby.process.pid

    def interrupt(self) -> None:
        self._standby.process.terminate()

    def abort(self) -> None:
        self._standby.abort()

    def kill(self) -> None:
        self._standby.end()

    def wait(self, timeout: float) -> int | None:
        try:
            return self._standby.process.wait(timeout)
        except subprocess.TimeoutExpired:
            return None

    def usage(self, limits: Limits) -> Usage:
        return self._standby.scratch.usage(self.process, limits)

    def activity(self) -> Activity | None:
        return of_process(self.process)


def _limit_sending(connection: socket.socket) -> None:
    """Let a host not wait for ever for a program that reads none of its answers."""
    if os.name == "posix":
        # By the kernel: a timeout of Python's costs two more system calls for each message.
        connection.setsockopt(
            socket.SOL_SOCKET, socket.SO_SNDTIMEO, struct.pack("ll", LONGEST_SENDING, 0)
        )


class ThreadWorker:
    """A thread of the host, for trusted programs: it can neither be limited nor killed."""

    def __init__(self) -> None:
        self._connection, theirs = socket.socketpair()
        self.link: Link[FromChild] = SocketLink(self._connection, FromChild)
        self._thread = threading.Thread(
            target=self._run, args=(theirs,), name="program", daemon=True
        )
        self._thread.start()

    def interrupt(self) -> None:
        if self._thread.ident is not None:
            ctypes.pythonapi.PyThreadState_SetAsyncExc(
                ctypes.c_ulong(self._thread.ident), ctypes.py_object(ProgramStopped)
            )

    def abort(self) -> None:
        # Both ends of the link notice that, also in the middle of a call.
        with contextlib.suppress(OSError):
            self._connection.shutdown(socket.SHUT_RDWR)

    def kill(self) -> None:
        self.link.close()
        self._thread.join(timeout=1)

    def wait(self, timeout: float) -> int | None:
        self._thread.join(timeout)
        return None if self._thread.is_alive() else 0

    def usage(self, limits: Limits) -> Usage:  # noqa: ARG002 - it is the host's own
        return Usage()

    def activity(self) -> Activity | None:
        # The clock of a thread that has ended must not be asked for.
        alive = self._thread.is_alive() and self._thread.ident is not None
        return of_thread(self._thread.ident or 0) if alive else None

    @staticmethod
    def _run(connection: socket.socket) -> None:
        from learnblock.runtime import child  # noqa: PLC0415 - the host of a process needs none of it

        with connection, contextlib.suppress(ProgramStopped):
            child.run(SocketLink(connection, FromHost))
