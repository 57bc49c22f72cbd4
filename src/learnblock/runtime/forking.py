"""The inside of a fork server: it has loaded what programs need, and forks a process for each.

It runs no program itself and has a single thread, so that forking is safe. A program's process is
as it would be after a start of its own: it has neither what belongs to other programs nor a way to
ask for another process. See `fork_server` for the other end.
"""

import gc
import os
import select
import signal
import socket
import struct
from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass

from learnblock.runtime.containment.environment import folders

#: What is said of a process: its number, then its exit status (negative: the signal).
NUMBER = struct.Struct("i")
#: An order is the path of a program's temporary folder, with its link and its control.
_LONGEST_PATH, _SENT_WITH_IT = 4096, 2


def next_program(orders: socket.socket, *prepare: Callable[[], object]) -> socket.socket | None:
    """Be a fork server: load what programs need, then fork a process for each order.

    Args:
        orders: where they arrive.
        prepare: load what each process needs.

    Returns:
        In a new process, the program's link; here, None, once nobody can order any more.
    """
    from learnblock.runtime.containment import kernel  # noqa: PLC0415 - only Linux has it

    kernel.die_with_parent(signal.SIGKILL)
    for load in prepare:
        load()
    # A process that collected what is loaded would copy all of it.
    gc.freeze()
    # Nothing of the server is left in the process of a program when this returns.
    return _Forks(orders).run()


@dataclass(frozen=True, slots=True, eq=False)
class _Fork:
    """A process of a program.

    Args:
        process: its number.
        end: a descriptor that is ready once it has ended.
        control: where its number and its status are sent. It is killed when the other end closes,
            and its number is free for other processes only then.
    """

    process: int
    end: int
    control: socket.socket


class _Forks:
    """The processes that have been forked.

    Args:
        orders: where orders for more arrive.
    """

    def __init__(self, orders: socket.socket) -> None:
        self._orders = orders
        self._controls: dict[int, _Fork] = {}
        self._ends: dict[int, _Fork] = {}

    def run(self) -> socket.socket | None:
        """Fork until nobody can order any more: see `next_program`."""
        orders = self._orders.fileno()
        while True:
            for handle in select.select([orders, *self._controls, *self._ends], [], [])[0]:
                if handle in self._ends:
                    self._report(self._ends.pop(handle))
                elif handle in self._controls:
                    self._let_go(self._controls.pop(handle))
                elif handle == orders:
                    path, handles, *_ = socket.recv_fds(self._orders, _LONGEST_PATH, _SENT_WITH_IT)
                    if not path:
                        return None
                    link, control = (socket.socket(fileno=sent) for sent in handles)
                    if self._fork(control):
                        self._close(control)
                        os.environ.update(folders(path.decode()))
                        return link
                    link.close()

    def _fork(self, control: socket.socket) -> bool:
        """Fork a process; return whether this is the new one."""
        # Until the program handles it: a process would end without saying so.
        signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGTERM})
        server = os.getpid()
        process = os.fork()
        if process == 0:
            _leave(server)
            return True
        signal.pthread_sigmask(signal.SIG_UNBLOCK, {signal.SIGTERM})
        fork = _Fork(process, os.pidfd_open(process), control)
        self._ends[fork.end] = self._controls[control.fileno()] = fork
        _say(control, process)
        return False

    def _close(self, control: socket.socket) -> None:
        """Close all that is the server's and not the program's."""
        self._orders.close()
        control.close()
        for fork in self._controls.values():
            # Also of those that have ended, and that somebody still waits for.
            os.close(fork.end)
            fork.control.close()

    def _report(self, fork: _Fork) -> None:
        """Say how a process has ended, without freeing its number."""
        status = os.waitid(os.P_PID, fork.process, os.WEXITED | os.WNOWAIT)
        assert status is not None  # noqa: S101 - it has ended
        exited = status.si_code == os.CLD_EXITED
        _say(fork.control, status.si_status if exited else -status.si_status)

    def _let_go(self, fork: _Fork) -> None:
        """Kill a process and what it has started, for which nobody waits any more."""
        self._ends.pop(fork.end, None)
        os.close(fork.end)
        for kill in (os.killpg, os.kill):
            # It may not lead a group yet.
            with suppress(ProcessLookupError):
                kill(fork.process, signal.SIGKILL)
        os.waitpid(fork.process, 0)
        fork.control.close()


def _leave(server: int) -> None:
    """Make this process one of its own, which still ends with the fork server."""
    from learnblock.runtime.containment import kernel  # noqa: PLC0415 - only Linux has it

    os.setsid()
    kernel.die_with_parent(signal.SIGKILL)
    if os.getppid() != server:
        # It has died before it could take us with it.
        os.kill(os.getpid(), signal.SIGKILL)


def _say(control: socket.socket, number: int) -> None:
    # Whoever wanted to know may have gone.
    with suppress(BrokenPipeError, ConnectionResetError):
        control.send(NUMBER.pack(number))
