"""Looks for bricks on the network, on cables and over Bluetooth."""

import re
import socket
from collections.abc import Callable, Iterator, Mapping
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

from learnblock.errors import LearnBlockError, RobotNotFoundError
from learnblock.robots import settings as user_settings
from learnblock.robots.ev3 import lines
from learnblock.robots.ev3.network import dial
from learnblock.robots.ev3.settings import Settings
from learnblock.timing import MONOTONIC, Deadline, SteadyClock

Found = Mapping[str, Any]

#: The UDP port to which LEGO's firmware sends a beacon every few seconds.
BEACONS = 3015
#: The kernel's id of LEGO's brick: bus, vendor, product.
USB_ID = re.compile(r"^HID_ID=0003:00000694:00000005$", re.MULTILINE)
_BEACON = re.compile(
    rb"Serial-Number: (?P<serial>\w{1,32})\r\nPort: (?P<port>\d{1,5})\r\n"
    rb"Name: [^\r\n]{0,64}\r\nProtocol: EV3\r\n"
)


def scan(seconds: float) -> Iterator[Found]:
    """Yield the settings that reach each brick found.

    Args:
        seconds: the time limit.
    """
    looks: tuple[Callable[[float], Iterator[Found]], ...] = (_ev3dev, beacons, _devices)
    with ThreadPoolExecutor(len(looks)) as pool:
        for bricks in pool.map(lambda look: list(look(seconds)), looks):
            yield from bricks


def beacons(seconds: float, port: int = BEACONS, clock: SteadyClock = MONOTONIC) -> Iterator[Found]:
    """The bricks with LEGO's firmware that send a beacon within a time limit."""
    deadline = Deadline.after(seconds, clock)
    addresses = set()
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as ear:
        ear.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        try:
            ear.bind(("", port))
        except OSError:
            # Another program receives the beacons.
            return
        while not deadline.is_over:
            ear.settimeout(max(deadline.left, 0.001))
            try:
                data, (address, _) = ear.recvfrom(1024)
            except TimeoutError:
                return
            direct_port = read_beacon(data)
            if direct_port and address not in addresses:
                addresses.add(address)
                yield {"connection": "direct", "address": address, "direct_port": direct_port}


def read_beacon(data: bytes) -> int | None:
    """The port in a beacon; None if it does not come from an EV3."""
    beacon = _BEACON.match(data)
    port = int(beacon["port"]) if beacon else 0
    return port if 0 < port < 65536 else None


def _ev3dev(seconds: float) -> Iterator[Found]:
    """The bricks at the address in the settings and at the default address."""
    try:
        settings = user_settings.load("ev3", Settings)
    except LearnBlockError:
        # Invalid settings are reported when they are used.
        settings = Settings()
    addresses = {settings.address, Settings().address}
    for address in sorted(addresses):
        timeout = seconds / len(addresses) / 2
        if _is_agent(address, settings.agent_port, timeout):
            yield {"connection": "agent", "address": address}
        elif _listens(address, settings.rpyc_port, timeout):
            yield {"connection": "rpyc", "address": address}


def _is_agent(address: str, port: int, timeout: float) -> bool:
    try:
        with dial(address, port, timeout) as connection:
            return bool(lines.greeting(connection.recv(lines.LONGEST_LINE)))
    except (OSError, ValueError):
        return False


def _listens(address: str, port: int, timeout: float) -> bool:
    try:
        dial(address, port, timeout).close()
    except RobotNotFoundError:
        return False
    return True


def _devices(seconds: float) -> Iterator[Found]:
    """Bricks on a cable, and Bluetooth's serial ports."""
    del seconds
    names = [
        file.parents[1].name
        for file in sorted(Path("/sys/class/hidraw").glob("*/device/uevent"))
        if _is_brick(file)
    ]
    names += [file.name for file in sorted(Path("/dev").glob("rfcomm[0-9]*"))]
    for name in names:
        yield {"connection": "direct", "device": f"/dev/{name}"}


def _is_brick(file: Path) -> bool:
    try:
        return bool(USB_ID.search(file.read_text("utf-8", "replace")))
    except OSError:
        # Its cable has just been unplugged.
        return False
