"""Ending a process together with everything it has started."""

import os
import signal
import subprocess
from contextlib import suppress
from typing import Any, Protocol

#: Seconds that a killed process may take to end: longer only if a device does not answer it.
_DYING = 2.0


class Process(Protocol):
    """A process, as `subprocess.Popen` shows it."""

    pid: int
    returncode: int | Any

    def poll(self) -> int | None:
        """Its exit status, or None if it is still running."""

    def wait(self, timeout: float | None = None) -> int:
        """Its exit status, once it has ended.

        Raises:
            subprocess.TimeoutExpired: it is still running after that many seconds.
        """

    def terminate(self) -> None:
        """Ask it to end."""

    def kill(self) -> None:
        """Kill it."""


def abort(process: Process) -> None:
    """Kill a process that leads a session, and its process group, without waiting for its end.

    What it has started is in its group. Windows has no groups: only the process itself ends there.
    """
    # Its number may be that of another process once it has been waited for.
    if process.poll() is None:
        _kill(process)


def kill(process: Process) -> None:
    """Kill a process as `abort` does, and wait for its end, at most some seconds.

    What is left of its group is killed too if the process itself has ended before.
    """
    _kill(process)
    with suppress(subprocess.TimeoutExpired):
        process.wait(_DYING)


def _kill(process: Process) -> None:
    if hasattr(os, "killpg"):
        with suppress(ProcessLookupError, PermissionError):
            os.killpg(process.pid, signal.SIGKILL)
    process.kill()
