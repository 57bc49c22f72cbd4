"""A link: messages over a socket, in order, each with its length before it."""

import socket
from collections import deque
from typing import Any, Generic, TypeVar

import msgspec

from learnblock.errors import RobotConnectionError
from learnblock.runtime.messages import Message

Incoming = TypeVar("Incoming")

_LENGTH = 4
#: The largest message either side accepts: a frame of 1920 by 1080 pixels and its envelope.
MAX_MESSAGE = 8 * 1024 * 1024


class Link(Generic[Incoming]):
    """One end of a conversation.

    Args:
        connection: a connected stream socket.
        incoming: the union of the messages that may arrive.
    """

    def __init__(self, connection: socket.socket, incoming: Any) -> None:
        self._connection = connection
        self._encoder = msgspec.msgpack.Encoder(enc_hook=_as_plain)
        self._decoder: msgspec.msgpack.Decoder[Incoming] = msgspec.msgpack.Decoder(incoming)
        self._received = bytearray()
        self._messages: deque[Incoming] = deque()
        self._outgoing = bytearray()

    def put(self, message: Message) -> int:
        """Queue a message for the next `flush`; answer how many bytes are queued."""
        outgoing = self._outgoing
        start = len(outgoing)
        outgoing += b"\0\0\0\0"
        self._encoder.encode_into(message, outgoing, start + _LENGTH)
        outgoing[start : start + _LENGTH] = (len(outgoing) - start - _LENGTH).to_bytes(_LENGTH)
        return len(outgoing)

    def flush(self) -> None:
        """Send what is queued.

        Raises:
            EOFError: the other end is gone.
        """
        if self._outgoing:
            queued, self._outgoing = self._outgoing, bytearray()
            try:
                self._connection.settimeout(None)
                self._connection.sendall(queued)
            except OSError as error:
                raise EOFError("the other end of the link is gone") from error

    def send(self, message: Message) -> None:
        """Send a message, after all that is queued."""
        self.put(message)
        self.flush()

    def receive(self, timeout: float | None = None) -> Incoming | None:
        """The next message, or None when none came within `timeout` seconds.

        Raises:
            EOFError: the other end is gone.
            RobotConnectionError: what arrived is no message of this conversation.
        """
        while not self._messages:
            if not self._fill(timeout):
                return None
        return self._messages.popleft()

    def close(self) -> None:
        self._connection.close()

    def _fill(self, timeout: float | None) -> bool:
        if self._connection.gettimeout() != timeout:
            self._connection.settimeout(timeout)
        try:
            received = self._connection.recv(65536)
        except TimeoutError:
            return False
        except OSError as error:
            raise EOFError("the other end of the link is gone") from error
        if not received:
            raise EOFError("the other end of the link is gone")
        self._received += received
        self._split()
        return True

    def _split(self) -> None:
        received, start = self._received, 0
        while len(received) - start >= _LENGTH:
            body = start + _LENGTH
            end = body + int.from_bytes(received[start:body])
            if end - body > MAX_MESSAGE:
                raise RobotConnectionError(f"a message of {end - body} bytes is too long")
            if end > len(received):
                break
            self._messages.append(self._decode(received[body:end]))
            start = end
        del received[:start]

    def _decode(self, message: bytearray) -> Incoming:
        try:
            return self._decoder.decode(message)
        except (msgspec.MsgspecError, RecursionError, UnicodeDecodeError) as error:
            raise RobotConnectionError(f"not a message of this link: {error}") from error


def _as_plain(value: Any) -> Any:
    """What msgpack has no form for: a frame as its shape and bytes, numbers, else its text."""
    if hasattr(value, "tobytes") and hasattr(value, "shape") and value.shape:
        return {"shape": list(value.shape), "pixels": value.tobytes()}
    if hasattr(value, "item"):
        return value.item()
    return repr(value)
