"""The datagrams of Cozmo's protocol, as the robot reads and writes them.

A frame is a header and packets. Packets that must arrive have sequence numbers, 1 to 65534, of
which the header tells the first and the last; its ``ack`` is the number of the last packet that
arrived in order. 0 stands for none. (pycozmo's description of the protocol, docs/protocol.md)
"""

import struct
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from enum import IntEnum
from typing import Any

from pycozmo import protocol_encoder as packets

from learnblock.errors import LearnBlockError

MAGIC = b"COZ\x03RE\x01"
LAST_SEQUENCE = 0xFFFE
"""The number after it is 1 again."""
MOST_PAYLOAD = 1037
"""Bytes of packets in a frame; the robot drops a longer one (pycozmo.protocol_declaration)."""

_HEADER = struct.Struct("<7sBHHH")
_PACKET = struct.Struct("<BH")


class FrameError(LearnBlockError, ValueError):
    """A datagram is no frame of this protocol."""


class FrameKind(IntEnum):
    """What a frame carries."""

    RESET = 0x01
    GOODBYE = 0x03
    ACTION = 0x04
    FROM_ENGINE = 0x07
    FROM_ROBOT = 0x09
    PING = 0x0B


class PacketKind(IntEnum):
    """What a packet is; from `EVENT` on they have no number and may get lost."""

    CONNECT = 0x02
    DISCONNECT = 0x03
    COMMAND = 0x04
    EVENT = 0x05
    KEYFRAME = 0x0A
    PING = 0x0B


@dataclass(frozen=True, slots=True)
class Frame:
    """What a datagram said.

    Args:
        kind: of the frame.
        ack: the number of the last packet that the sender got in order, or 0.
        packets: each with its number, or 0; a packet of an unknown kind is None.
    """

    kind: FrameKind
    ack: int
    packets: tuple[tuple[int, Any], ...] = ()


def following(sequence: int) -> int:
    """The number after this one."""
    return sequence % LAST_SEQUENCE + 1


def decoded(datagram: bytes) -> Frame:
    """Read a datagram.

    Raises:
        FrameError: it is none of this protocol.
    """
    if len(datagram) < _HEADER.size:
        raise FrameError(f"{len(datagram)} bytes are too few for a frame")
    magic, number, first, _, ack = _HEADER.unpack_from(datagram)
    if magic != MAGIC:
        raise FrameError(f"a frame does not begin with {magic!r}")
    if number not in FrameKind.__members__.values():
        raise FrameError(f"there is no frame of type {number}")
    kind, payload = FrameKind(number), datagram[_HEADER.size :]
    if len(payload) > MOST_PAYLOAD:
        raise FrameError(f"{len(payload)} bytes of packets are more than {MOST_PAYLOAD}")
    return Frame(kind, ack, tuple(_numbered(first, _packets(kind, payload))))


def encoded(ack: int, first: int, contents: Sequence[Any]) -> bytes:
    """A frame of the robot.

    Args:
        ack: the number of the last packet that arrived in order.
        first: the number of the first packet that has one; 0 where none has.
        contents: packets in their order.
    """
    count = sum(not packet.is_oob() for packet in contents)
    last = first
    for _ in range(count - 1):
        last = following(last)
    header = _HEADER.pack(MAGIC, FrameKind.FROM_ROBOT, first, last, ack)
    return header + b"".join(map(_encoded_packet, contents))


def _numbered(first: int, found: Iterator[tuple[int, Any]]) -> Iterator[tuple[int, Any]]:
    number = first
    for kind, packet in found:
        if kind >= PacketKind.EVENT:
            yield 0, packet
        else:
            yield number, packet
            number = following(number)


def _packets(kind: FrameKind, payload: bytes) -> Iterator[tuple[int, Any]]:
    """Each packet with its kind."""
    if kind is FrameKind.PING:
        yield PacketKind.PING, _packet(PacketKind.PING, payload)
    elif kind is FrameKind.ACTION:
        yield PacketKind.COMMAND, _packet(PacketKind.COMMAND, payload)
    elif kind in {FrameKind.FROM_ENGINE, FrameKind.FROM_ROBOT}:
        yield from _packed(payload)


def _packed(payload: bytes) -> Iterator[tuple[int, Any]]:
    while payload:
        if len(payload) < _PACKET.size:
            raise FrameError("a packet ends in its header")
        kind, length = _PACKET.unpack_from(payload)
        content, payload = payload[_PACKET.size :][:length], payload[_PACKET.size + length :]
        if len(content) < length:
            raise FrameError(f"a packet of {length} bytes ends after {len(content)}")
        yield kind, _packet(kind, content)


def _packet(kind: int, content: bytes) -> Any:
    """The packet, by pycozmo's codec; None where that knows no such packet."""
    of_its_own = {
        PacketKind.CONNECT: packets.Connect,
        PacketKind.DISCONNECT: packets.Disconnect,
        PacketKind.KEYFRAME: packets.Keyframe,
        PacketKind.PING: packets.Ping,
    }
    if kind in {PacketKind.COMMAND, PacketKind.EVENT}:
        codec = packets.PACKETS_BY_ID.get(content[0]) if content else None
        content = content[1:]
    else:
        codec = of_its_own.get(kind)  # type: ignore[call-overload] # any number may come
    if codec is None:
        return None
    try:
        return codec.from_bytes(content)
    except (IndexError, ValueError, struct.error) as error:
        raise FrameError(f"a packet {codec.__name__} cannot be read: {error}") from error


def _encoded_packet(packet: Any) -> bytes:
    content: bytes = packet.to_bytes()
    if packet.type.value in {PacketKind.COMMAND, PacketKind.EVENT}:
        content = bytes((packet.id,)) + content
    return _PACKET.pack(packet.type.value, len(content)) + content
