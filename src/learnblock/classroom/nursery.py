"""The process that starts pupils' servers: it has loaded LearnBlock, and forks a server for each.

A server so starts in milliseconds and shares most of its memory with the others. This process
serves no pupil itself and has a single thread, so that forking is safe.
"""

import gc
import math
import os
import select
import signal
import socket
import sys
from contextlib import suppress
from dataclasses import dataclass
from importlib import import_module
from time import monotonic
from types import FrameType
from typing import NoReturn

import msgspec

from learnblock.classroom import pupil_server
from learnblock.classroom.pupil_server import Order
from learnblock.runtime.containment import kernel
from learnblock.server.catalog import world_choices
from learnblock.server.runs.memory import share_one_heap

#: What pupils' servers load when they need it.
_PRELOADED = (
    "cv2",
    "learnblock.lessons",
    "learnblock.monitor.world_monitor",
    "learnblock.robots.sim_cozmo",
    "learnblock.robots.sim_ebo",
    "learnblock.robots.sim_ev3",
    "learnblock.robots.sim_thymio",
    "learnblock.running",
    "learnblock.server.pages.lobby",
    "learnblock.server.serve",
    "uvicorn.lifespan.on",
    "uvicorn.protocols.websockets.websockets_sansio_impl",
)
#: Seconds between two looks for servers that have ended.
_LOOK = 0.1


@dataclass(frozen=True, slots=True)
class Patience:
    """How long a server may take to save everything and end; then it is killed, in seconds.

    Args:
        asked: after it was asked.
        hurried: after it was asked again, because the whole class has to end at once.
    """

    asked: float = 15.0
    hurried: float = 3.0


class NurseryRequest(msgspec.Struct, frozen=True):
    """From the classroom: a server to start, or the process of one to stop."""

    order: Order | None = None
    stop: int = 0


class News(msgspec.Struct, frozen=True):
    """To the classroom.

    Args:
        pupil: whose server it is.
        process: its process.
        port: where it answers; 0 if it has ended.
        reason: why it has ended, if it could not start.
    """

    pupil: str
    process: int
    port: int = 0
    reason: str = ""


class Nursery:
    """The servers that have been started.

    Args:
        connection: to the classroom; each message is a line.
        patience: how long servers may take to end.
    """

    def __init__(self, connection: socket.socket, patience: Patience) -> None:
        self._connection = connection
        self._patience = patience
        self.servers: dict[int, str] = {}
        #: When each server that has to end is killed, by its process.
        self._deadlines: dict[int, float] = {}
        self._received = b""
        #: Whether a server was killed, and may not have saved its last second.
        self.has_killed = False
        #: Whether no more servers are started.
        self._is_ending = False
        #: Whether everything has to end at once; set by a signal.
        self._is_hurried = False

    def run(self) -> None:
        """Start and stop servers until the classroom has gone, and every server with it."""
        while self.servers or not self._is_ending:
            self._reap()
            if self._is_hurried:
                self._is_hurried = False
                self._end(self._patience.hurried)
            open_ends = [] if self._is_ending else [self._connection]
            if select.select(open_ends, [], [], _LOOK)[0]:
                self._listen()

    def hurry(self, number: int, frame: FrameType | None) -> None:  # noqa: ARG002 - a handler
        """Have every server save and end at once."""
        self._is_hurried = True

    def _listen(self) -> None:
        received = self._connection.recv(65536)
        if not received:
            self._end(self._patience.asked)
        *lines, self._received = (self._received + received).split(b"\n")
        for line in lines:
            self._do(msgspec.json.decode(line, type=NurseryRequest))

    def _do(self, ask: NurseryRequest) -> None:
        if ask.order:
            self._start(ask.order)
        elif ask.stop in self.servers:
            self._stop(ask.stop, self._patience.asked)

    def _start(self, order: Order) -> None:
        # Until the server handles it: ours would take a server's signal for one to us.
        signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGTERM})
        process = os.fork()
        if process == 0:
            _serve(order, self._connection)
        signal.pthread_sigmask(signal.SIG_UNBLOCK, {signal.SIGTERM})
        self.servers[process] = order.pupil

    def _reap(self) -> None:
        for process in list(self.servers):
            ended, status = os.waitpid(process, os.WNOHANG)
            if ended:
                # One that a request to end has ended by itself had nothing to save yet.
                self.has_killed |= os.WIFSIGNALED(status) and os.WTERMSIG(status) != signal.SIGTERM
                self._deadlines.pop(process, None)
                _send(self._connection, News(self.servers.pop(process), process))
            elif self._deadlines.get(process, math.inf) < monotonic():
                os.kill(process, signal.SIGKILL)

    def _stop(self, process: int, seconds: float) -> None:
        """Have a server save everything and end; it is killed after `seconds`."""
        os.kill(process, signal.SIGTERM)
        before = self._deadlines.get(process, math.inf)
        self._deadlines[process] = min(before, monotonic() + seconds)

    def _end(self, seconds: float) -> None:
        """Have every server save everything and end; see `_stop`."""
        self._is_ending = True
        for process in self.servers:
            self._stop(process, seconds)


def _serve(order: Order, connection: socket.socket) -> NoReturn:
    """Be a server, and end with it."""
    status = 1
    try:
        signal.signal(signal.SIGTERM, signal.SIG_DFL)
        signal.pthread_sigmask(signal.SIG_UNBLOCK, {signal.SIGTERM})

        def started(port: int) -> None:
            _send(connection, News(order.pupil, os.getpid(), port))

        pupil_server.run(order, started)
        status = 0
    except Exception as error:  # noqa: BLE001 - the classroom reports it
        reason = f"{type(error).__name__}: {error}"
        _send(connection, News(order.pupil, os.getpid(), reason=reason[:500]))
    finally:
        # The child must not clean up for its parent.
        os._exit(status)


def _send(connection: socket.socket, news: News) -> None:
    # The classroom may have gone.
    with suppress(ConnectionError):
        # One call, because servers share the connection.
        connection.sendall(msgspec.json.encode(news) + b"\n")


def _preload() -> None:
    for module in _PRELOADED:
        import_module(module)
    # Each server tells its pages of all worlds; those that come with LearnBlock are read once.
    world_choices()


def main() -> None:
    """Run as ``python -m learnblock.classroom.nursery FD``: FD is our end of the connection."""
    kernel.die_with_parent(signal.SIGTERM)
    connection = socket.socket(fileno=int(sys.argv[1]))
    # Every server that is forked here has this setting.
    share_one_heap()
    _preload()
    # A server that collected what we have loaded would copy all of it.
    gc.freeze()
    nursery = Nursery(connection, Patience())
    # From the classroom, or from the kernel when the classroom has died.
    signal.signal(signal.SIGTERM, nursery.hurry)
    nursery.run()
    sys.exit(nursery.has_killed)


if __name__ == "__main__":
    main()
