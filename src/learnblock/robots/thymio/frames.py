"""The messages in what a Thymio sends: Aseba's binary protocol.

A message is a head of three numbers of 16 bits, the lower byte first (length of what follows the
head, the sender's node, the kind), and then the rest.
"""

import struct
from collections.abc import Iterator

from thymiodirect.message import Message

from learnblock.robots.thymio.link import GarbledError

_HEAD = struct.Struct("<HHH")
#: Bytes after the head; a packet of Aseba's has 512 at most.
_LONGEST = 1024


class Frames:
    """Cuts a stream of bytes into messages."""

    def __init__(self) -> None:
        self._waiting = b""

    def feed(self, data: bytes) -> Iterator[Message]:
        """The messages that these bytes complete.

        Raises:
            GarbledError: they are none.
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
        GarbledError: what it carries is not what its kind has.
    """
    message = Message(kind, node, payload)
    try:
        message.decode()
    except (IndexError, ValueError) as error:
        # Too short, or a name that is no UTF-8.
        raise GarbledError(f"a message {kind:#06x} of {len(payload)} bytes: {error}") from error
    return message


def encoded(kind: int, *words: int) -> bytes:
    """A message of ours with numbers of 16 bits, signed or not."""
    payload = Message.uint16array_to_bytes([word & 0xFFFF for word in words])
    # Node 1 is what thymiodirect calls itself; the robot answers whoever asks.
    frame: bytes = Message(kind, 1, payload).serialize()
    return frame


def signed(word: int) -> int:
    """A number of 16 bits as the robot means it."""
    return word - 0x10000 if word >= 0x8000 else word
