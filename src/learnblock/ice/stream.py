"""Messages over a socket, with time limits."""

import socket

from learnblock.errors import IceEncodingError, IceLinkError
from learnblock.ice.messages import HEADER, MessageKind, read_header
from learnblock.timing import Deadline

_CHUNK = 65536


class Stream:
    """The client's end of a TCP connection; one thread may send while another receives.

    Args:
        host: the component's address.
        port: the component's port.
        deadline: the time limit for connecting.

    Raises:
        IceLinkError: no component listens there.
    """

    def __init__(self, host: str, port: int, deadline: Deadline) -> None:
        try:
            self._inwards = socket.create_connection((host, port), _left(deadline))
        except UnicodeError as error:
            # The string cannot be a host name at all.
            raise IceLinkError("ice-unknown-address") from error
        except OSError as error:
            raise _link_error(error) from error
        self._inwards.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        # A timeout belongs to a socket object, so sending and receiving use separate ones.
        self._outwards = self._inwards.dup()
        self._outwards.settimeout(_left(deadline))
        self._received = bytearray()

    def send(self, data: bytes, deadline: Deadline) -> None:
        """Send a message.

        Raises:
            IceLinkError: sending fails or takes too long.
        """
        self._outwards.settimeout(_left(deadline))
        try:
            self._outwards.sendall(data)
        except OSError as error:
            raise _link_error(error) from error

    def receive(self, deadline: Deadline) -> tuple[MessageKind, bytes]:
        """Receive the next message: its kind, and the part after its header.

        Raises:
            IceLinkError: no valid message arrives in time.
        """
        try:
            kind, size = read_header(self._take(HEADER.size, deadline))
            return kind, self._take(size, deadline)
        except IceEncodingError as error:
            raise IceLinkError("ice-garbled", reason=error.phrase) from error
        except OSError as error:
            raise _link_error(error) from error

    def has_news(self) -> bool:
        """Whether data or the end of the connection has arrived."""
        if self._received:
            return True
        self._inwards.settimeout(0)
        try:
            self._inwards.recv(1, socket.MSG_PEEK)
        except BlockingIOError:
            return False
        except OSError:
            return True
        return True

    def close(self) -> None:
        """Close it; calling it twice is harmless."""
        # Only `shutdown` wakes up a thread that is waiting on the socket.
        try:
            self._inwards.shutdown(socket.SHUT_RDWR)
        except OSError:
            # The other end has already closed it.
            pass
        finally:
            self._inwards.close()
            self._outwards.close()

    def _take(self, size: int, deadline: Deadline) -> bytes:
        while len(self._received) < size:
            self._inwards.settimeout(_left(deadline))
            data = self._inwards.recv(max(_CHUNK, size - len(self._received)))
            if not data:
                raise ConnectionResetError
            self._received += data
        part = bytes(memoryview(self._received)[:size])
        del self._received[:size]
        return part


def _left(deadline: Deadline) -> float:
    """The seconds left, but at least enough to read data that has already arrived."""
    return max(deadline.left, 0.001)


def _link_error(error: OSError) -> IceLinkError:
    if isinstance(error, TimeoutError):
        return IceLinkError("ice-timeout")
    if isinstance(error, ConnectionRefusedError):
        return IceLinkError("ice-no-listener")
    if isinstance(error, socket.gaierror):
        return IceLinkError("ice-unknown-address")
    if isinstance(error, ConnectionResetError):
        return IceLinkError("ice-hung-up")
    return IceLinkError("ice-broken", reason=error.strerror or str(error))
