"""The open connections of a server that other computers reach.

A connection costs memory and a descriptor, and any computer in the network can open many. So
connections that wait for their browser (it has sent nothing, half a request or half a handshake, or
does not read its answer) are counted by owner: by person once a request has identified the person,
by address before that. Beyond a limit the oldest is closed; a browser opens another one when it
needs it. One that is being answered is never closed, so that a whole class can share one address,
as behind the router of a school.
"""

import ipaddress
import socket
import time
from collections import defaultdict
from collections.abc import Callable
from contextlib import suppress
from typing import Any

#: The connections of one address, and of one known person, that may wait for their browser.
MOST_UNKNOWN, MOST_KNOWN = 20, 60
#: Those of one owner that may wait for a moment: a request is usually on its way.
MOST_YOUNG = 200
#: The maximum number of connections in total.
MOST = 2000
#: Descriptors that the server needs for other things.
_RESERVE = 100
#: The descriptors to ask for where there is no limit; macOS refuses more.
_MOST_DESCRIPTORS = 10_240
#: The length of that moment in seconds.
_GRACE = 1.0


class Connections:
    """The open connections by owner, the oldest first.

    Args:
        most: the maximum in total.
        now: returns the time of a monotonic clock in seconds.
    """

    def __init__(self, most: int = MOST, now: Callable[[], float] = time.monotonic) -> None:
        self._most = most
        self._now = now
        self._open: dict[int, OpenConnection] = {}
        self._waiting: defaultdict[str, dict[int, OpenConnection]] = defaultdict(dict)

    def __len__(self) -> int:
        return len(self._open)

    def find(self, number: int) -> "OpenConnection | None":
        """The connection with this descriptor."""
        return self._open.get(number)

    def opened(self, connection: "OpenConnection") -> None:
        """A browser has connected; make room for it."""
        self._open[connection.number] = connection
        self.waits(connection)
        if len(self._open) > self._most:
            self._close_oldest(max(self._waiting.values(), key=len), 0.0)

    def waits(self, connection: "OpenConnection") -> None:
        """A connection waits for its browser from now on."""
        self.works(connection)
        connection.since = self._now()
        waiting = self._waiting[connection.owner]
        waiting[connection.number] = connection
        if len(waiting) > (MOST_KNOWN if connection.is_known else MOST_UNKNOWN):
            self._close_oldest(waiting, _GRACE if len(waiting) <= MOST_YOUNG else 0.0)

    def works(self, connection: "OpenConnection") -> None:
        """A connection no longer waits for its browser."""
        waiting = self._waiting[connection.owner]
        waiting.pop(connection.number, None)
        if not waiting:
            del self._waiting[connection.owner]

    def belongs(self, connection: "OpenConnection", person: str) -> None:
        """A request has identified the owner of a connection."""
        self.works(connection)
        connection.owner, connection.is_known = f"person {person}", True

    def closed(self, connection: "OpenConnection") -> None:
        """A connection is closed."""
        if self._open.get(connection.number) is connection:
            self.works(connection)
            del self._open[connection.number]

    def _close_oldest(self, waiting: "dict[int, OpenConnection]", age: float) -> None:
        """Close the one that has waited longest, if it has waited this many seconds."""
        latest = self._now() - age
        for connection in waiting.values():
            if connection.since > latest:
                return
            if not connection.has_sent:
                self.works(connection)
                connection.cut()
                return


class OpenConnection(socket.socket):
    """A connection, known to `Connections` until it is closed.

    Args:
        connections: those of the server.
        accepted: the socket, which this one replaces.
        address: of the browser's computer.
    """

    def __init__(self, connections: Connections, accepted: socket.socket, address: str) -> None:
        self.number = accepted.detach()
        super().__init__(fileno=self.number)
        self.owner, self.is_known = f"address {network_of(address)}", False
        self.since = 0.0
        self._connections = connections
        self.settimeout(0)
        connections.opened(self)

    @property
    def has_sent(self) -> bool:
        """Whether the browser has sent data that is not read yet, so that it isn't waited for."""
        try:
            return bool(self.recv(1, socket.MSG_PEEK))
        except OSError:
            return False

    def cut(self) -> None:
        """End the connection; its reader and writer notice."""
        with suppress(OSError):
            self.shutdown(socket.SHUT_RDWR)

    def close(self) -> None:
        """Close the socket, and forget it."""
        self._connections.closed(self)
        super().close()


class Listening(socket.socket):
    """A listening socket that counts its connections.

    Args:
        plain: the socket, which this one replaces.
        connections: counts them.
    """

    def __init__(self, plain: socket.socket, connections: Connections) -> None:
        super().__init__(fileno=plain.detach())
        self._connections = connections

    def accept(self) -> tuple[socket.socket, Any]:
        """The next connection and its address."""
        accepted, address = super().accept()
        return OpenConnection(self._connections, accepted, str(address[0])), address


def network_of(address: str) -> str:
    """The common part of a computer's addresses: it can have any number of IPv6 addresses."""
    try:
        ip = ipaddress.ip_address(address.partition("%")[0])
    except ValueError:
        return address
    if isinstance(ip, ipaddress.IPv6Address):
        return str(ip.ipv4_mapped or ipaddress.ip_network((ip, 64), strict=False))
    return str(ip)


def most_connections() -> int:
    """Allow this process all the descriptors that it may have; return how many connections fit."""
    try:
        import resource  # noqa: PLC0415 - POSIX only
    except ImportError:
        return MOST
    soft, hard = resource.getrlimit(resource.RLIMIT_NOFILE)
    wanted = _MOST_DESCRIPTORS if hard == resource.RLIM_INFINITY else hard
    if soft != resource.RLIM_INFINITY and soft < wanted:
        with suppress(OSError, ValueError):
            resource.setrlimit(resource.RLIMIT_NOFILE, (wanted, hard))
            soft = wanted
    # A page of a class has a second connection, to its pupil's server.
    return min(MOST, max(1, (soft - _RESERVE) // 2)) if soft != resource.RLIM_INFINITY else MOST
