"""A robot with Bluetooth Low Energy, emulated over a socket of this computer.

The lines are those of `learnblock.robots.bluetooth.loopback`. As with a real robot, one program is
connected at a time; a second one of the same computer may share its connection.
"""

import json
import socket
import threading
from collections.abc import Callable, Mapping, Sequence
from contextlib import suppress
from time import monotonic
from typing import Any, Protocol

from learnblock.closing import Closing
from learnblock.robots.bluetooth import loopback

#: Errors of the Attribute Protocol (Bluetooth Core Specification 5.4, vol. 3, part F, 3.4.1.1).
NOT_SUPPORTED, NOT_ALLOWED = 0x06, 0x13

#: Bytes that tell whether a client wants to share.
_SHARING = 16
#: Seconds for which a client waits until the previous one has left, and between two looks.
_LEAVING, _LOOK = 0.5, 0.05

Notify = Callable[[str, bytes], None]
Services = Mapping[str, Mapping[str, Sequence[str]]]


class GattError(Exception):
    """A request is refused; the argument is an error of the Attribute Protocol."""


class Peripheral(Protocol):
    """A robot with services.

    Attributes:
        name: as it advertises itself.
        largest: the maximum number of bytes that are written at once.
        services: by UUID, the characteristics by UUID with their properties.
        manufacturer: what it advertises of its manufacturer, by the manufacturer's number.
    """

    name: str
    largest: int
    services: Services
    manufacturer: Mapping[int, bytes]

    def connected(self, notify: Notify) -> None:
        """Take a new client, to which `notify(uuid, value)` sends a notification."""

    def heard(self, uuid: str) -> None:
        """Note that the client hears the notifications of a characteristic from now on."""

    def read(self, uuid: str) -> bytes:
        """The value of a characteristic."""

    def write(self, uuid: str, value: bytes) -> None:
        """Take a value; a `GattError` refuses it."""

    def disconnected(self) -> None:
        """Let the client go."""


class GattServer(Closing):
    """Serves one client at a time in threads, until it is closed.

    Args:
        robot: the robot.
        address: the local address on which it listens.
        port: its port; 0 takes a free one.
    """

    def __init__(self, robot: Peripheral, address: str, port: int) -> None:
        self._robot = robot
        self._client = threading.Lock()
        self._sending = threading.Lock()
        self._connections: set[socket.socket] = set()
        self._listener = socket.create_server((address, port))
        self.port: int = self._listener.getsockname()[1]
        self._thread = threading.Thread(target=self._listen, name="gatt", daemon=True)
        self._thread.start()

    def close(self) -> None:
        # Closing alone does not interrupt a thread that waits.
        for waiting in (self._listener, *self._connections):
            with suppress(OSError):
                waiting.shutdown(socket.SHUT_RDWR)
        self._listener.close()
        self._thread.join()

    def _listen(self) -> None:
        while True:
            try:
                connection, _ = self._listener.accept()
            except OSError:
                return
            connection.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
            threading.Thread(
                target=self._converse, args=(connection,), name="gatt client", daemon=True
            ).start()

    def _converse(self, connection: socket.socket) -> None:
        with connection, suppress(OSError):
            is_first = self._client.acquire(timeout=_LOOK)
            until = monotonic() + _LEAVING
            while not is_first and not _shares(connection):
                if monotonic() > until:
                    connection.sendall(b'{"taken": true}\n')
                    return
                is_first = self._client.acquire(timeout=_LOOK)
            self._connections.add(connection)
            try:
                self._serve(connection, is_first=is_first)
            finally:
                self._connections.discard(connection)
                if is_first:
                    self._robot.disconnected()
                    self._client.release()

    def _serve(self, connection: socket.socket, *, is_first: bool) -> None:
        def send(message: Mapping[str, Any]) -> None:
            with self._sending, suppress(OSError):
                connection.sendall(json.dumps(message).encode() + b"\n")

        robot = self._robot
        heard: set[str] = set()

        def notify(uuid: str, value: bytes) -> None:
            if uuid in heard:
                send({"notify": uuid, "value": value.hex()})

        advertised = {str(maker): data.hex() for maker, data in robot.manufacturer.items()}
        described = {"largest": robot.largest, "services": robot.services}
        send({"name": robot.name, "manufacturer": advertised, **described})
        if is_first:
            robot.connected(notify)
        with connection.makefile("rb") as requests:
            while line := requests.readline(loopback.LONGEST_LINE):
                send(self._answer(line, heard))

    def _answer(self, line: bytes, heard: set[str]) -> dict[str, Any]:
        try:
            request = json.loads(line)
            if "share" in request:
                return {"done": True}
            if "read" in request:
                return {"value": self._robot.read(request["read"]).hex()}
            if "hear" in request:
                heard.add(request["hear"])
                self._robot.heard(request["hear"])
                return {"done": True}
            self._robot.write(request["write"], bytes.fromhex(request["value"]))
        except GattError as error:
            return {"error": error.args[0]}
        except (ValueError, TypeError, KeyError, RecursionError):
            return {"error": NOT_SUPPORTED}
        return {"done": True}


def _shares(connection: socket.socket) -> bool:
    """Whether a client wants to share the connection of another one; it says so at once."""
    connection.settimeout(0)
    try:
        return connection.recv(_SHARING, socket.MSG_PEEK).startswith(b'{"share"')
    except BlockingIOError:
        return False
    finally:
        connection.settimeout(None)
