"""Looks for Thymios at serial ports, in Thymio Suite and in simulators."""

from collections.abc import Iterator, Mapping
from contextlib import suppress
from typing import Any

from learnblock.errors import RobotConnectionError
from learnblock.robots.real import require
from learnblock.robots.thymio.settings import ThymioSettings
from learnblock.robots.thymio.wires import TcpWire
from learnblock.timing import MONOTONIC, Deadline, SteadyClock

#: USB ids (vendor, product) of the robot and of its radio's dongle.
USB_IDS = frozenset({(0x0617, 0x000A), (0x0617, 0x000C)})


def serial_devices() -> list[str]:
    """The serial ports at which a Thymio or its dongle is plugged in."""
    ports = require("serial.tools.list_ports", "thymio").comports()
    return sorted(port.device for port in ports if (port.vid, port.pid) in USB_IDS)


def listens(address: str, port: int, seconds: float) -> bool:
    """Whether a program is listening there."""
    with suppress(RobotConnectionError):
        TcpWire(address, port, seconds).close()
        return True
    return False


def choose(settings: ThymioSettings) -> str:
    """The connection to use, suite, serial or tcp; chosen here if the setting is ``auto``."""
    if settings.connection != "auto":
        return settings.connection
    # While Thymio Suite runs, the cable belongs to it.
    if listens("127.0.0.1", settings.suite_port, 1.0):
        return "suite"
    return "serial" if settings.device or serial_devices() else "tcp"


def scan(
    settings: ThymioSettings, seconds: float, clock: SteadyClock = MONOTONIC
) -> Iterator[Mapping[str, Any]]:
    """Yield the settings for reaching each Thymio found.

    A simulator serves one program at a time, and drops that program when it is scanned.
    """
    until = Deadline.after(seconds, clock)
    for device in serial_devices():
        yield {"connection": "serial", "device": device}
    for kind, address, port in (
        ("suite", "127.0.0.1", settings.suite_port),
        ("tcp", settings.address, settings.port),
    ):
        if not until.is_over and listens(address, port, until.left):
            place = {"suite_port": port} if kind == "suite" else {"address": address, "port": port}
            yield {"connection": kind, **place}
