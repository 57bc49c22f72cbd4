"""Where emulated robots are, and the lines in which bleak's back end speaks with them.

The emulator (`learnblock.emulators.gatt`) sends one line of JSON with the robot's services, then
one for each answer and each notification; `loopback_client` sends one for each request. Values are
hexadecimal.

    {"name": "Pybricks Hub", "largest": 509, "manufacturer": {"919": "00"},
     "services": {"c5f5...": {"c5f5...": ["read"]}}}
    {"write": "c5f5...", "value": "0601"}
    {"done": true}            or {"value": "3401"}, or {"error": 129}, an error of Bluetooth's
    {"notify": "c5f5...", "value": "0073"}

A second client of this computer can share the connection, as its Bluetooth allows: it sends
``{"share": true}`` first.
"""

import json
import socket
from contextlib import suppress
from typing import Any

#: Where `learnblock emulate` listens, unless another emulator already does.
HOME = "127.0.0.1:18816"
#: The maximum number of bytes of a line.
LONGEST_LINE = 65536
#: Seconds for an emulator on this computer to answer.
_SOON = 0.5


def is_address(address: str) -> bool:
    """Whether an address is that of an emulator."""
    host, _, port = address.rpartition(":")
    return host == "127.0.0.1" and port.isdecimal()


def place(address: str) -> tuple[str, int]:
    """The host and the port of an emulator."""
    host, _, port = address.rpartition(":")
    return host, int(port)


def greeting(address: str) -> dict[str, Any]:
    """What an emulated robot says of itself; empty if none is there, or free."""
    with suppress(OSError, ValueError), socket.create_connection(place(address), _SOON) as probe:
        probe.settimeout(_SOON)
        with probe.makefile("rb") as lines:
            words = json.loads(lines.readline(LONGEST_LINE))
            return words if isinstance(words, dict) else {}
    return {}


def advertised(greeting: dict[str, Any], service: str) -> dict[int, bytes] | None:
    """The manufacturer's data in a greeting, by the manufacturer; None without the service."""
    if service not in greeting.get("services", {}):
        return None
    data = greeting.get("manufacturer", {}).items()
    return {int(maker): bytes.fromhex(value) for maker, value in data}
