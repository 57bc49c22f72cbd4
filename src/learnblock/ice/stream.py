"""Messages over a socket, within time."""

import socket
from time import monotonic

from learnblock.errors import IceEncodingError, IceLinkError
from learnblock.ice.messages import HEADER, Kind, read_header

_CHUNK = 65536


class Stream:
    """The client's end of a TCP connection; one thread may send while another receives.

    Args:
        host: where a component listens.
        port: of it.
        deadline: by which, in seconds of `monotonic`, the connection must be made.

    Raises:
        IceLinkError: nobody listens there.
    """

    def __init__(self, host: str, port: int, deadline: float) -> None:
        try:
            self._inwards = socket.create_connection((host, port), _left(deadline))
        except UnicodeError as error:
            # Some texts cannot even be looked up.
            raise IceLinkError("there is no such address") from error
        except OSError as error:
            raise IceLinkError(_reason(error)) from error
        self._inwards.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        # A time limit belongs to a socket object: with two, sending and receiving have their own.
        self._outwards = self._inwards.dup()
        self._outwards.settimeout(_left(deadline))
        self._received = bytearray()

    def send(self, data: bytes, deadline: float) -> None:
        """Send a message.

        Raises:
            IceLinkError: it cannot be sent, or not in time.
        """
        self._outwards.settimeout(_left(deadline))
        try:
            self._outwards.sendall(data)
        except OSError as error:
            raise IceLinkError(_reason(error)) from error

    def receive(self, deadline: float) -> tuple[Kind, bytes]:
        """The next message: its kind, and what follows its header.

        Raises:
            IceLinkError: none comes, or not in time, or it is nonsense.
        """
        try:
            kind, size = read_header(self._take(HEADER.size, deadline))
            return kind, self._take(size, deadline)
        except IceEncodingError as error:
            raise IceLinkError(f"it sends nonsense: {error}") from error
        except OSError as error:
            raise IceLinkError(_reason(error)) from error

    def has_news(self) -> bool:
        """Whether something has come already: a message, or the end of the connection."""
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
        """Close it; the second time does nothing."""
        # A thread that waits on it is woken by this, and not by closing.
        try:
            self._inwards.shutdown(socket.SHUT_RDWR)
        except OSError:
            # The other end was faster.
            pass
        finally:
            self._inwards.close()
            self._outwards.close()

    def _take(self, size: int, deadline: float) -> bytes:
        while len(self._received) < size:
            self._inwards.settimeout(_left(deadline))
            data = self._inwards.recv(max(_CHUNK, size - len(self._received)))
            if not data:
                raise ConnectionResetError("it closed the connection")
            self._received += data
        taken = bytes(memoryview(self._received)[:size])
        del self._received[:size]
        return taken


def _left(deadline: float) -> float:
    """The seconds until then: at least so many that what has come already is found."""
    return max(deadline - monotonic(), 0.001)


def _reason(error: OSError) -> str:
    if isinstance(error, TimeoutError):
        return "it does not answer in time"
    if isinstance(error, ConnectionRefusedError):
        return "nobody listens there"
    if isinstance(error, socket.gaierror):
        return "there is no such address"
    return (error.strerror or str(error)).lower()
