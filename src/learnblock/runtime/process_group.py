"""Ending a process together with everything it has started."""

import os
import signal
import subprocess
from contextlib import suppress


def kill(process: "subprocess.Popen[bytes]") -> None:
    """Kill a process that leads a session, and its process group, and wait for its end.

    What it has started is in its group. Windows has no groups: only the process itself ends there.
    """
    if hasattr(os, "killpg"):
        with suppress(ProcessLookupError, PermissionError):
            os.killpg(process.pid, signal.SIGKILL)
    process.kill()
    process.wait()
