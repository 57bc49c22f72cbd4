"""Carries bytes to and from a Thymio, over a network connection or a serial port."""

import socket
from contextlib import suppress
from typing import Protocol

from learnblock.errors import RobotConnectionError
from learnblock.robots.real import require
from learnblock.timing import MONOTONIC, Deadline, SteadyClock

#: Receive timeout in seconds; after each one, the reader checks whether to stop.
MOMENT = 0.1
#: Timeout in seconds for sending.
SENDING = 0.5
#: Seconds to wait for the other end to close a connection.
PARTING = 0.3
BAUD = 115_200


class Wire(Protocol):
    """Bytes to and from a robot."""

    #: The address or port, for errors.
    name: str

    def receive(self) -> bytes:
        """Receive data; returns empty bytes after a moment without data.

        Raises:
            OSError: the connection is broken.
        """

    def send(self, data: bytes) -> None:
        """Send all of the data.

        Raises:
            OSError: the connection is broken.
        """

    def close(self) -> None:
        """Close it; a thread that is receiving returns within a moment."""


class TcpWire:
    """A network connection.

    Args:
        address: the name or IP address of the other end.
        port: the port of the other end.
        timeout: how long to wait for the connection, in seconds.
        missing: the code of the message if no program answers: what to start.
        clock: the clock of the farewell.

    Raises:
        RobotConnectionError: no program answers there.
    """

    def __init__(
        self,
        address: str,
        port: int,
        timeout: float,
        missing: str = "thymio-no-listener",
        clock: SteadyClock = MONOTONIC,
    ) -> None:
        self._clock = clock
        self.name = f"{address}:{port}"
        try:
            self._socket = socket.create_connection((address, port), timeout=timeout)
        except OSError as error:
            raise RobotConnectionError(missing, place=self.name) from error
        # A command is only a few bytes, which should be sent at once.
        self._socket.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        self._socket.settimeout(MOMENT)

    def receive(self) -> bytes:
        try:
            data = self._socket.recv(65536)
        except TimeoutError:
            return b""
        if not data:
            raise ConnectionError("closed by the other end")
        return data

    def send(self, data: bytes) -> None:
        self._socket.sendall(data)

    def close(self) -> None:
        # An abrupt close with unread answers is an error for the other side, and crashes Aseba's
        # playground.
        with self._socket, suppress(OSError):
            self._socket.shutdown(socket.SHUT_WR)
            until = Deadline.after(PARTING, self._clock)
            while not until.is_over:
                self._socket.settimeout(until.left)
                if not self._socket.recv(65536):
                    return


class SerialWire:
    """A serial port: the robot's USB cable, or the radio's dongle.

    Args:
        device: such as ``/dev/ttyACM0`` or ``COM3``.

    Raises:
        RobotConnectionError: it cannot be opened.
    """

    def __init__(self, device: str) -> None:
        serial = require("serial", "thymio")
        self.name = device
        try:
            # Another program on the same port would receive half of the answers.
            self._port = serial.Serial(
                device, BAUD, timeout=MOMENT, write_timeout=SENDING, exclusive=True
            )
        except (OSError, ValueError) as error:
            raise RobotConnectionError(
                "thymio-port-closed", place=device, reason=str(error)
            ) from error

    def receive(self) -> bytes:
        try:
            data: bytes = self._port.read(max(1, self._port.in_waiting))
        except TypeError as error:
            # pyserial's error when the port is closed during a read.
            raise ConnectionError("the port was closed") from error
        return data

    def send(self, data: bytes) -> None:
        self._port.write(data)

    def close(self) -> None:
        self._port.close()
