"""The place where a program runs: a separate process, or a thread of the host."""

import contextlib
import ctypes
import os
import signal
import socket
import subprocess
import sys
import threading
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from typing import Protocol

from learnblock.errors import ProgramStopped
from learnblock.runtime import child
from learnblock.runtime.activity import Activity, of_process, of_thread
from learnblock.runtime.containment.environment import environment
from learnblock.runtime.containment.scratch import Scratch, Usage
from learnblock.runtime.limits import Limits
from learnblock.runtime.link import Link, SocketLink
from learnblock.runtime.messages import FromChild, FromHost


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

    def kill(self) -> None:
        """End the program and everything it has started."""

    def wait(self, timeout: float) -> int | None:
        """Its exit status (negative: the signal that killed it), or None if it is still running."""

    def usage(self, limits: Limits) -> Usage:
        """Return the resources it uses."""

    def activity(self) -> Activity | None:
        """Return what it has done so far; None if the system does not say."""


class ProcessWorker:
    """A process in a separate session, so that its children can be ended with it."""

    def __init__(self) -> None:
        ours, theirs = socket.socketpair()
        theirs.set_inheritable(True)
        self._scratch = Scratch()
        with theirs:
            self._process = self._start(theirs.fileno(), environment(self._scratch.path))
        self.link: Link[FromChild] = SocketLink(ours, FromChild)

    def interrupt(self) -> None:
        self._process.terminate()

    def kill(self) -> None:
        if hasattr(os, "killpg"):
            # Everything it has started is in its process group.
            with contextlib.suppress(ProcessLookupError, PermissionError):
                os.killpg(self._process.pid, signal.SIGKILL)
        self._process.kill()
        self._process.wait()
        self._scratch.remove()
        self.link.close()

    def wait(self, timeout: float) -> int | None:
        try:
            return self._process.wait(timeout)
        except subprocess.TimeoutExpired:
            return None

    def usage(self, limits: Limits) -> Usage:
        return self._scratch.usage(self._process.pid, limits)

    def activity(self) -> Activity | None:
        return of_process(self._process.pid)

    @staticmethod
    def _start(handle: int, variables: Mapping[str, str]) -> "subprocess.Popen[bytes]":
        # -P: a program's folder must not shadow our modules.
        command = [sys.executable, "-P", "-m", child.__name__, str(handle)]
        if sys.platform == "win32":
            return subprocess.Popen(  # noqa: S603 - our own interpreter and module
                command,
                env=variables,
                stdin=subprocess.DEVNULL,
                stdout=subprocess.DEVNULL,
                close_fds=False,
            )
        return subprocess.Popen(  # noqa: S603 - our own interpreter and module
            command,
            env=variables,
            stdin=subprocess.DEVNULL,
            # A program's prints go over the link; this output is only ours.
            stdout=subprocess.DEVNULL,
            pass_fds=(handle,),
            start_new_session=True,
        )


class ThreadWorker:
    """A thread of the host, for trusted programs: it can neither be limited nor killed."""

    def __init__(self) -> None:
        ours, theirs = socket.socketpair()
        self.link: Link[FromChild] = SocketLink(ours, FromChild)
        self._thread = threading.Thread(
            target=self._run, args=(theirs,), name="program", daemon=True
        )
        self._thread.start()

    def interrupt(self) -> None:
        if self._thread.ident is not None:
            ctypes.pythonapi.PyThreadState_SetAsyncExc(
                ctypes.c_ulong(self._thread.ident), ctypes.py_object(ProgramStopped)
            )

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
        with connection, contextlib.suppress(ProgramStopped):
            child.run(SocketLink(connection, FromHost))
