"""Pybricks' own messages over Bluetooth Low Energy.

Source: github.com/pybricks/technical-info, pybricks-ble-profile.md, protocol 1.3 and later. A hub
has one characteristic for commands, which are written with a response, and for events, which it
notifies; another one says what it is capable of.
"""

import struct
from collections.abc import Iterator
from enum import IntEnum, IntFlag
from typing import NamedTuple

SERVICE = "c5f50001-8280-46da-89f4-6d8051e4aeef"
COMMAND_EVENT = "c5f50002-8280-46da-89f4-6d8051e4aeef"
CAPABILITIES = "c5f50003-8280-46da-89f4-6d8051e4aeef"
#: The version of the protocol, in Bluetooth's Device Information Service.
SOFTWARE_REVISION = "00002a28-0000-1000-8000-00805f9b34fb"
#: The oldest protocol with standard input and output.
OLDEST = (1, 3)


class HubCommand(IntEnum):
    """The first byte of what is written."""

    STOP_PROGRAM = 0
    START_PROGRAM = 1
    WRITE_PROGRAM_SIZE = 3
    WRITE_PROGRAM = 4
    WRITE_STDIN = 6


class HubEvent(IntEnum):
    """The first byte of what is notified."""

    STATUS = 0
    WRITE_STDOUT = 1


class HubStatus(IntFlag):
    """What a hub reports of itself."""

    BATTERY_LOW = 1 << 0
    PROGRAM_RUNNING = 1 << 6


class Capability(IntFlag):
    """What a hub can do."""

    PROGRAM_OF_SEVERAL_FILES = 1 << 1


class Capabilities(NamedTuple):
    """What a hub says of itself.

    Args:
        largest_write: the maximum number of bytes of a command.
        flags: what it can do.
        largest_program: the maximum number of bytes of a program.
        slots: how many programs it keeps; 0 before protocol 1.5.
    """

    largest_write: int
    flags: Capability
    largest_program: int
    slots: int

    @classmethod
    def parsed(cls, data: bytes) -> "Capabilities":
        """Parse the characteristic's value.

        Raises:
            ValueError: it is too short.
        """
        if len(data) < 10:
            raise ValueError("the hub's capabilities are incomplete")
        largest_write, flags, largest_program = struct.unpack_from("<HII", data)
        slots = data[10] if len(data) > 10 else 0
        return cls(largest_write, Capability(flags), largest_program, slots)


def version(text: str) -> tuple[int, int]:
    """The protocol's version, such as ``1.4.0``.

    Raises:
        ValueError: it is none.
    """
    major, minor, *_ = text.split(".")
    return int(major), int(minor)


def status(event: bytes) -> HubStatus:
    """The flags of a status event.

    Raises:
        ValueError: it is too short.
    """
    if len(event) < 5:
        raise ValueError("the hub's status is incomplete")
    return HubStatus(struct.unpack_from("<I", event, 1)[0])


def packed(name: str, program: bytes) -> bytes:
    """A program of one file, as a hub stores it: its size, its name, and what mpy-cross made."""
    return struct.pack("<I", len(program)) + name.encode() + b"\0" + program


def uploading(program: bytes, largest_write: int) -> Iterator[bytes]:
    """The commands that store a program; while it is incomplete, its size is 0."""
    yield struct.pack("<BI", HubCommand.WRITE_PROGRAM_SIZE, 0)
    size = largest_write - 5
    for offset in range(0, len(program), size):
        yield struct.pack("<BI", HubCommand.WRITE_PROGRAM, offset) + program[offset : offset + size]
    yield struct.pack("<BI", HubCommand.WRITE_PROGRAM_SIZE, len(program))


def starting(slots: int) -> bytes:
    """The command that starts the program that was stored."""
    slot = bytes([0]) if slots else b""
    return bytes([HubCommand.START_PROGRAM]) + slot


def typing(text: bytes, largest_write: int) -> Iterator[bytes]:
    """The commands that write to a program's standard input."""
    size = largest_write - 1
    for offset in range(0, len(text), size):
        yield bytes([HubCommand.WRITE_STDIN]) + text[offset : offset + size]
