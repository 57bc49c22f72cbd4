"""Aseba's binary protocol: splits a Thymio's data into messages.

A message has a head of three 16-bit little-endian numbers (the length of the rest, the sender's
node, the kind), followed by the rest.
"""

import struct
from collections.abc import Iterator

# Why: docs/decisions.md, "Robot libraries without new releases"
from thymiodirect.message import Message

from learnblock.robots.thymio.link import GarbledError

_HEAD = struct.Struct("<HHH")
#: The maximum number of bytes after the head; Aseba's packets have at most 512.
_LONGEST = 1024


class Frames:
    """Splits a stream of bytes into messages."""

    def __init__(self) -> None:
        self._waiting = b""

    def feed(self, data: bytes) -> Iterator[Message]:
        """Yield the messages completed by these bytes.

        Raises:
            GarbledError: the data is invalid.
        """
        self._waiting += data
        while len(self._waiting) >= _HEAD.size:
            length, node, kind = _HEAD.unpack_from(self._waiting)
            if length > _LONGEST:
                raise GarbledError(f"a message of {length} bytes")
            end = _HEAD.size + length
            if len(self._waiting) < end:
                return
            payload, self._waiting = self._waiting[_HEAD.size : end], self._waiting[end:]
            yield decoded(kind, node, payload)


def decoded(kind: int, node: int, payload: bytes) -> Message:
    """A message with its fields.

    Raises:
        GarbledError: its content does not match its kind.
    """
    message = Message(kind, node, payload)
    try:
        message.decode()
    except (IndexError, ValueError) as error:
        # Too short, or a name that is not UTF-8.
        raise GarbledError(f"a message {kind:#06x} of {len(payload)} bytes: {error}") from error
    return message


def encoded(kind: int, *words: int) -> bytes:
    """A message to the robot with 16-bit numbers, signed or not."""
    payload = Message.uint16array_to_bytes([word & 0xFFFF for word in words])
    # Node 1, as in thymiodirect; the robot answers any node.
    frame: bytes = Message(kind, 1, payload).serialize()
    return frame


def signed(word: int) -> int:
    """A 16-bit word as a signed number."""
    return word - 0x10000 if word >= 0x8000 else word
