"""Ice's encodings 1.0 and 1.1: sizes, strings and encapsulations as bytes."""

import struct
from typing import Any

from learnblock.errors import IceEncodingError

Version = tuple[int, int]

#: The encoding we write; Ice before 3.5 wrote 1.0.
NEWEST: Version = (1, 1)
_KNOWN: tuple[Version, ...] = ((1, 0), NEWEST)

_INT = struct.Struct("<i")
_ENCAPSULATION = struct.Struct("<iBB")
#: A size from this number on takes five bytes.
_LONG_SIZE = 255


class Writer:
    """Writes values as bytes, one after the other.

    Args:
        version: the version of the encoding.
    """

    def __init__(self, version: Version = NEWEST) -> None:
        self.version = version
        self.data = bytearray()

    def pack(self, form: struct.Struct, *values: Any) -> None:
        """Write numbers in a format of `struct`."""
        self.data += form.pack(*values)

    def size(self, count: int) -> None:
        """Write the number of elements that follow."""
        if count < _LONG_SIZE:
            self.data.append(count)
        else:
            self.data.append(_LONG_SIZE)
            self.data += _INT.pack(count)

    def text(self, text: str) -> None:
        """Write a string."""
        encoded = text.encode()
        self.size(len(encoded))
        self.data += encoded

    def encapsulated(self) -> bytes:
        """Everything written so far, preceded by its length and encoding."""
        length = _ENCAPSULATION.size + len(self.data)
        return _ENCAPSULATION.pack(length, *self.version) + self.data


class Reader:
    """Reads bytes as values, one after the other.

    Args:
        data: the bytes.
        version: the version of their encoding.
    """

    def __init__(self, data: bytes | memoryview, version: Version = NEWEST) -> None:
        self.version = version
        self._data = memoryview(data)
        self._at = 0

    @property
    def left(self) -> int:
        """The number of bytes not read yet."""
        return len(self._data) - self._at

    def take(self, count: int) -> memoryview:
        """The next bytes.

        Raises:
            IceEncodingError: fewer bytes are left.
        """
        if not 0 <= count <= self.left:
            raise IceEncodingError("ice-too-short", expected=count, left=self.left)
        self._at += count
        return self._data[self._at - count : self._at]

    def unpack(self, form: struct.Struct) -> tuple[Any, ...]:
        """Numbers in a format of `struct`."""
        return form.unpack(self.take(form.size))

    def byte(self) -> int:
        """A number from 0 to 255."""
        return self.take(1)[0]

    def size(self) -> int:
        """The number of elements that follow."""
        size = self.byte()
        if size == _LONG_SIZE:
            (size,) = self.unpack(_INT)
        if size < 0:
            raise IceEncodingError("ice-bad-value", value=str(size), type="size")
        return size

    def count(self, least: int) -> int:
        """The number of elements that follow, each with at least `least` bytes.

        Raises:
            IceEncodingError: they do not fit into the data, so no memory is allocated for them.
        """
        count = self.size()
        if count * max(least, 1) > self.left:
            raise IceEncodingError("ice-too-short", expected=count * max(least, 1), left=self.left)
        return count

    def text(self) -> str:
        """A string."""
        data = self.take(self.size())
        try:
            return str(data, "utf-8")
        except UnicodeDecodeError as error:
            raise IceEncodingError(
                "ice-bad-value", value=repr(bytes(data[:40])), type="string"
            ) from error

    def encapsulated(self) -> "Reader":
        """The content of the encapsulation that follows."""
        length, major, minor = self.unpack(_ENCAPSULATION)
        if (major, minor) not in _KNOWN:
            raise IceEncodingError("ice-unknown-encoding", version=f"{major}.{minor}")
        return Reader(self.take(length - _ENCAPSULATION.size), (major, minor))

    def end(self) -> None:
        """Check that everything was read.

        Raises:
            IceEncodingError: some bytes are left.
        """
        if self.left:
            raise IceEncodingError("ice-too-long", left=self.left)
