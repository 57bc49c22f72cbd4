"""The messages of Ice's protocol 1.0 between a client and a component."""

import struct
from dataclasses import dataclass
from enum import IntEnum

from learnblock.errors import IceEncodingError, IceRefusedError
from learnblock.ice.encoding import NEWEST, Reader, Writer
from learnblock.ice.interface import Mode
from learnblock.ice.types import Refusal

#: Magic, protocol 1.0 in encoding 1.0, kind, compression, total number of bytes.
HEADER = struct.Struct("<4s4BBBi")
#: Far more than RoboComp sends; Ice itself accepts 1 MB by default.
LARGEST = 16 * 1024 * 1024

_MAGIC = b"IceP"
_INT = struct.Struct("<i")
_BYTE = struct.Struct("<B")
_COMPRESSED = 2
#: Flags of a slice of an exception: its length precedes its members; it is the last slice.
_MEASURED, _LAST = 0x10, 0x20


class MessageKind(IntEnum):
    """The kinds of messages."""

    REQUEST = 0
    BATCH = 1
    REPLY = 2
    VALIDATE = 3
    CLOSE = 4


class Status(IntEnum):
    """The kinds of replies."""

    OK = 0
    USER_EXCEPTION = 1
    NO_OBJECT = 2
    NO_FACET = 3
    NO_OPERATION = 4
    UNKNOWN_LOCAL = 5
    UNKNOWN_USER = 6
    UNKNOWN = 7


#: Ice's names of the exceptions that a reply reports only by its status.
_EXCEPTIONS = {
    Status.NO_OBJECT: "ObjectNotExistException",
    Status.NO_FACET: "FacetNotExistException",
    Status.NO_OPERATION: "OperationNotExistException",
    Status.UNKNOWN_LOCAL: "UnknownLocalException",
    Status.UNKNOWN_USER: "UnknownUserException",
    Status.UNKNOWN: "UnknownException",
}


def message(kind: MessageKind, body: bytes = b"") -> bytes:
    """A whole message."""
    return HEADER.pack(_MAGIC, 1, 0, 1, 0, kind, 0, HEADER.size + len(body)) + body


def read_header(data: bytes | memoryview) -> tuple[MessageKind, int]:
    """The kind of a message, and the length of what follows its header.

    Raises:
        IceEncodingError: the header is invalid or not supported.
    """
    magic, major, _, _, _, kind, compression, size = HEADER.unpack(data)
    if magic != _MAGIC or major != 1 or kind > MessageKind.CLOSE:
        raise IceEncodingError("ice-not-ice", start=repr(bytes(data)))
    if compression == _COMPRESSED:
        raise IceEncodingError("ice-compressed")
    if not HEADER.size <= size <= LARGEST:
        raise IceEncodingError("ice-message-size", size=size, limit=LARGEST)
    return MessageKind(kind), size - HEADER.size


# Requests.


@dataclass(frozen=True, slots=True)
class Request:
    """A client's request.

    Args:
        number: the number of the reply; 0 if none is expected.
        identity: the object's name.
        facet: the object's facet; ours have none.
        operation: the operation's name.
        mode: the operation's mode in the client's interface.
        parameters: the parameters in the client's encoding.
    """

    number: int
    identity: str
    facet: tuple[str, ...]
    operation: str
    mode: int
    parameters: Reader


def request_opening(identity: str, operation: str, mode: Mode) -> bytes:
    """The part between a request's number and its parameters, the same for every call."""
    writer = Writer()
    writer.text(identity)
    # No category and no facet.
    writer.text("")
    writer.size(0)
    writer.text(operation)
    writer.pack(_BYTE, mode)
    # No context.
    writer.size(0)
    return bytes(writer.data)


def request(number: int, opening: bytes, parameters: bytes) -> bytes:
    """A request as a message."""
    return message(MessageKind.REQUEST, _INT.pack(number) + opening + parameters)


