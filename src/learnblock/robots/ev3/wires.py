"""Connections that carry direct commands: Wi-Fi, a serial device of Bluetooth, or USB."""

import os
import select
import threading
from collections.abc import Callable
from pathlib import Path
from typing import Protocol, TypeVar

from learnblock.errors import RobotNotFoundError
from learnblock.robots.ev3.direct import LARGEST
from learnblock.robots.ev3.network import dial, hang_up
from learnblock.timing import MONOTONIC, Deadline, SteadyClock

#: The request that unlocks LEGO's firmware for a client; it ignores the serial number.
UNLOCK = b"GET /target?sn= VMTP1.0\r\nProtocol: EV3\r\n\r\n"
UNLOCKED = b"Accept:EV340\r\n\r\n"


#: Seconds within which a device must accept a message.
LONGEST_WRITE = 1.0

Argument = TypeVar("Argument")
Result = TypeVar("Result")


class Wire(Protocol):
    """Carries whole messages without their length, in both directions."""

    def send(self, message: bytes) -> None:
        """Send a message, its length first.

        Raises:
            OSError: sending fails.
        """

    def receive(self, timeout: float) -> bytes:
        """The next message, without its length.

        Raises:
            OSError: nothing arrived within `timeout` seconds, or the connection broke.
            ValueError: the data is not a message.
        """

    def close(self) -> None:
        """Close it and wake up waiting threads; calling it twice is harmless."""


class Stream:
    """A stream of bytes: each message starts with its length in two bytes.

    Args:
        clock: the clock of its limits.
    """

    def __init__(self, clock: SteadyClock = MONOTONIC) -> None:
        self._clock = clock
        self._held = b""

    def send(self, message: bytes) -> None:
        self.write(message)

    def receive(self, timeout: float) -> bytes:
        deadline = Deadline.after(timeout, self._clock)
        size = int.from_bytes(self.take(2, deadline), "little")
        if not 3 <= size <= LARGEST:
            raise ValueError(f"a message of {size} bytes")
        return self.take(size, deadline)

    def take(self, count: int, deadline: Deadline) -> bytes:
        """Receive this many bytes."""
        while len(self._held) < count:
            piece = self.read(LARGEST, deadline.left)
            if not piece:
                raise ConnectionResetError("closed by the brick")
            self._held += piece
        data, self._held = self._held[:count], self._held[count:]
        return data

    def write(self, data: bytes) -> None:
        raise NotImplementedError

    def read(self, most: int, timeout: float) -> bytes:
        raise NotImplementedError


class WiFi(Stream):
    """A connection to LEGO's firmware over Wi-Fi.

    Raises:
        RobotNotFoundError: no such firmware answers there.
    """

    def __init__(
        self, address: str, port: int, timeout: float, clock: SteadyClock = MONOTONIC
    ) -> None:
        super().__init__(clock)
        self._socket = dial(address, port, timeout, clock)
        try:
            self._unlock(f"{address}:{port}", timeout)
        except BaseException:
            self._socket.close()
            raise

    def write(self, data: bytes) -> None:
        self._socket.sendall(data)

    def read(self, most: int, timeout: float) -> bytes:
        self._socket.settimeout(max(0.001, timeout))
        return self._socket.recv(most)

    def close(self) -> None:
        hang_up(self._socket)

    def _unlock(self, place: str, timeout: float) -> None:
        try:
            self.write(UNLOCK)
            answer = self.take(len(UNLOCKED), Deadline.after(timeout, self._clock))
        except OSError as error:
            raise RobotNotFoundError("ev3-firmware-silent", place=place) from error
        if answer != UNLOCKED:
            raise RobotNotFoundError("ev3-not-firmware", place=place)


class DeviceFile(Stream):
    """A device file of the operating system: Bluetooth's serial port.

    Raises:
        RobotNotFoundError: it cannot be opened.
    """

    def __init__(self, path: str, clock: SteadyClock = MONOTONIC) -> None:
        super().__init__(clock)
        self._file = _opened(path)
        self._closed = False
        self._lock = threading.Lock()

    def write(self, data: bytes) -> None:
        deadline = Deadline.after(LONGEST_WRITE, self._clock)
        while data:
            data = data[self._once(self._write, data, deadline) :]

    def read(self, most: int, timeout: float) -> bytes:
        return self._once(self._read, most, Deadline.after(timeout, self._clock))

    def close(self) -> None:
        with self._lock:
            if not self._closed:
                self._closed = True
                os.close(self._file)

    def _once(
        self,
        attempt: Callable[[Argument, float], Result | None],
        what: Argument,
        deadline: Deadline,
    ) -> Result:
        """Retry until it succeeds; another thread may close the file between attempts."""
        while True:
            with self._lock:
                if self._closed:
                    raise ConnectionAbortedError("the device was closed")
                result = attempt(what, min(0.05, deadline.left))
            if result is not None:
                return result
            if deadline.is_over:
                raise TimeoutError("the device is silent")

    def _read(self, most: int, seconds: float) -> bytes | None:
        ready, _, _ = select.select([self._file], [], [], seconds)
        return os.read(self._file, most) if ready else None

    def _write(self, data: bytes, seconds: float) -> int | None:
        _, ready, _ = select.select([], [self._file], [], seconds)
        return os.write(self._file, data) if ready else None


class Usb(DeviceFile):
    """A brick on a USB cable, through Linux's hidraw: reports of 1024 bytes."""

    def send(self, message: bytes) -> None:
        # The report's number comes first; the brick uses no numbers, which is 0.
        self.write(b"\0" + message.ljust(LARGEST, b"\0"))

    def receive(self, timeout: float) -> bytes:
        report = self.take(LARGEST, Deadline.after(timeout, self._clock))
        size = int.from_bytes(report[:2], "little")
        if not 3 <= size <= LARGEST - 2:
            raise ValueError(f"a message of {size} bytes")
        return report[2 : 2 + size]


def open_wire(
    device: str, address: str, port: int, timeout: float, clock: SteadyClock = MONOTONIC
) -> Wire:
    """Open the device if one is given, else a Wi-Fi connection.

    Raises:
        RobotNotFoundError: no brick answers.
    """
    if not device:
        return WiFi(address, port, timeout, clock)
    kind = Usb if Path(device).name.startswith("hidraw") else DeviceFile
    return kind(device, clock)


def _opened(path: str) -> int:
    try:
        import tty  # noqa: PLC0415 - missing on Windows
    except ImportError:
        raise RobotNotFoundError("ev3-no-device-files") from None
    try:
        file = os.open(path, os.O_RDWR | os.O_NOCTTY | os.O_NONBLOCK)
        if os.isatty(file):
            # No conversion of line endings.
            tty.setraw(file)
    except OSError as error:
        raise RobotNotFoundError(
            "ev3-device-closed", device=path, reason=error.strerror or str(error)
        ) from error
    return file
