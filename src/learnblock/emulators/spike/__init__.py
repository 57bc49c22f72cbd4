"""Emulates a SPIKE hub with Pybricks: its services, and programs that run in a real MicroPython."""

import struct
import threading
from collections.abc import Mapping
from typing import Any

from learnblock.emulators.gatt import (
    NOT_ALLOWED,
    NOT_SUPPORTED,
    GattError,
    GattServer,
    Notify,
    Services,
)
from learnblock.emulators.spike.devices import LEFT, RIGHT, HubDevices
from learnblock.emulators.spike.program import HubProgram, micropython
from learnblock.emulators.twin import Twin
from learnblock.emulators.vehicle import Vehicle
from learnblock.robots.spike import profile
from learnblock.robots.spike.profile import Capability, HubCommand, HubEvent, HubStatus

#: Errors of Pybricks' protocol.
INVALID_COMMAND, BUSY = 0x80, 0x81
#: What the firmware says of itself; the largest command is 3 bytes less than its
#: PBDRV_CONFIG_BLUETOOTH_MAX_MTU_SIZE.
PROTOCOL, LARGEST, LARGEST_PROGRAM = "1.4.0", 512, 250_000
#: The hub's name, as it leaves the factory.
NAME = "Pybricks Hub"
_DEVICE_INFORMATION = "0000180a-0000-1000-8000-00805f9b34fb"


class EmulatedHub:
    """The hub as seen by Bluetooth.

    Args:
        devices: its motors and sensors.
    """

    name = NAME
    largest = LARGEST
    manufacturer: Mapping[int, bytes] = {}
    services: Services = {  # noqa: RUF012 - never changed
        profile.SERVICE: {
            profile.COMMAND_EVENT: ["write", "notify"],
            profile.CAPABILITIES: ["read"],
        },
        _DEVICE_INFORMATION: {profile.SOFTWARE_REVISION: ["read"]},
    }

    def __init__(self, devices: HubDevices) -> None:
        self.devices = devices
        self._lock = threading.RLock()
        self._memory = bytearray(LARGEST_PROGRAM)
        self._size = 0
        self._program: HubProgram | None = None
        self._notify: Notify | None = None
        self._commands = {
            HubCommand.STOP_PROGRAM: self._stop,
            HubCommand.START_PROGRAM: self._start,
            HubCommand.WRITE_PROGRAM_SIZE: self._write_size,
            HubCommand.WRITE_PROGRAM: self._write_program,
            HubCommand.WRITE_STDIN: self._write_stdin,
        }

    def connected(self, notify: Notify) -> None:
        self._notify = notify

    def heard(self, uuid: str) -> None:
        del uuid
        self._report()

    def disconnected(self) -> None:
        """Let the client go; the program runs on, as on a real hub."""
        self._notify = None

    def read(self, uuid: str) -> bytes:
        if uuid == profile.SOFTWARE_REVISION:
            return PROTOCOL.encode()
        if uuid == profile.CAPABILITIES:
            flags = Capability.PROGRAM_OF_SEVERAL_FILES
            return struct.pack("<HII", LARGEST, flags, LARGEST_PROGRAM)
        raise GattError(NOT_SUPPORTED)

    def write(self, uuid: str, value: bytes) -> None:
        if uuid != profile.COMMAND_EVENT or not value or len(value) > LARGEST:
            raise GattError(NOT_SUPPORTED)
        if value[0] not in self._commands:
            raise GattError(INVALID_COMMAND)
        try:
            self._commands[HubCommand(value[0])](value[1:])
        except struct.error:
            raise GattError(INVALID_COMMAND) from None

    @property
    def runs(self) -> bool:
        """Whether a program runs."""
        return self._program is not None

    def press_button(self) -> None:
        """End its program, as the hub's button does."""
        self._stop(b"")

    def close(self) -> None:
        """End its program."""
        self._stop(b"")

    def _stop(self, _: bytes) -> None:
        program = self._program
        if program:
            program.close()

    def _start(self, _: bytes) -> None:
        with self._lock:
            self._require_idle()
            code = bytes(self._memory[: self._size])
            # The size, the name and a zero byte precede what mpy-cross made.
            (size,) = struct.unpack_from("<I", code)
            begin = code.index(b"\0", 4) + 1
            self._program = HubProgram(
                code[begin : begin + size], self.devices, self._print, self._end
            )
            self._report()

    def _write_size(self, payload: bytes) -> None:
        self._require_idle()
        (size,) = struct.unpack("<I", payload)
        if size > LARGEST_PROGRAM:
            raise GattError(NOT_ALLOWED)
        self._size = size

    def _write_program(self, payload: bytes) -> None:
        self._require_idle()
        (offset,) = struct.unpack_from("<I", payload)
        if offset + len(payload) - 4 > LARGEST_PROGRAM:
            raise GattError(NOT_ALLOWED)
        self._memory[offset : offset + len(payload) - 4] = payload[4:]

    def _write_stdin(self, payload: bytes) -> None:
        if self._program:
            self._program.type(payload)

    def _require_idle(self) -> None:
        if self._program:
            raise GattError(BUSY)

    def _print(self, text: bytes) -> None:
        size = LARGEST - 1
        for begin in range(0, len(text), size):
            self._send(bytes([HubEvent.WRITE_STDOUT]) + text[begin : begin + size])

    def _end(self) -> None:
        with self._lock:
            self._program = None
            self.devices.rest()
            self._report()

    def _report(self) -> None:
        flags = HubStatus.PROGRAM_RUNNING if self._program else HubStatus(0)
        self._send(struct.pack("<BI", HubEvent.STATUS, flags))

    def _send(self, event: bytes) -> None:
        notify = self._notify
        if notify:
            notify(profile.COMMAND_EVENT, event)


class Emulator:
    """A hub with two motors and three sensors.

    Args:
        twin: the robot that it drives.
        address: the local address on which it listens.
        port: its port; a free one by default.

    Attributes:
        settings: the settings with which a client reaches it.
        hub: the emulated hub.

    Raises:
        MissingPackageError: MicroPython is not installed.
    """

    def __init__(self, twin: Twin, *, address: str = "127.0.0.1", port: int = 0) -> None:
        # Before anybody connects.
        micropython()
        self.hub = EmulatedHub(HubDevices(Vehicle(twin, LEFT, RIGHT)))
        self._server = GattServer(self.hub, address, port)
        self.settings: Mapping[str, Any] = {"address": f"{address}:{self._server.port}"}

    def close(self) -> None:
        self.hub.close()
        self._server.close()
