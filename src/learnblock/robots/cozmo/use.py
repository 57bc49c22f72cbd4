"""Tells programs on this computer whether one of them uses a Cozmo.

A Cozmo ends its conversation when any program greets it, so looking for it would disturb the
program that uses it. That program keeps a UDP port of this computer, which the system frees
when the program ends in any way. Programs without LearnBlock, and other computers, can't be seen.
"""

import socket
from contextlib import suppress
from zlib import crc32

_FIRST_PORT, _PORTS = 20_000, 12_000
"""The ports, below those that systems give to programs that ask for any."""
_HERE = "127.0.0.1"


class Use:
    """Marks a Cozmo as in use, from its creation to `end`.

    If another program marks it already, this program does not: the robot has changed its user.

    Args:
        address: the robot's host name or IP address.
        port: its UDP port.
    """

    def __init__(self, address: str, port: int) -> None:
        self._socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        with suppress(OSError):
            self._socket.bind((_HERE, _port(address, port)))

    def end(self) -> None:
        """The robot is free; calling it twice is harmless."""
        self._socket.close()


def is_used(address: str, port: int) -> bool:
    """Whether a program on this computer uses the robot with this address."""
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as probe:
        try:
            probe.bind((_HERE, _port(address, port)))
        except OSError:
            return True
    return False


def _port(address: str, port: int) -> int:
    return _FIRST_PORT + crc32(f"cozmo {address}:{port}".encode()) % _PORTS
