"""The packets of iRobot's education robots, over Bluetooth in both directions.

    device  command  number  payload, 16 bytes  checksum

An answer has the number of its request. Integers of several bytes are big endian.
"""

from typing import NamedTuple, Self

SIZE = 20
PAYLOAD = 16
#: The polynomial of the checksum, a CRC-8 that begins with 0.
_POLYNOMIAL = 0x07


class Packet(NamedTuple):
    """A packet.

    Args:
        device: the part of the robot, such as its motors.
        command: what it should do, or has done.
        number: counts the packets of one direction, from 0 to 255 and again from 0.
        payload: at most 16 bytes; zeros follow.
    """

    device: int
    command: int
    number: int
    payload: bytes = b""

    @classmethod
    def parsed(cls, data: bytes) -> Self:
        """The packet that these bytes are.

        Raises:
            ValueError: they are none.
        """
        if len(data) != SIZE or checksum(data[:-1]) != data[-1]:
            raise ValueError("that is no packet")
        return cls(data[0], data[1], data[2], bytes(data[3:-1]))

    @property
    def encoded(self) -> bytes:
        """Its bytes."""
        head = bytes((self.device, self.command, self.number))
        content = head + self.payload.ljust(PAYLOAD, b"\0")
        return content + bytes((checksum(content),))


def checksum(data: bytes) -> int:
    """The last byte of a packet, from those before it."""
    value = 0
    for byte in data:
        value = _TABLE[value ^ byte]
    return value


def _divided(byte: int) -> int:
    """The remainder of a byte."""
    for _ in range(8):
        byte = (byte << 1 ^ _POLYNOMIAL if byte & 0x80 else byte << 1) & 0xFF
    return byte


_TABLE = bytes(map(_divided, range(256)))
