"""Connections over the network that are there within the time allowed, or not at all."""

import socket
import threading
from contextlib import suppress
from time import monotonic

from learnblock.robots.ev3.brick import NoSuchWayError


def dial(address: str, port: int, patience: float) -> socket.socket:
    """A TCP connection; each send and receive on it may take as long as connecting may.

    Args:
        address: a name or number.
        port: of that machine.
        patience: seconds.

    Raises:
        NoSuchWayError: nobody listens there, or does not answer in time.
    """
    deadline = monotonic() + patience
    number = resolve(address, patience)
    try:
        connection = socket.create_connection((number, port), max(0.1, deadline - monotonic()))
    except OSError as error:
        raise NoSuchWayError(f"nobody answers at {address}:{port} ({error})") from error
    connection.settimeout(patience)
    connection.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
    return connection


def hang_up(connection: socket.socket) -> None:
    """Close a connection; who waits for something on it wakes up. It may be done twice."""
    with suppress(OSError):
        # Refused where the other side, or we ourselves, did that before.
        connection.shutdown(socket.SHUT_RDWR)
    connection.close()


def resolve(name: str, patience: float) -> str:
    """The number of a machine in the network.

    Raises:
        NoSuchWayError: no machine has that name, or it cannot be found out in time.
    """
    found: list[str] = []
    search = threading.Thread(target=_resolve, args=(name, found), name="resolve", daemon=True)
    search.start()
    # The system's own limit is many seconds where a .local name is not there.
    search.join(patience)
    if not found:
        raise NoSuchWayError(
            f"the network knows no `{name}`: is the brick switched on, and this computer in its"
            " network?"
        )
    return found[0]


def _resolve(name: str, found: list[str]) -> None:
    try:
        found.append(socket.gethostbyname(name))
    except (OSError, UnicodeError):
        # The empty list says it.
        return
