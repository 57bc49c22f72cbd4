"""What carries direct commands: a connection of WiFi, a serial device of Bluetooth, or USB."""

import os
import select
import threading
from collections.abc import Callable
from pathlib import Path
from time import monotonic
from typing import Protocol, TypeVar

from learnblock.robots.ev3.brick import NoSuchWayError
from learnblock.robots.ev3.direct import LARGEST
from learnblock.robots.ev3.network import dial, hang_up

#: What opens LEGO's firmware to a client that has connected; it does not look at the serial number.
UNLOCK = b"GET /target?sn= VMTP1.0\r\nProtocol: EV3\r\n\r\n"
UNLOCKED = b"Accept:EV340\r\n\r\n"


#: Seconds in which a device must take a message.
LONGEST_WRITE = 1.0

Argument = TypeVar("Argument")
Result = TypeVar("Result")


class Wire(Protocol):
    """Carries whole messages without their length, in both directions."""

    def send(self, message: bytes) -> None:
        """Send a message, its length first.

        Raises:
            OSError: it cannot be sent.
        """

    def receive(self, patience: float) -> bytes:
        """The next message, without its length.

        Raises:
            OSError: nothing came within so many seconds, or the wire broke.
            ValueError: what came is no message.
        """

    def close(self) -> None:
        """Let go; who waits for a message is woken. It may be called twice."""


class Stream:
    """Bytes one after the other: a message is its length, in two bytes, and so many more."""

    def __init__(self) -> None:
        self._held = b""

    def send(self, message: bytes) -> None:
        self.write(message)

    def receive(self, patience: float) -> bytes:
        deadline = monotonic() + patience
        size = int.from_bytes(self.take(2, deadline), "little")
        if not 3 <= size <= LARGEST:
            raise ValueError(f"a message of {size} bytes")
        return self.take(size, deadline)

    def take(self, count: int, deadline: float) -> bytes:
        """So many bytes."""
        while len(self._held) < count:
            piece = self.read(LARGEST, deadline - monotonic())
            if not piece:
                raise ConnectionResetError("closed by the brick")
            self._held += piece
        data, self._held = self._held[:count], self._held[count:]
        return data

    def write(self, data: bytes) -> None:
        raise NotImplementedError

    def read(self, most: int, patience: float) -> bytes:
        raise NotImplementedError


class WiFi(Stream):
    """A connection to LEGO's firmware in the network.

    Raises:
        NoSuchWayError: no such firmware answers there.
    """

    def __init__(self, address: str, port: int, patience: float) -> None:
        super().__init__()
        self._socket = dial(address, port, patience)
        try:
            self._unlock(f"{address}:{port}", patience)
        except BaseException:
            self._socket.close()
            raise

    def write(self, data: bytes) -> None:
        self._socket.sendall(data)

    def read(self, most: int, patience: float) -> bytes:
        self._socket.settimeout(max(0.001, patience))
        return self._socket.recv(most)

    def close(self) -> None:
        hang_up(self._socket)

    def _unlock(self, where: str, patience: float) -> None:
        try:
            self.write(UNLOCK)
            said = self.take(len(UNLOCKED), monotonic() + patience)
        except OSError as error:
            raise NoSuchWayError(
                f"what listens at {where} does not answer as LEGO's firmware does; it serves one"
                " program at a time"
            ) from error
        if said != UNLOCKED:
            raise NoSuchWayError(f"what answers at {where} is not LEGO's firmware")


class DeviceFile(Stream):
    """A file of the system's that stands for a device: Bluetooth's serial port.

    Raises:
        NoSuchWayError: it cannot be opened.
    """

    def __init__(self, path: str) -> None:
        super().__init__()
        self._file = _opened(path)
        self._closed = False
        self._lock = threading.Lock()

    def write(self, data: bytes) -> None:
        deadline = monotonic() + LONGEST_WRITE
        while data:
            data = data[self._once(self._write, data, deadline) :]

    def read(self, most: int, patience: float) -> bytes:
        return self._once(self._read, most, monotonic() + patience)

    def close(self) -> None:
        with self._lock:
            if not self._closed:
                self._closed = True
                os.close(self._file)

    def _once(
        self, attempt: Callable[[Argument, float], Result | None], what: Argument, deadline: float
    ) -> Result:
        """Attempt it until it succeeds; between two attempts the file may be closed."""
        while True:
            with self._lock:
                if self._closed:
                    raise ConnectionAbortedError("closed here")
                result = attempt(what, min(0.05, max(0.0, deadline - monotonic())))
            if result is not None:
                return result
            if monotonic() > deadline:
                raise TimeoutError("the device is silent")

    def _read(self, most: int, seconds: float) -> bytes | None:
        ready, _, _ = select.select([self._file], [], [], seconds)
        return os.read(self._file, most) if ready else None

    def _write(self, data: bytes, seconds: float) -> int | None:
        _, ready, _ = select.select([], [self._file], [], seconds)
        return os.write(self._file, data) if ready else None


class Usb(DeviceFile):
    """A brick on a USB cable, as Linux's hidraw offers it: reports of 1024 bytes."""

    def send(self, message: bytes) -> None:
        # The number of the report goes first; the brick's have none, which is 0.
        self.write(b"\0" + message.ljust(LARGEST, b"\0"))

    def receive(self, patience: float) -> bytes:
        report = self.take(LARGEST, monotonic() + patience)
        size = int.from_bytes(report[:2], "little")
        if not 3 <= size <= LARGEST - 2:
            raise ValueError(f"a message of {size} bytes")
        return report[2 : 2 + size]


def open_wire(device: str, address: str, port: int, patience: float) -> Wire:
    """The wire to a brick: a device's file where one is named, or else WiFi.

    Raises:
        NoSuchWayError: nobody is there.
    """
    if not device:
        return WiFi(address, port, patience)
    return Usb(device) if Path(device).name.startswith("hidraw") else DeviceFile(device)


def _opened(path: str) -> int:
    try:
        import tty  # noqa: PLC0415 - Windows has none
    except ImportError:
        raise NoSuchWayError(
            "this system reaches LEGO's firmware by WiFi alone: leave `device` empty"
        ) from None
    try:
        file = os.open(path, os.O_RDWR | os.O_NOCTTY | os.O_NONBLOCK)
        if os.isatty(file):
            # Bytes as they are, and no line ends made of them.
            tty.setraw(file)
    except OSError as error:
        raise NoSuchWayError(f"the device {path} cannot be opened: {error.strerror}") from error
    return file