def read_request(body: bytes | memoryview) -> Request:
    """The request in a message.

    Raises:
        IceEncodingError: the message contains no request.
    """
    reader = Reader(body)
    (number,) = reader.unpack(_INT)
    identity, category = reader.text(), reader.text()
    facet = tuple(reader.text() for _ in range(reader.count(1)))
    operation = reader.text()
    mode = reader.byte()
    for _ in range(reader.count(2)):
        reader.text(), reader.text()
    parameters = reader.encapsulated()
    reader.end()
    name = f"{category}/{identity}" if category else identity
    return Request(number, name, facet, operation, mode, parameters)


# Replies.


def read_reply(body: bytes | memoryview) -> tuple[int, Reader]:
    """The number of the answered request, and the reply."""
    reader = Reader(body)
    (number,) = reader.unpack(_INT)
    return number, reader


def open_reply(reader: Reader) -> Reader:
    """The results in a reply.

    Raises:
        IceRefusedError: the component refused the call.
        IceEncodingError: it is not a reply.
    """
    try:
        status = Status(reader.byte())
    except ValueError as error:
        raise IceEncodingError("ice-bad-value", value=str(error), type="reply") from None
    if status is Status.OK:
        return reader.encapsulated()
    if status is Status.USER_EXCEPTION:
        raise _read_refusal(reader.encapsulated())
    raise _read_exception(status, reader)


def reply(call: Request, gives: Writer) -> bytes:
    """The message with the results of an operation."""
    return _reply(call, Status.OK, gives.encapsulated())


def refusal(call: Request, refused: Refusal, sentence: str) -> bytes:
    """The message with a user exception."""
    version = call.parameters.version
    members = Writer(version)
    members.text(sentence)
    writer = Writer(version)
    if version == NEWEST:
        writer.pack(_BYTE, _LAST)
        writer.text(refused.type_id)
    else:
        # It uses no classes; the length of a slice precedes it and includes itself.
        writer.pack(_BYTE, 0)
        writer.text(refused.type_id)
        writer.pack(_INT, _INT.size + len(members.data))
    writer.data += members.data
    return _reply(call, Status.USER_EXCEPTION, writer.encapsulated())


def not_there(call: Request, status: Status) -> bytes:
    """The message for a missing object or operation."""
    writer = Writer()
    writer.text(call.identity)
    writer.text("")
    writer.size(len(call.facet))
    for name in call.facet:
        writer.text(name)
    writer.text(call.operation)
    return _reply(call, status, bytes(writer.data))


def failure(call: Request, status: Status, sentence: str) -> bytes:
    """The message for an unexpected failure of an operation."""
    writer = Writer()
    writer.text(sentence)
    return _reply(call, status, bytes(writer.data))


def _reply(call: Request, status: Status, body: bytes) -> bytes:
    return message(MessageKind.REPLY, _INT.pack(call.number) + bytes((status,)) + body)


def _read_exception(status: Status, reader: Reader) -> IceRefusedError:
    kind = _EXCEPTIONS[status]
    if status >= Status.UNKNOWN_LOCAL:
        # Python's Ice sends a traceback, whose last line is the error.
        lines = reader.text().strip().splitlines()
        return IceRefusedError(lines[-1] if lines else kind, kind=kind)
    identity, _ = reader.text(), reader.text()
    for _ in range(reader.count(1)):
        reader.text()
    operation = reader.text()
    return IceRefusedError("ice-no-operation", kind, interface=identity, operation=operation)


def _read_refusal(reader: Reader) -> IceRefusedError:
    if reader.version != NEWEST:
        reader.byte()
        type_id = reader.text()
        reader.unpack(_INT)
        return IceRefusedError(_what(reader), kind=type_id)
    flags = reader.byte()
    type_id = reader.text()
    if flags & _MEASURED:
        reader.unpack(_INT)
    return IceRefusedError(_what(reader), kind=type_id)


def _what(reader: Reader) -> str:
    """An exception's text; exceptions from other programs may have other members or none."""
    try:
        return reader.text()
    except IceEncodingError:
        return ""
