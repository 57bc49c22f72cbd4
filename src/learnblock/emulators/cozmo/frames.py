"""Read and write the datagrams of Cozmo's protocol on the robot's side.

A frame is a header and packets. Packets that must arrive have sequence numbers from 1 to 65534. The
header contains the first and the last one; its ``ack`` is the number of the last packet received in
order. 0 means none. (pycozmo's description of the protocol, docs/protocol.md)
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
"""The maximum bytes of packets in a frame (pycozmo.protocol_declaration)."""

_HEADER = struct.Struct("<7sBHHH")
_PACKET = struct.Struct("<BH")


class DatagramError(LearnBlockError, ValueError):
    """A datagram is not a frame of this protocol, so the robot ignores it."""


class FrameKind(IntEnum):
    """The kind of a frame."""

    RESET = 0x01
    GOODBYE = 0x03
    ACTION = 0x04
    FROM_ENGINE = 0x07
    FROM_ROBOT = 0x09
    PING = 0x0B


class PacketKind(IntEnum):
    """The kind of a packet; those from `EVENT` on have no number and may get lost."""

    CONNECT = 0x02
    DISCONNECT = 0x03
    COMMAND = 0x04
    EVENT = 0x05
    KEYFRAME = 0x0A
    PING = 0x0B


@dataclass(frozen=True, slots=True)
class Datagram:
    """The contents of a datagram.

    Args:
        kind: the kind of the frame.
        ack: the number of the last packet that the sender received in order, or 0.
        packets: each packet with its number or 0; a packet of an unknown kind is None.
    """

    kind: FrameKind
    ack: int
    packets: tuple[tuple[int, Any], ...] = ()


def following(sequence: int) -> int:
    """The next sequence number."""
    return sequence % LAST_SEQUENCE + 1


def decoded(datagram: bytes) -> Datagram:
    """Read a datagram.

    Raises:
        DatagramError: it is not a frame of this protocol.
    """
    if len(datagram) < _HEADER.size:
        raise DatagramError(f"a frame of {len(datagram)} bytes is too short")
    magic, number, first, _, ack = _HEADER.unpack_from(datagram)
    if magic != MAGIC:
        raise DatagramError(f"a frame can't start with {magic!r}")
    if number not in FrameKind.__members__.values():
        raise DatagramError(f"unknown frame type {number}")
    kind, payload = FrameKind(number), datagram[_HEADER.size :]
    if len(payload) > MOST_PAYLOAD:
        raise DatagramError(
            f"a frame has {len(payload)} bytes of packets, more than {MOST_PAYLOAD}"
        )
    return Datagram(kind, ack, tuple(_numbered(first, _packets(kind, payload))))


def encoded(ack: int, first: int, contents: Sequence[Any]) -> bytes:
    """Write a frame of the robot.

    Args:
        ack: the number of the last packet received in order.
        first: the number of the first numbered packet; 0 if there is none.
        contents: the packets in order.
    """
    count = sum(not packet.is_oob() for packet in contents)
    last = first
    for _ in range(count - 1):
        last = following(last)
    header = _HEADER.pack(MAGIC, FrameKind.FROM_ROBOT, first, last, ack)
    return header + b"".join(map(_encoded_packet, contents))


def _numbered(first: int, pairs: Iterator[tuple[int, Any]]) -> Iterator[tuple[int, Any]]:
    number = first
    for kind, packet in pairs:
        if kind >= PacketKind.EVENT:
            yield 0, packet
        else:
            yield number, packet
            number = following(number)


def _packets(kind: FrameKind, payload: bytes) -> Iterator[tuple[int, Any]]:
    """The packets with their kinds."""
    if kind is FrameKind.PING:
        yield PacketKind.PING, _packet(PacketKind.PING, payload)
    elif kind is FrameKind.ACTION:
        yield PacketKind.COMMAND, _packet(PacketKind.COMMAND, payload)
    elif kind in {FrameKind.FROM_ENGINE, FrameKind.FROM_ROBOT}:
        yield from _packed(payload)


def _packed(payload: bytes) -> Iterator[tuple[int, Any]]:
    while payload:
        if len(payload) < _PACKET.size:
            raise DatagramError("a packet ends in its header")
        kind, length = _PACKET.unpack_from(payload)
        content, payload = payload[_PACKET.size :][:length], payload[_PACKET.size + length :]
        if len(content) < length:
            raise DatagramError(f"a packet of {length} bytes ends after {len(content)}")
        yield kind, _packet(kind, content)


def _packet(kind: int, content: bytes) -> Any:
    """Decode a packet; None if pycozmo does not know its kind."""
    codecs = {
        PacketKind.CONNECT: packets.Connect,
        PacketKind.DISCONNECT: packets.Disconnect,
        PacketKind.KEYFRAME: packets.Keyframe,
        PacketKind.PING: packets.Ping,
    }
    if kind in {PacketKind.COMMAND, PacketKind.EVENT}:
        codec = packets.PACKETS_BY_ID.get(content[0]) if content else None
        content = content[1:]
    else:
        codec = codecs.get(kind)  # type: ignore[call-overload] # any number is possible
    if codec is None:
        return None
    try:
        return codec.from_bytes(content)
    except (IndexError, ValueError, struct.error) as error:
        raise DatagramError(f"the packet {codec.__name__} can't be read: {error}") from error


def _encoded_packet(packet: Any) -> bytes:
    content: bytes = packet.to_bytes()
    if packet.type.value in {PacketKind.COMMAND, PacketKind.EVENT}:
        content = bytes((packet.id,)) + content
    return _PACKET.pack(packet.type.value, len(content)) + content
