"""A link: messages over a socket, in order, each preceded by its length."""

import socket
import struct
from collections import deque
from typing import Any, Generic, Protocol, TypeVar, cast, get_args

import msgspec

from learnblock.errors import DeviceValueError, RobotConnectionError
from learnblock.runtime.messages import (
    LARGEST,
    LARGEST_LOGGED,
    Answer,
    Command,
    Failed,
    FromHost,
    Logged,
    Message,
    Picture,
)
from learnblock.runtime.values import described

Incoming = TypeVar("Incoming")

#: The bytes before a message that say how long it is.
LENGTH = 4
#: What msgspec raises for a value that it can't encode.
NOT_ENCODABLE = (OverflowError, RecursionError, TypeError, UnicodeEncodeError)
_CHUNK = 65536
#: The largest message: a frame of 1920 by 1080 pixels and its envelope.
MAX_MESSAGE = 8 * 1024 * 1024
#: By its tag, how large a message of more than `LARGEST` bytes may be. A `Command` has to be a
#: `Picture` then.
_LARGER = {
    **{kind.__name__.encode(): MAX_MESSAGE for kind in get_args(FromHost)},
    Command.__name__.encode(): MAX_MESSAGE,
    Logged.__name__.encode(): LARGEST_LOGGED + 1024,
}
#: The bytes of a message that have its tag.
_HEAD = 20
#: msgpack's extension code for a frame: height, width and channels as 32 bit, then its bytes.
_FRAME = 1
_SHAPE = struct.Struct(">III")
_DIMENSIONS = 3
#: msgpack's codes for short texts, such as a tag: the first, and how many there are.
_SHORT_TEXT, _SHORT_TEXTS = 0xA0, 32

_decode_picture = msgspec.msgpack.Decoder(Picture).decode


class AtOnce(Protocol):
    """What a host in the same thread does at once, so that no message has to be sent.

    The values of arguments have to be small (`learnblock.runtime.values.is_small`).
    """

    def note(self, step: int | str) -> None:
        """Note that a line is about to run, or that a skill without arguments is called."""

    def note_call(self, skill: str, args: tuple[Any, ...]) -> None:
        """Note that a skill is called."""

    def obey(self, device: int, function: str, args: tuple[Any, ...]) -> bool:
        """Call a function of a device; return whether the next thing may be done at once, too."""

    def answer(self, device: int, function: str, args: tuple[Any, ...]) -> Any:
        """Call a function of a device, and return a copy of its value.

        Raises:
            LearnBlockError: the call failed.
        """

    def wait(self, steps: int) -> int | None:
        """Let so many steps of the world pass; return its step counter.

        None if that needs a message.
        """

    def sleep(self, steps: int, reads: tuple[int, ...]) -> Answer | Failed | None:
        """Let others have their turns for so many steps of the world; see `Sleep`.

        Returns the answer; None if that needs a message, as when the program is being stopped.
        """


class Link(Generic[Incoming]):
    """One end of a conversation.

    Args:
        incoming: the union of the messages that may arrive.
    """

    #: What the other end does without a message; None for nothing.
    at_once: AtOnce | None = None

    def __init__(self, incoming: Any) -> None:
        self._encoder = msgspec.msgpack.Encoder(enc_hook=_as_plain)
        self._decoder: msgspec.msgpack.Decoder[Incoming] = msgspec.msgpack.Decoder(
            incoming, ext_hook=_from_extension
        )
        self._messages: deque[Incoming] = deque()
        self._outgoing = bytearray()

    def put(self, message: Message) -> int:
        """Queue a message for the next `flush`; return the number of queued bytes.

        Raises:
            DeviceValueError: it is too long, or a value cannot be sent; nothing is queued.
        """
        outgoing = self._outgoing
        start = len(outgoing)
        try:
            outgoing += b"\0\0\0\0"
            self._encoder.encode_into(message, outgoing, start + LENGTH)
            length = len(outgoing) - start - LENGTH
            if length > LARGEST and length > (limit := _limit(message)):
                raise DeviceValueError("run-value-too-large", size=length, limit=limit)
            outgoing[start : start + LENGTH] = length.to_bytes(LENGTH)
        except NOT_ENCODABLE as error:
            del outgoing[start:]
            raise DeviceValueError("run-value-not-sendable", reason=str(error)) from error
        except BaseException:
            # Half a message would corrupt all that follow, even if a signal handler raised.
            del outgoing[start:]
            raise
        return len(outgoing)

    def flush(self) -> None:
        """Send what is queued.

        Raises:
            EOFError: the other end is gone.
        """
        raise NotImplementedError

    def send(self, message: Message) -> None:
        """Send a message, after everything that is queued."""
        self.put(message)
        self.flush()

    def receive(self, timeout: float | None = None) -> Incoming | None:
        """The next message, or None if none arrived within `timeout` seconds.

        Raises:
            EOFError: the other end is gone.
            RobotConnectionError: the received data is not a message of this conversation.
        """
        raise NotImplementedError

    def receive_now(self) -> Incoming | None:
        """The next message if it has arrived, else None.

        Raises:
            EOFError: the other end is gone.
            RobotConnectionError: the received data is not a message of this conversation.
        """
        raise NotImplementedError

    def close(self) -> None:
        """End the conversation."""
        raise NotImplementedError

    def offer(self, at_once: "AtOnce | None") -> None:
        """Offer the other end what needs no message if it is in this thread; None ends that."""

    def give_turn(self) -> None:
        """Let this end run on behalf of the other one; only needed by one that offers functions."""
        raise NotImplementedError

    def fail(self, error: Exception) -> None:
        """Raise an error in the next `receive`; only needed by the end that offers functions."""
        raise NotImplementedError

    def copied(self, value: Any) -> Any:
        """A value as it arrives at the other end; only needed by the end that offers functions."""
        raise NotImplementedError

    def decode(self, message: bytearray) -> Incoming:
        """An arrived message.

        Raises:
            RobotConnectionError: it is not a message of this conversation.
        """
        try:
            if len(message) > LARGEST and _tag(message) == Command.__name__.encode():
                return cast("Incoming", _command(_decode_picture(message)))
            return self._decoder.decode(message)
        except (msgspec.MsgspecError, RecursionError, UnicodeDecodeError, TypeError) as error:
            raise RobotConnectionError("run-not-a-message", reason=str(error)) from error


