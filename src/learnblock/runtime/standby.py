"""A process that loads what programs need while it waits for one.

This module imports little, so that a command can start such a process before it loads the rest.
"""

import os
import socket
import subprocess
import sys
from collections.abc import Mapping
from contextlib import suppress
from types import TracebackType
from typing import Self

from learnblock.runtime import process_group
from learnblock.runtime.containment.environment import environment
from learnblock.runtime.containment.scratch import Scratch
from learnblock.runtime.process_group import Process

#: The module that runs programs.
PROGRAMS = "learnblock.runtime.child"


def child_command(module: str, handle: int) -> list[str]:
    """The command of a process that runs code of others.

    Args:
        module: the module that runs it.
        handle: its end of a link, or of a fork server's orders.
    """
    # -P: a program's folder must not shadow our modules.
    return [sys.executable, "-P", "-m", module, str(handle)]


# Why: docs/decisions.md, "learnblock run starts the child first"
class Standby:
    """A process in a separate session, so that its children can be ended with it.

    It ends with its context, and when the other end of its link is closed.

    Args:
        module: the module that it runs, with the number of its end of the link.
    """

    def __init__(self, module: str = PROGRAMS) -> None:
        self._module = module
        #: Our end of the link.
        self.connection, theirs = socket.socketpair()
        theirs.set_inheritable(True)
        self.scratch = Scratch()
        with theirs:
            self.process = self._begin(theirs)
        self._is_ended = False

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, kind: object, error: BaseException | None, traceback: TracebackType | None
    ) -> None:
        self.end()

    def join_processors(self) -> None:
        """Move it to the processors of this thread, as if this thread had started it."""
        if sys.platform == "linux":
            # It may have ended.
            with suppress(ProcessLookupError):
                os.sched_setaffinity(self.process.pid, os.sched_getaffinity(0))

    def abort(self) -> None:
        """Kill it with everything it has started, from any thread; `end` still has to clean up."""
        process_group.abort(self.process)

    def end(self) -> None:
        """Kill it with everything it has started; calling it twice is harmless."""
        if self._is_ended:
            return
        self._is_ended = True
        process_group.kill(self.process)
        self.scratch.remove()
        self.connection.close()

    def _begin(self, theirs: socket.socket) -> Process:
        """Start the process, with its end of the link."""
        return self._start(theirs.fileno(), environment(self.scratch.path))

    def _start(self, handle: int, variables: Mapping[str, str]) -> "subprocess.Popen[bytes]":
        command = child_command(self._module, handle)
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
