"""Slice's types: each writes and reads its values.

A structure is described by a frozen dataclass whose annotations are the names at the end of this
module:

    >>> from dataclasses import dataclass
    >>> @dataclass(frozen=True)
    ... class Reading:
    ...     angle: Float
    ...     dist: Float
    >>> readings = Sequence(Structure.of(Reading))
    >>> readings.decoded(readings.encoded([Reading(0.5, 300.0)]))
    (Reading(angle=0.5, dist=300.0),)
"""

import struct
import sys
from abc import ABC, abstractmethod
from array import array
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from enum import IntEnum
from typing import Annotated, Any, TypeGuard, get_type_hints

from learnblock.errors import IceEncodingError
from learnblock.ice.encoding import NEWEST, Reader, Version, Writer


class Type(ABC):
    """A type of Slice."""

    #: The smallest number of bytes of a value.
    least: int

    @abstractmethod
    def write(self, writer: Writer, value: Any) -> None:
        """Write a value; any error may be raised if it is invalid."""

    @abstractmethod
    def read(self, reader: Reader) -> Any:
        """Read a value.

        Raises:
            IceEncodingError: the data contains no such value.
        """

    def encoded(self, value: Any, version: Version = NEWEST) -> bytes:
        """A value as bytes.

        Raises:
            IceEncodingError: the value does not have this type.
        """
        writer = Writer(version)
        with writing(self, value):
            self.write(writer, value)
        return bytes(writer.data)

    def decoded(self, data: bytes | memoryview, version: Version = NEWEST) -> Any:
        """The value in some bytes, which must contain nothing else.

        Raises:
            IceEncodingError: they are not such a value.
        """
        reader = Reader(data, version)
        value = self.read(reader)
        reader.end()
        return value


@contextmanager
def writing(what: object, value: object) -> Iterator[None]:
    """Convert errors of writing a value to an IceEncodingError."""
    try:
        yield
    except (AttributeError, OverflowError, TypeError, ValueError, struct.error) as error:
        raise IceEncodingError("ice-bad-value", value=f"{value!r:.80}", type=str(what)) from error


class Number(Type):
    """A number or a bool.

    Args:
        name: its name in Slice.
        code: its code in `struct` and `array`.
    """

    def __init__(self, name: str, code: str) -> None:
        self.name = name
        self.code = code
        self._form = struct.Struct("<" + code)
        self.least = self._form.size

    def __repr__(self) -> str:
        return self.name

    def write(self, writer: Writer, value: Any) -> None:
        writer.data += self._form.pack(value)

    def read(self, reader: Reader) -> Any:
        return self._form.unpack(reader.take(self.least))[0]


class Truth(Number):
    """A bool; a byte that is neither 0 nor 1 is an error."""

    def read(self, reader: Reader) -> bool:
        value = reader.byte()
        if value > 1:
            raise IceEncodingError("ice-bad-value", value=str(value), type="bool")
        return bool(value)


class Text(Type):
    """A string."""

    least = 1

    def __repr__(self) -> str:
        return "string"

    def write(self, writer: Writer, value: Any) -> None:
        writer.text(value)

    def read(self, reader: Reader) -> str:
        return reader.text()


class Enumeration(Type):
    """An enum, as an IntEnum.

    Args:
        kind: its members have the numbers 0 to 127, as in RoboComp, so that each takes one byte in
            both encodings.
    """

    least = 1

    def __init__(self, kind: type[IntEnum]) -> None:
        self.kind = kind

    def __repr__(self) -> str:
        return self.kind.__name__

    def write(self, writer: Writer, value: Any) -> None:
        writer.data.append(self.kind(value))

    def read(self, reader: Reader) -> IntEnum:
        value = reader.byte()
        try:
            return self.kind(value)
        except ValueError:
            raise IceEncodingError(
                "ice-bad-value", value=str(value), type=self.kind.__name__
            ) from None


