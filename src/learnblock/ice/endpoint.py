"""A component's address, with a connection that is renewed when it breaks."""

import threading

from learnblock.closing import Closing
from learnblock.errors import IceLinkError
from learnblock.ice.connection import Connection, NeverReadError
from learnblock.ice.encoding import Reader
from learnblock.timing import MONOTONIC, Deadline, SteadyClock


class Endpoint(Closing):
    """A component's address: a context manager that keeps one connection to it.

    It connects at the first call, and again at the next call after the connection broke.

    Args:
        host: the computer's name or IP address.
        port: the component's port.
        timeout: limit of a call in seconds.
        clock: the clock of the limits.
    """

    def __init__(
        self, host: str, port: int, timeout: float, clock: SteadyClock = MONOTONIC
    ) -> None:
        self.host = host
        self.port = port
        self.timeout = timeout
        self._clock = clock
        self._lock = threading.Lock()
        self._connection: Connection | None = None
        self._closed = threading.Event()

    def __str__(self) -> str:
        return f"{self.host}:{self.port}"

    def call(self, opening: bytes, parameters: bytes, *, again: bool) -> Reader:
        """Make a call and wait for its reply.

        Args:
            opening: see `Connection.call`.
            parameters: see `Connection.call`.
            again: whether to repeat a call that may already have been received.

        Raises:
            IceLinkError: the component cannot be reached, or does not answer in time.
        """
        deadline = Deadline.after(self.timeout, self._clock)
        connection, is_new = self._connected(deadline)
        try:
            return connection.call(opening, parameters, deadline)
        except IceLinkError as error:
            is_read = not isinstance(error, NeverReadError)
            if is_new or (is_read and not again) or deadline.is_over:
                raise
        connection, _ = self._connected(deadline)
        return connection.call(opening, parameters, deadline)

    def close(self) -> None:
        """Close the connection for good; calling it twice is harmless."""
        # Not under the lock, because a connecting thread has it.
        self._closed.set()
        if self._connection:
            self._connection.close()

    def _connected(self, deadline: Deadline) -> tuple[Connection, bool]:
        """A usable connection, and whether it is new."""
        with self._lock:
            if self._closed.is_set():
                raise IceLinkError("ice-closed")
            if self._connection and self._connection.is_usable(deadline):
                return self._connection, False
            if self._connection:
                self._connection.close()
            self._connection = Connection(self.host, self.port, deadline)
            if self._closed.is_set():
                # The endpoint was closed during the connection attempt.
                self._connection.close()
            return self._connection, True
