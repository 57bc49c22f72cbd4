"""Ice's encodings 1.0 and 1.1: how sizes, texts and encapsulations stand in bytes."""

import struct
from typing import Any

from learnblock.errors import IceEncodingError

Version = tuple[int, int]

#: The encoding we write; 1.0 is what Ice wrote before 3.5.
NEWEST: Version = (1, 1)
_KNOWN: tuple[Version, ...] = ((1, 0), NEWEST)

_INT = struct.Struct("<i")
_ENCAPSULATION = struct.Struct("<iBB")
#: A size from here on takes five bytes.
_LONG_SIZE = 255


class Writer:
    """Values as bytes, one behind the other.

    Args:
        version: of the encoding.
    """

    def __init__(self, version: Version = NEWEST) -> None:
        self.version = version
        self.data = bytearray()

    def pack(self, form: struct.Struct, *values: Any) -> None:
        """Write numbers in the form of `struct`."""
        self.data += form.pack(*values)

    def size(self, count: int) -> None:
        """Write how many of something follow."""
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
        """All that was written, with its length and encoding before it."""
        length = _ENCAPSULATION.size + len(self.data)
        return _ENCAPSULATION.pack(length, *self.version) + self.data


class Reader:
    """Bytes that are read as values, one behind the other.

    Args:
        data: the bytes.
        version: of their encoding.
    """

    def __init__(self, data: bytes | memoryview, version: Version = NEWEST) -> None:
        self.version = version
        self._data = memoryview(data)
        self._at = 0

    @property
    def left(self) -> int:
        """The bytes that are not read yet."""
        return len(self._data) - self._at

    def take(self, count: int) -> memoryview:
        """The next bytes.

        Raises:
            IceEncodingError: there are not so many.
        """
        if not 0 <= count <= self.left:
            raise IceEncodingError(f"{count} bytes should follow, and {self.left} do")
        self._at += count
        return self._data[self._at - count : self._at]

    def unpack(self, form: struct.Struct) -> tuple[Any, ...]:
        """Numbers in the form of `struct`."""
        return form.unpack(self.take(form.size))

    def byte(self) -> int:
        """A number from 0 to 255."""
        return self.take(1)[0]

    def size(self) -> int:
        """How many of something follow."""
        size = self.byte()
        if size == _LONG_SIZE:
            (size,) = self.unpack(_INT)
        if size < 0:
            raise IceEncodingError(f"a size is {size}")
        return size

    def count(self, least: int) -> int:
        """How many elements follow, each of `least` bytes or more.

        Raises:
            IceEncodingError: so many cannot follow: nobody is made to set memory aside for them.
        """
        count = self.size()
        if count * max(least, 1) > self.left:
            raise IceEncodingError(f"{count} elements cannot stand in {self.left} bytes")
        return count

    def text(self) -> str:
        """A string."""
        data = self.take(self.size())
        try:
            return str(data, "utf-8")
        except UnicodeDecodeError as error:
            raise IceEncodingError(f"a string is not UTF-8: {bytes(data[:40])!r}") from error

    def encapsulated(self) -> "Reader":
        """What stands in the encapsulation that follows."""
        length, major, minor = self.unpack(_ENCAPSULATION)
        if (major, minor) not in _KNOWN:
            raise IceEncodingError(f"the encoding {major}.{minor} is not known here")
        return Reader(self.take(length - _ENCAPSULATION.size), (major, minor))

    def end(self) -> None:
        """Make sure that all was read.

        Raises:
            IceEncodingError: something was not.
        """
        if self.left:
            raise IceEncodingError(f"{self.left} bytes are left over")