class Sequence(Type):
    """A sequence: bytes for ``sequence<byte>``, an array for numbers, or else a tuple."""

    least = 1

    def __init__(self, element: Type) -> None:
        self.element = element

    def __repr__(self) -> str:
        return f"sequence<{self.element}>"

    def write(self, writer: Writer, value: Any) -> None:
        if self.element is BYTE:
            raw = memoryview(value).cast("B")
            writer.size(len(raw))
            writer.data += raw
            return
        writer.size(len(value))
        if _is_packed(self.element):
            writer.data += _in_order(array(self.element.code, value)).tobytes()
            return
        for item in value:
            self.element.write(writer, item)

    def read(self, reader: Reader) -> Any:
        count = reader.count(self.element.least)
        if self.element is BYTE:
            return bytes(reader.take(count))
        if _is_packed(self.element):
            numbers = array(self.element.code)
            numbers.frombytes(reader.take(count * self.element.least))
            return _in_order(numbers)
        return tuple(self.element.read(reader) for _ in range(count))


class Dictionary(Type):
    """A dictionary."""

    least = 1

    def __init__(self, key: Type, value: Type) -> None:
        self.key = key
        self.value = value

    def __repr__(self) -> str:
        return f"dictionary<{self.key}, {self.value}>"

    def write(self, writer: Writer, value: Any) -> None:
        writer.size(len(value))
        for key, item in value.items():
            self.key.write(writer, key)
            self.value.write(writer, item)

    def read(self, reader: Reader) -> dict[Any, Any]:
        count = reader.count(self.key.least + self.value.least)
        return {self.key.read(reader): self.value.read(reader) for _ in range(count)}


class Structure(Type):
    """A struct.

    Args:
        kind: the frozen dataclass of its values.
        members: name and type of each member in the order of the protocol.
    """

    def __init__(self, kind: type, members: tuple[tuple[str, Type], ...]) -> None:
        self.kind = kind
        self.members = members
        self.least = sum(type_.least for _, type_ in members)

    def __repr__(self) -> str:
        return self.kind.__name__

    @classmethod
    def of(cls, kind: type, order: str | None = None) -> "Structure":
        """The struct for a dataclass.

        Args:
            kind: the dataclass, annotated with the types at the end of this module.
            order: its members in the order of the protocol, if that differs from the dataclass.
        """
        hints = get_type_hints(kind, include_extras=True)
        types = {name: hint.__metadata__[0] for name, hint in hints.items()}
        names = order.split() if order else list(types)
        if sorted(names) != sorted(types):
            raise ValueError(f"{names} are not the members of {kind.__name__}")
        return cls(kind, tuple((name, types[name]) for name in names))

    def write(self, writer: Writer, value: Any) -> None:
        for name, member in self.members:
            member.write(writer, getattr(value, name))

    def read(self, reader: Reader) -> Any:
        return self.kind(**{name: member.read(reader) for name, member in self.members})


@dataclass(frozen=True, slots=True)
class Refusal:
    """A user exception whose only member is the string ``what``, as in RoboComp.

    Args:
        type_id: its name, such as ``::RoboCompDisplay::HardwareFailedException``.
    """

    type_id: str


def _is_packed(type_: Type) -> TypeGuard[Number]:
    """Whether a sequence of them has the layout of an array."""
    return isinstance(type_, Number) and not isinstance(type_, Truth)


def _in_order(numbers: "array[Any]") -> "array[Any]":
    """Swap bytes if necessary: the protocol is little-endian."""
    if sys.byteorder == "big":
        numbers.byteswap()
    return numbers


BOOL = Truth("bool", "?")
BYTE = Number("byte", "B")
SHORT = Number("short", "h")
INT = Number("int", "i")
LONG = Number("long", "q")
FLOAT = Number("float", "f")
DOUBLE = Number("double", "d")
STRING = Text()

# The same as annotations.
Bool = Annotated[bool, BOOL]
Byte = Annotated[int, BYTE]
Int = Annotated[int, INT]
Float = Annotated[float, FLOAT]
String = Annotated[str, STRING]
Bytes = Annotated[bytes, Sequence(BYTE)]
