"""The process that starts pupils' servers: it has loaded LearnBlock, and forks a server for each.

A server so starts in milliseconds and shares most of its memory with the others. This process
serves no pupil itself and has a single thread, so that forking is safe.
"""

import gc
import os
import select
import signal
import socket
import sys
from importlib import import_module
from typing import NoReturn

import msgspec

from learnblock.classroom import pupil_server
from learnblock.classroom.pupil_server import Order
from learnblock.runtime.containment import kernel

#: What pupils' servers load when they need it.
_PRELOADED = (
    "cv2",
    "learnblock.lessons",
    "learnblock.running",
    "learnblock.server.pages.lobby",
    "learnblock.server.serve",
    "uvicorn.lifespan.on",
    "uvicorn.protocols.websockets.websockets_sansio_impl",
)
#: Seconds between two looks for servers that have ended.
_LOOK = 0.1


class Ask(msgspec.Struct, frozen=True):
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


class _Nursery:
    """The servers that have been started.

    Args:
        connection: to the classroom; each message is a line.
    """

    def __init__(self, connection: socket.socket) -> None:
        self._connection = connection
        self._servers: dict[int, str] = {}

    def run(self) -> None:
        """Start and stop servers until the classroom has gone."""
        waiting = b""
        while True:
            self._reap()
            if not select.select([self._connection], [], [], _LOOK)[0]:
                continue
            received = self._connection.recv(65536)
            if not received:
                self._end()
                return
            *lines, waiting = (waiting + received).split(b"\n")
            for line in lines:
                self._do(msgspec.json.decode(line, type=Ask))

    def _do(self, ask: Ask) -> None:
        if ask.order:
            self._start(ask.order)
        elif ask.stop in self._servers:
            os.kill(ask.stop, signal.SIGTERM)

    def _start(self, order: Order) -> None:
        process = os.fork()
        if process == 0:
            _serve(order, self._connection)
        self._servers[process] = order.pupil

    def _reap(self) -> None:
        for process in list(self._servers):
            if os.waitpid(process, os.WNOHANG)[0]:
                self._tell(News(self._servers.pop(process), process))

    def _end(self) -> None:
        """Have every server save everything and end."""
        for process in self._servers:
            os.kill(process, signal.SIGTERM)
        for process in self._servers:
            os.waitpid(process, 0)

    def _tell(self, news: News) -> None:
        _send(self._connection, news)


def _serve(order: Order, connection: socket.socket) -> NoReturn:
    """Be a server, and end with it."""
    status = 1
    try:

        def started(port: int) -> None:
            _send(connection, News(order.pupil, os.getpid(), port))

        pupil_server.run(order, started)
        status = 0
    except Exception as error:  # noqa: BLE001 - the classroom says it
        reason = f"{type(error).__name__}: {error}"
        _send(connection, News(order.pupil, os.getpid(), reason=reason[:500]))
    finally:
        # Nothing of the parent's is to be cleaned up here.
        os._exit(status)


def _send(connection: socket.socket, news: News) -> None:
    # One call, because servers share the connection.
    connection.sendall(msgspec.json.encode(news) + b"\n")


def main() -> None:
    """Run as ``python -m learnblock.classroom.nursery FD``: FD is our end of the connection."""
    kernel.die_with_parent(signal.SIGTERM)
    connection = socket.socket(fileno=int(sys.argv[1]))
    for module in _PRELOADED:
        import_module(module)
    # A server that collected what we have loaded would copy all of it.
    gc.freeze()
    _Nursery(connection).run()


if __name__ == "__main__":
    main()
