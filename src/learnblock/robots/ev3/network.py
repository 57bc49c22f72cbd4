"""Network connections with a time limit."""

import socket
import threading
from contextlib import suppress

from learnblock.errors import RobotNotFoundError
from learnblock.timing import MONOTONIC, Deadline, SteadyClock


def dial(address: str, port: int, timeout: float, clock: SteadyClock = MONOTONIC) -> socket.socket:
    """Make a TCP connection; `timeout` also applies to each send and receive.

    Args:
        address: a name or an IP address.
        port: the port.
        timeout: how long to wait, in seconds.
        clock: the clock of this limit.

    Raises:
        RobotNotFoundError: no program answers there in time.
    """
    deadline = Deadline.after(timeout, clock)
    number = resolve(address, timeout)
    try:
        connection = socket.create_connection((number, port), max(0.1, deadline.left))
    except OSError as error:
        raise RobotNotFoundError("ev3-no-answer", place=f"{address}:{port}") from error
    connection.settimeout(timeout)
    connection.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
    return connection


def hang_up(connection: socket.socket) -> None:
    """Close a connection and wake up threads waiting on it; calling it twice is harmless."""
    with suppress(OSError):
        # Fails if either side has already closed it.
        connection.shutdown(socket.SHUT_RDWR)
    connection.close()


def resolve(name: str, timeout: float) -> str:
    """The IP address of a computer.

    Raises:
        RobotNotFoundError: the name is unknown, or looking it up takes too long.
    """
    addresses: list[str] = []
    search = threading.Thread(target=_resolve, args=(name, addresses), name="resolve", daemon=True)
    search.start()
    # The system's own limit is many seconds for an unknown .local name.
    search.join(timeout)
    if not addresses:
        raise RobotNotFoundError("ev3-not-found", address=name)
    return addresses[0]


def _resolve(name: str, addresses: list[str]) -> None:
    try:
        addresses.append(socket.gethostbyname(name))
    except (OSError, UnicodeError):
        # The list stays empty.
        return