class SocketLink(Link[Incoming]):
    """One end of a conversation over a socket.

    Args:
        connection: a connected stream socket.
        incoming: the union of the messages that may arrive.
    """

    def __init__(self, connection: socket.socket, incoming: Any) -> None:
        super().__init__(incoming)
        self._connection = connection
        self._received = bytearray()

    def flush(self) -> None:
        if self._outgoing:
            queued, self._outgoing = self._outgoing, bytearray()
            try:
                if self._connection.gettimeout() is not None:
                    self._connection.settimeout(None)
                self._connection.sendall(queued)
            except OSError as error:
                raise EOFError("the other end of the link is gone") from error

    def receive(self, timeout: float | None = None) -> Incoming | None:
        while not self._messages:
            if not self._fill(timeout):
                return None
        return self._messages.popleft()

    def receive_now(self) -> Incoming | None:
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
            # Wait at once: on a busy machine, polling gives the processor away each time.
            if self._connection.gettimeout() != timeout:
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

    def _split(self) -> None:
        received, start = self._received, 0
        while len(received) - start >= LENGTH:
            body = start + LENGTH
            size = int.from_bytes(received[start:body])
            end = body + size
            if size > LARGEST and not self._may_be_larger(received[body : body + _HEAD], size):
                raise RobotConnectionError("run-not-a-message", reason=f"{size:,} bytes")
            if end > len(received):
                break
            self._messages.append(self.decode(received[body:end]))
            start = end
        del received[:start]

    @staticmethod
    def _may_be_larger(head: bytearray, size: int) -> bool:
        """Whether a message with this beginning may have this length in bytes."""
        limit = MAX_MESSAGE if len(head) < _HEAD else _LARGER.get(_tag(head), LARGEST)
        return size <= limit


def _tag(message: bytearray) -> bytes:
    """The name of a message, with which it begins; "" if it has none."""
    length = message[1] - _SHORT_TEXT
    return bytes(message[2 : 2 + length]) if 0 <= length < _SHORT_TEXTS else b""


def _limit(message: Message) -> int:
    """How many bytes a message of more than `LARGEST` may have."""
    if isinstance(message, Command) and not _is_picture(message):
        return LARGEST
    return _LARGER.get(type(message).__name__.encode(), LARGEST)


def _is_picture(command: Command) -> bool:
    return len(command.args) == 1 and _is_frame(command.args[0])


def _is_frame(value: Any) -> bool:
    return getattr(value, "dtype", None) == "uint8" and value.ndim == _DIMENSIONS


def _command(picture: Picture) -> Command:
    (frame,) = picture.args
    shown = _from_extension(frame.code, memoryview(frame.data))
    return Command(picture.device, picture.function, (shown,))


def _as_plain(value: Any) -> Any:
    """Encode types that msgpack does not support: frames, numpy's numbers, and others as text."""
    if not hasattr(value, "dtype"):
        return described(value)
    if value.ndim == 0:
        return value.item()
    if _is_frame(value):
        return msgspec.msgpack.Ext(_FRAME, _SHAPE.pack(*value.shape) + value.tobytes())
    return value.tolist()


def _from_extension(code: int, data: memoryview) -> Any:
    shape = _shape(code, data)
    import numpy as np  # noqa: PLC0415 - few programs use the picture itself

    # A copy in a bytearray: the program may draw on its picture.
    return np.frombuffer(bytearray(data[_SHAPE.size :]), dtype=np.uint8).reshape(shape)


def _shape(code: int, data: memoryview) -> tuple[int, int, int]:
    if code != _FRAME or len(data) < _SHAPE.size:
        raise RobotConnectionError("run-not-a-message", reason=f"extension {code}")
    height, width, channels = _SHAPE.unpack_from(data)
    if height * width * channels != len(data) - _SHAPE.size:
        reason = f"{len(data) - _SHAPE.size} bytes for a frame of {height} x {width} x {channels}"
        raise RobotConnectionError("run-not-a-message", reason=reason)
    return height, width, channels


#: Decodes a value that has no message around it.
decoded_value = msgspec.msgpack.Decoder(ext_hook=_from_extension).decode
