"""A link: messages over a socket, in order, each with its length before it."""

import os
import socket
import struct
from collections import deque
from time import monotonic
from typing import Any, Generic, TypeVar

import msgspec

from learnblock.errors import DeviceValueError, RobotConnectionError
from learnblock.runtime.messages import Message
from learnblock.runtime.values import described

Incoming = TypeVar("Incoming")

_LENGTH = 4
_CHUNK = 65536
#: How often to look for a message before sleeping until it comes: most answers are there within
#: some 30 microseconds, and to be woken takes twice as long.
LOOKS = 30
#: Seconds after which that has been in vain: on a busy machine each look gives others their turn,
#: which may be 20 ms long, and whoever sleeps is woken before them.
LOOKING = 0.001
_CAN_LOOK = hasattr(socket, "MSG_DONTWAIT") and hasattr(os, "sched_yield")
#: The largest message either side accepts: a frame of 1920 by 1080 pixels and its envelope.
MAX_MESSAGE = 8 * 1024 * 1024
#: msgpack's extension code for a frame: height, width and channels as 32 bit, then its bytes.
_FRAME = 1
_SHAPE = struct.Struct(">III")


class Link(Generic[Incoming]):
    """One end of a conversation.

    Args:
        connection: a connected stream socket.
        incoming: the union of the messages that may arrive.
    """

    def __init__(self, connection: socket.socket, incoming: Any) -> None:
        self._connection = connection
        self._encoder = msgspec.msgpack.Encoder(enc_hook=_as_plain)
        self._decoder: msgspec.msgpack.Decoder[Incoming] = msgspec.msgpack.Decoder(
            incoming, ext_hook=_from_extension
        )
        self._received = bytearray()
        self._messages: deque[Incoming] = deque()
        self._outgoing = bytearray()

    def put(self, message: Message) -> int:
        """Queue a message for the next `flush`; answer how many bytes are queued.

        Raises:
            DeviceValueError: it holds what cannot be sent, or is too long; nothing is queued.
        """
        outgoing = self._outgoing
        start = len(outgoing)
        try:
            outgoing += b"\0\0\0\0"
            self._encoder.encode_into(message, outgoing, start + _LENGTH)
            length = len(outgoing) - start - _LENGTH
            if length > MAX_MESSAGE:
                raise DeviceValueError(
                    f"{length} bytes are too much to send; {MAX_MESSAGE} is the most"
                )
            outgoing[start : start + _LENGTH] = length.to_bytes(_LENGTH)
        except (OverflowError, RecursionError, TypeError, UnicodeEncodeError) as error:
            del outgoing[start:]
            raise DeviceValueError(f"a value cannot be sent to the robot: {error}") from error
        except BaseException:
            # Half a message would make nonsense of all that follow, also where a signal raised.
            del outgoing[start:]
            raise
        return len(outgoing)

    def flush(self) -> None:
        """Send what is queued.

        Raises:
            EOFError: the other end is gone.
        """
        if self._outgoing:
            queued, self._outgoing = self._outgoing, bytearray()
            try:
                if self._connection.gettimeout() is not None:
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

    def receive_now(self) -> Incoming | None:
        """The next message if it is there already, else None.

        Raises:
            EOFError: the other end is gone.
            RobotConnectionError: what arrived is no message of this conversation.
        """
        if not self._messages:
            self._connection.settimeout(0)
            try:
                self._accept(self._connection.recv(_CHUNK))
            except BlockingIOError:
                return None
            except OSError as error:
                raise EOFError("the other end of the link is gone") from error
        return self._messages.popleft() if self._messages else None

    def close(self) -> None:
        self._connection.close()

    def _fill(self, timeout: float | None) -> bool:
        try:
            received = self._look()
            if received is None:
                self._connection.settimeout(timeout)
                received = self._connection.recv(_CHUNK)
        except TimeoutError:
            return False
        except OSError as error:
            raise EOFError("the other end of the link is gone") from error
        self._accept(received)
        return True

    def _accept(self, received: bytes) -> None:
        if not received:
            raise EOFError("the other end of the link is gone")
        self._received += received
        self._split()

    def _look(self) -> bytes | None:
        """What has arrived or is about to; None when nothing has after some looks."""
        if not _CAN_LOOK:
            return None
        if self._connection.gettimeout() is not None:
            self._connection.settimeout(None)
        until = monotonic() + LOOKING
        for _ in range(LOOKS):
            try:
                return self._connection.recv(_CHUNK, socket.MSG_DONTWAIT)
            except BlockingIOError:
                os.sched_yield()
            if monotonic() > until:
                break
        return None

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
        except (msgspec.MsgspecError, RecursionError, UnicodeDecodeError, TypeError) as error:
            raise RobotConnectionError(f"not a message of this link: {error}") from error


def _as_plain(value: Any) -> Any:
    """What msgpack has no form for: a frame as an extension, numpy's numbers, else its text."""
    if not hasattr(value, "dtype"):
        return described(value)
    if value.ndim == 0:
        return value.item()
    if value.dtype == "uint8" and value.ndim == 3:
        return msgspec.msgpack.Ext(_FRAME, _SHAPE.pack(*value.shape) + value.tobytes())
    return value.tolist()


def _from_extension(code: int, data: memoryview) -> Any:
    shape = _shape(code, data)
    import numpy as np  # noqa: PLC0415 - few programs look at the picture itself

    # A copy in a bytearray: the program may draw on its picture.
    return np.frombuffer(bytearray(data[_SHAPE.size :]), dtype=np.uint8).reshape(shape)


def _shape(code: int, data: memoryview) -> tuple[int, int, int]:
    if code != _FRAME or len(data) < _SHAPE.size:
        raise RobotConnectionError(f"not a message of this link: extension {code}")
    height, width, channels = _SHAPE.unpack_from(data)
    if height * width * channels != len(data) - _SHAPE.size:
        raise RobotConnectionError(
            f"not a message of this link: {len(data) - _SHAPE.size} bytes are no frame of"
            f" {height} by {width} by {channels}"
        )
    return height, width, channels
