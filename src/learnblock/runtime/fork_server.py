"""A process that forks the processes of programs, for a batch that isolates many of them.

It has loaded what programs need, so a program starts in milliseconds. Its process is a child of the
fork server, but belongs to whoever has ordered it, and ends with it.
"""

import os
import signal
import socket
import subprocess
import sys
from subprocess import TimeoutExpired
from types import TracebackType
from typing import Self

from learnblock.runtime.containment.environment import without_folders
from learnblock.runtime.forking import NUMBER
from learnblock.runtime.process_group import Process
from learnblock.runtime.standby import PROGRAMS, Standby, child_command


# Why: docs/decisions.md, "An isolated program of a batch is forked, not started"
class ForkServer:
    """A process that forks the processes of programs; it ends with the thread that started it.

    Args:
        module: the module that it runs; where nothing can be forked, each process runs it.
    """

    def __init__(self, module: str = PROGRAMS) -> None:
        self._module = module
        self._orders: socket.socket | None = None
        self._process: subprocess.Popen[bytes] | None = None

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, kind: object, error: BaseException | None, traceback: TracebackType | None
    ) -> None:
        self.end()

    def begin(self) -> None:
        """Start it, if it isn't running and the system can do what it needs."""
        if _is_possible() and (self._process is None or self._process.poll() is not None):
            self.end()
            # Each order stays whole, whoever else sends one.
            self._orders, theirs = socket.socketpair(type=socket.SOCK_SEQPACKET)
            with theirs:
                self._process = subprocess.Popen(  # noqa: S603 - our own interpreter and module
                    child_command(self._module, theirs.fileno()),
                    env=without_folders(),
                    stdin=subprocess.DEVNULL,
                    stdout=subprocess.DEVNULL,
                    pass_fds=(theirs.fileno(),),
                )

    def let_go(self) -> None:
        """Order no more from this process; the server ends by itself when no process does."""
        if self._orders:
            self._orders.close()
            self._orders = None

    def end(self) -> None:
        """Kill it, and with it all processes that it has forked."""
        self.let_go()
        if self._process:
            self._process.kill()
            self._process.wait()
            self._process = None

    def standby(self) -> Standby:
        """A process for a program: of the server's, or a new one if it could not be started.

        Raises:
            OSError: the server has ended.
        """
        return _ForkedStandby(self._orders) if self._orders else Standby(self._module)


class _ForkedStandby(Standby):
    """A process that the server has forked.

    Args:
        orders: where it is ordered.
    """

    def __init__(self, orders: socket.socket) -> None:
        self._orders = orders
        super().__init__()

    def end(self) -> None:
        super().end()
        self._forked.close()

    def _begin(self, theirs: socket.socket) -> Process:
        try:
            self._forked = _Forked(self._orders, theirs, self.scratch.path)
        except OSError:
            self.scratch.remove()
            self.connection.close()
            raise
        return self._forked


class _Forked(Process):
    """A forked process, as `subprocess.Popen` would show it.

    Args:
        orders: where it is ordered.
        link: its end of its link.
        folder: its temporary folder.
    """

    def __init__(self, orders: socket.socket, link: socket.socket, folder: str) -> None:
        #: The process is killed when this is closed, and its number is not used again before.
        self._control, control = socket.socketpair()
        with control:
            try:
                socket.send_fds(orders, [folder.encode()], [link.fileno(), control.fileno()])
            except OSError:
                self.close()
                raise
        self.pid = self._heard()
        self.returncode: int | None = None

    def close(self) -> None:
        """Kill it if it is still running, and free its number."""
        self._control.close()

    def poll(self) -> int | None:
        try:
            return self.wait(0)
        except TimeoutExpired:
            return None

    def wait(self, timeout: float | None = None) -> int:
        if self.returncode is None:
            self._control.settimeout(timeout)
            try:
                self.returncode = self._heard()
            except (BlockingIOError, TimeoutError) as error:
                raise TimeoutExpired("a forked process", timeout or 0.0) from error
            except OSError:
                # The server has been killed, and with it all that it has forked.
                self.returncode = -signal.SIGKILL
        return self.returncode

    def terminate(self) -> None:
        self._signal(signal.SIGTERM)

    def kill(self) -> None:
        self._signal(signal.SIGKILL)

    def _signal(self, number: int) -> None:
        if self.returncode is None:
            os.kill(self.pid, number)

    def _heard(self) -> int:
        heard = self._control.recv(NUMBER.size)
        if not heard:
            self.close()
            raise ConnectionResetError("the fork server has ended")
        [number] = NUMBER.unpack(heard)
        return int(number)


def _is_possible() -> bool:
    """Whether the end of a process can be waited for among other things."""
    if sys.platform != "linux" or not hasattr(os, "pidfd_open"):
        return False
    try:
        os.close(os.pidfd_open(os.getpid()))
    except OSError:
        return False
    return True
