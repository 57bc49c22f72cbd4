"""The blocks of a run's log, as they are kept and stored: compressed, and readable one by one."""

import struct
import zlib
from collections.abc import Iterator
from dataclasses import dataclass
from enum import IntEnum

#: The first bytes of a file, with the version of its format.
MAGIC = b"LearnBlock run log 1\n"
#: Kind, time of the first and of the last event in ticks, length, check sum.
_HEAD = struct.Struct(">BIIII")
#: The largest block that is read; ours are far smaller.
LARGEST = 64 * 1024 * 1024
#: As fast as can be; more effort saves little here.
_EFFORT = 1


class EventStream(IntEnum):
    """What a block contains."""

    #: The program: one msgpack map.
    HEADER = 0
    #: What the program did: `events`, msgpack.
    PROGRAM = 1
    #: The lines that ran and the skills called: lines of the trace.
    STEPS = 2
    #: Everything else in the trace, and collisions: lines of JSON.
    WORLD = 3
    #: How the run ended: one msgpack map.
    ENDING = 4
    #: What decides about a world that several robots share, in order: lines of the trace.
    TEAM = 5


#: The streams whose oldest blocks are given up when the log is full.
DETAIL = frozenset({EventStream.PROGRAM, EventStream.STEPS})


@dataclass(frozen=True, slots=True)
class EventBlock:
    """Some consecutive events of one stream.

    Args:
        stream: what they are.
        first: the time of the first one, in ticks.
        last: the time of the last one.
        packed: the events, compressed.
    """

    stream: EventStream
    first: int
    last: int
    packed: bytes

    @classmethod
    def of(cls, stream: EventStream, first: int, last: int, data: bytes) -> "EventBlock":
        """Compress `data`."""
        return cls(stream, first, last, zlib.compress(data, _EFFORT))

    @property
    def data(self) -> bytes:
        """The events; see `unpacked`."""
        return self.unpacked(LARGEST)

    def unpacked(self, most: int) -> bytes:
        """The events.

        Args:
            most: the most bytes that are unpacked.

        Raises:
            ValueError: it is not compressed data, or too much of it.
        """
        unpacking = zlib.decompressobj()
        try:
            data = unpacking.decompress(self.packed, most)
        except zlib.error as error:
            raise ValueError(str(error)) from error
        if unpacking.unconsumed_tail:
            raise ValueError("a block is too large")
        return data

    def __bytes__(self) -> bytes:
        """The block as it is stored."""
        length = len(self.packed)
        check = _check(self.stream, self.first, self.last, self.packed)
        return _HEAD.pack(self.stream, self.first, self.last, length, check) + self.packed


def stored(data: bytes) -> Iterator[EventBlock]:
    """The blocks of a file, up to where it is whole: its writer may have been killed.

    Args:
        data: what follows `MAGIC`.
    """
    at = 0
    while at + _HEAD.size <= len(data):
        kind, first, last, length, check = _HEAD.unpack_from(data, at)
        packed = data[at + _HEAD.size : at + _HEAD.size + length]
        if len(packed) < length or _check(kind, first, last, packed) != check:
            return
        at += _HEAD.size + length
        if kind in EventStream.__members__.values():
            yield EventBlock(EventStream(kind), first, last, packed)


def _check(kind: int, first: int, last: int, packed: bytes) -> int:
    """The check sum of a block, of what its head says too."""
    return zlib.crc32(packed, zlib.crc32(_HEAD.pack(kind, first, last, len(packed), 0)))
