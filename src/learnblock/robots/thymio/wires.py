"""The ways to a Thymio: a network connection or a serial port, as bytes that come and go."""

import socket
from contextlib import suppress
from time import monotonic
from typing import Protocol

from learnblock.errors import RobotConnectionError
from learnblock.robots.real import require

#: Seconds for which a wire is listened to at a time, so that its reader sees that it shall end.
MOMENT = 0.1
#: Seconds within which what is sent must have left.
SENDING = 0.5
#: Seconds that the other end has to close a connection.
PARTING = 0.3
BAUD = 115_200


class Wire(Protocol):
    """Bytes to and from a robot."""

    #: How a person would call it.
    name: str

    def receive(self) -> bytes:
        """What has come; nothing after a moment in which nothing did.

        Raises:
            OSError: it is broken.
        """

    def send(self, data: bytes) -> None:
        """Send all of it.

        Raises:
            OSError: it is broken.
        """

    def close(self) -> None:
        """Let go of it; whoever is receiving returns within a moment."""


class TcpWire:
    """A network connection.

    Args:
        address: name or number of the other end.
        port: of the other end.
        patience: seconds until it must be connected.

    Raises:
        RobotConnectionError: it cannot be connected.
    """

    def __init__(self, address: str, port: int, patience: float) -> None:
        self.name = f"{address}:{port}"
        try:
            self._socket = socket.create_connection((address, port), timeout=patience)
        except OSError as error:
            raise RobotConnectionError(
                f"nothing that speaks for a Thymio answers at {self.name} ({error});"
                " is the program there running, and are address and port right?"
            ) from error
        # A command is a few bytes, and should not wait for more of them.
        self._socket.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        self._socket.settimeout(MOMENT)

    def receive(self) -> bytes:
        try:
            data = self._socket.recv(65536)
        except TimeoutError:
            return b""
        if not data:
            raise ConnectionError("the other end closed it")
        return data

    def send(self, data: bytes) -> None:
        self._socket.sendall(data)

    def close(self) -> None:
        # With our last words still under way, and answers unread, a sudden end would be an error to
        # the other side; Aseba's playground does not survive that.
        with self._socket, suppress(OSError):
            self._socket.shutdown(socket.SHUT_WR)
            self._socket.settimeout(PARTING)
            until = monotonic() + PARTING
            while monotonic() < until and self._socket.recv(65536):
                pass


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
            # Another program on the same port would take half of the answers.
            self._port = serial.Serial(
                device, BAUD, timeout=MOMENT, write_timeout=SENDING, exclusive=True
            )
        except (OSError, ValueError) as error:
            raise RobotConnectionError(
                f"the Thymio at {device} cannot be opened ({error});"
                " is it plugged in, and does no other program, such as Thymio Suite, use it?"
            ) from error

    def receive(self) -> bytes:
        try:
            data: bytes = self._port.read(max(1, self._port.in_waiting))
        except TypeError as error:
            # What pyserial trips over when it is closed while it reads.
            raise ConnectionError("it was closed") from error
        return data

    def send(self, data: bytes) -> None:
        self._port.write(data)

    def close(self) -> None:
        self._port.close()
