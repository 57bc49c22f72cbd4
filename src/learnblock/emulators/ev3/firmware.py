"""Emulates a brick with LEGO's own firmware: it sends beacons and serves one client."""

import math
import os
import select
import socket
import threading
from contextlib import suppress
from time import monotonic

from learnblock.emulators.ev3.bytecode import ByteCodeMachine
from learnblock.emulators.vehicle import Vehicle

#: Seconds between two turns of the motors, and between two beacons.
PERIOD, BEACON = 0.005, 2.0
REPORT = 1024
#: Seconds within which a client has to introduce itself.
GREETING = 3.0


class Firmware:
    """A brick that listens on the network.

    Args:
        vehicle: the robot that it drives.
        address: the local address on which it listens.
        port: its port; 0 for a free one.
        beacon: the computer and UDP port to which it sends beacons; None for no beacons.
    """

    def __init__(
        self,
        vehicle: Vehicle,
        address: str = "127.0.0.1",
        port: int = 0,
        beacon: tuple[str, int] | None = None,
    ) -> None:
        self.machine = ByteCodeMachine(vehicle)
        self._lock = threading.Lock()
        self._closed = threading.Event()
        # As in the firmware, a second client waits until the first one is gone.
        self._listener = socket.create_server((address, port), backlog=1)
        self._listener.settimeout(0.1)
        self.port: int = self._listener.getsockname()[1]
        self._threads = [
            threading.Thread(target=work, name="firmware", daemon=True)
            for work in (self._live, self._serve)
        ]
        if beacon:
            announce = threading.Thread(
                target=self._announce, args=(beacon,), name="beacon", daemon=True
            )
            self._threads.append(announce)
        for thread in self._threads:
            thread.start()

    def close(self) -> None:
        self._closed.set()
        for thread in self._threads:
            thread.join()
        self._listener.close()

    def attach(self, file: int, *, reports: bool) -> None:
        """Also serve a client through a file, as with Bluetooth, or with USB in reports.

        Args:
            file: the brick's end, closed with the brick.
            reports: whether it is USB.
        """
        serve = self._serve_reports if reports else self._serve_stream
        thread = threading.Thread(target=serve, args=(file,), name="cable", daemon=True)
        self._threads.append(thread)
        thread.start()

    def _live(self) -> None:
        while not self._closed.wait(PERIOD):
            with self._lock:
                self.machine.turn()

    def _announce(self, beacon: tuple[str, int]) -> None:
        text = f"Serial-Number: 0016533f0c1e\r\nPort: {self.port}\r\nName: EV3\r\nProtocol: EV3\r\n"
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as sender:
            sender.setsockopt(socket.SOL_SOCKET, socket.SO_BROADCAST, 1)
            while True:
                with suppress(OSError):
                    # This fails without a network or listener, but a later attempt may succeed.
                    sender.sendto(text.encode(), beacon)
                if self._closed.wait(BEACON):
                    return

    def _serve(self) -> None:
        while not self._closed.is_set():
            with suppress(TimeoutError):
                client, _ = self._listener.accept()
                with client, suppress(OSError):
                    client.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
                    self._converse(client)

    def _converse(self, client: socket.socket) -> None:
        client.settimeout(0.1)
        # A stranger that says nothing must not keep the only place.
        greeting = self._receive(client, 100, monotonic() + GREETING)
        if b"ET /target?sn=" not in greeting:
            return
        client.sendall(b"Accept:EV340\r\n\r\n")
        buffer = b""
        while data := self._receive(client, 4096):
            replies, buffer = self._executed(buffer + data)
            client.sendall(replies)

    def _receive(self, client: socket.socket, most: int, until: float = math.inf) -> bytes:
        while not self._closed.is_set() and monotonic() < until:
            with suppress(TimeoutError):
                return client.recv(most)
        return b""

    def _serve_stream(self, file: int) -> None:
        buffer = b""
        with open(file, "r+b", buffering=0):
            while data := self._read(file):
                replies, buffer = self._executed(buffer + data)
                os.write(file, replies)

    def _serve_reports(self, file: int) -> None:
        buffer = b""
        with open(file, "r+b", buffering=0):
            while data := self._read(file):
                buffer += data
                # The report's number, which is 0, and the report.
                while len(buffer) > REPORT:
                    report, buffer = buffer[1 : 1 + REPORT], buffer[1 + REPORT :]
                    replies, _ = self._executed(report)
                    os.write(file, replies.ljust(REPORT, b"\0"))

    def _read(self, file: int) -> bytes:
        """Read the next data; empty at the end."""
        while not self._closed.is_set():
            ready, _, _ = select.select([file], [], [], 0.1)
            if ready:
                with suppress(OSError):
                    # Fails while the other end is not open.
                    return os.read(file, 4096)
                self._closed.wait(0.1)
        return b""

    def _executed(self, data: bytes) -> tuple[bytes, bytes]:
        """The replies to the complete messages in the data, and the rest of the data."""
        replies = b""
        while len(data) >= 2 and len(data) >= 2 + (size := int.from_bytes(data[:2], "little")):
            message, data = data[2 : 2 + size], data[2 + size :]
            with self._lock:
                reply = self.machine.execute(message)
            if reply:
                replies += len(reply).to_bytes(2, "little") + reply
        return replies, data
