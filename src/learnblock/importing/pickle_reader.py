"""Read the pickle of a project of the original LearnBlock without running anything in it.

A pickle is a program: `pickle.load` would call any function that it names. Here each opcode of
protocols 0 to 3 that projects contain builds a plain value, and the few classes of projects become
`Object` and `Point`. Every other opcode or name is refused.
"""

import re
import struct
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any

from learnblock.errors import Diagnostic, ProjectError
from learnblock.i18n import Phrase

# Why: docs/decisions.md, "Pickles of the original LearnBlock are never unpickled"
#: Bytes. The largest project known has a tenth of it.
LARGEST = 4 * 1024 * 1024
#: Limits opcodes, and therefore values, so that reading takes a few seconds at most.
MOST_STEPS = 1_000_000
#: Values that wait for the ones inside them.
DEEPEST = 20_000
#: Of an object; they have about fifteen.
MOST_ATTRIBUTES = 100
#: Characters of a number.
LONGEST_NUMBER = 40

_PACKAGE = "learnbot_dsl.learnbotCode."
#: What the names in a pickle stand for.
_NAMES: Mapping[tuple[str, str], str] = {
    ("AbstracBlockItem", "AbstractBlockItem"): "first block",
    ("AbstractBlock", "AbstractBlock"): "block",
    (f"{_PACKAGE}AbstractBlock", "AbstractBlock"): "block",
    ("Block", "Connection"): "connection",
    (f"{_PACKAGE}Block", "Connection"): "connection",
    ("Block", "Variable"): "variable",
    (f"{_PACKAGE}Block", "Variable"): "variable",
    ("PySide.QtCore", "QPointF"): "point",
    ("PySide2.QtCore", "QPointF"): "point",
    ("__builtin__", "id"): "id",
    ("builtins", "id"): "id",
    ("__builtin__", "object"): "object",
    ("builtins", "object"): "object",
    ("copy_reg", "_reconstructor"): "reconstructor",
    ("copyreg", "_reconstructor"): "reconstructor",
}
_CLASSES = frozenset(("first block", "block", "connection", "variable"))
_MARK = object()


@dataclass(frozen=True)
class PickledName:
    """A class or function that the pickle names; it is never called.

    Args:
        kind: our name for it, such as ``block``.
    """

    kind: str


@dataclass(frozen=True)
class Point:
    """A position on the canvas."""

    x: float
    y: float


@dataclass(eq=False)
class Object:
    """An object of a class of projects.

    Args:
        kind: ``block``, ``first block`` (of version 1), ``connection`` or ``variable``.
        state: its attributes, by name. Objects may contain each other.
    """

    kind: str
    state: dict[str, Any] = field(default_factory=dict)


def read_pickle(data: bytes, filename: str) -> object:
    """Read the value in a pickle.

    Raises:
        ProjectError: the file is too large, damaged, or contains what no project does.
    """
    if len(data) > LARGEST:
        message = Phrase("import-too-large", size=len(data), limit=LARGEST)
        raise refusal(filename, "too-large", message)
    return _Reader(data, filename).read()


def refusal(filename: str, code: str, message: Phrase) -> ProjectError:
    """The error for a rejected file."""
    return ProjectError(filename, [Diagnostic(code, message)])


class _Reader:
    """A stack machine for the allowed opcodes."""

    def __init__(self, data: bytes, filename: str) -> None:
        self.data, self.filename = data, filename
        self.position = 0
        self.stack: list[Any] = []
        self.memo: dict[int, Any] = {}

    def read(self) -> object:
        for _ in range(MOST_STEPS):
            code = self.take(1)
            if code == b".":
                return self.pop()
            step = _STEPS.get(code)
            if step is None:
                raise self.forbidden(f"opcode {code[0]:#04x}")
            step(self)
            if len(self.stack) > DEEPEST:
                raise self.damaged("too-deep", Phrase("import-too-deep"))
        raise self.damaged("too-many", Phrase("import-too-many", limit=MOST_STEPS))

    # Errors.

    def damaged(self, code: str = "damaged", message: Phrase | None = None) -> ProjectError:
        phrase = message or Phrase("import-damaged", byte=str(self.position))
        return refusal(self.filename, code, phrase)

    def forbidden(self, what: str) -> ProjectError:
        message = Phrase("import-forbidden", what=what, byte=str(self.position))
        return refusal(self.filename, "forbidden", message)

    # Bytes.

    def take(self, size: int) -> bytes:
        part = self.data[self.position : self.position + size]
        if len(part) < size:
            raise self.damaged()
        self.position += size
        return part

    def line(self) -> bytes:
        end = self.data.find(b"\n", self.position)
        if end < 0:
            raise self.damaged()
        part = self.data[self.position : end]
        self.position = end + 1
        return part

    def unpacked(self, form: str) -> Any:
        return struct.unpack(form, self.take(struct.calcsize(form)))[0]

    def number(self, kind: Callable[[str], Any], text: bytes) -> Any:
        if len(text) > LONGEST_NUMBER:
            raise self.damaged()
        try:
            return kind(text.decode("ascii"))
        except ValueError:
            raise self.damaged() from None

    # The stack.

    def push(self, value: object) -> None:
        self.stack.append(value)

    def pop(self) -> Any:
        if not self.stack or self.stack[-1] is _MARK:
            raise self.damaged()
        return self.stack.pop()

    def top(self, kind: type) -> Any:
        if not self.stack or not isinstance(self.stack[-1], kind):
            raise self.damaged()
        return self.stack[-1]

    def pop_to_mark(self) -> list[Any]:
        """Pop what was pushed since the last mark, and the mark."""
        for place in range(len(self.stack) - 1, -1, -1):
            if self.stack[place] is _MARK:
                values = self.stack[place + 1 :]
                del self.stack[place:]
                return values
        raise self.damaged()

    def last(self, count: int) -> tuple[Any, ...]:
        return tuple(self.pop() for _ in range(count))[::-1]

    # Texts and numbers.

    def whole(self) -> None:
        text = self.line()
        flags = {b"00": False, b"01": True}
        self.push(flags[text] if text in flags else self.number(int, text))

    def long(self) -> None:
        self.push(self.number(int, self.line().removesuffix(b"L")))

    def sized_long(self, form: str) -> None:
        size = self.unpacked(form)
        if not 0 <= size <= LONGEST_NUMBER:
            raise self.damaged()
        self.push(int.from_bytes(self.take(size), "little", signed=True))

    def quoted(self) -> None:
        text = self.line()
        if len(text) < 2 or text[:1] != text[-1:] or text[:1] not in b"\"'":
            raise self.damaged()
        self.push(_decoded(_ESCAPE.sub(_meant, text[1:-1])))

    def sized_bytes(self, form: str) -> None:
        size = self.unpacked(form)
        if size < 0:
            raise self.damaged()
        self.push(_decoded(self.take(size)))

    def escaped(self) -> None:
        try:
            self.push(_whole_characters(self.line().decode("raw-unicode-escape")))
        except ValueError:
            raise self.damaged() from None

    def sized_text(self) -> None:
        try:
            text = self.take(self.unpacked("<I")).decode("utf-8", "surrogatepass")
            self.push(_whole_characters(text))
        except ValueError:
            raise self.damaged() from None

    # Containers.

    def dictionary(self) -> None:
        values = self.pop_to_mark()
        self.push({})
        self.add_items(values)

    def append(self) -> None:
        value = self.pop()
        self.top(list).append(value)

    def appends(self) -> None:
        values = self.pop_to_mark()
        self.top(list).extend(values)

    def add_items(self, values: list[Any]) -> None:
        if len(values) % 2:
            raise self.damaged()
        mapping = self.top(dict)
        for key, value in zip(values[::2], values[1::2], strict=True):
            # Other keys may take forever to hash.
            if not isinstance(key, str | int):
                raise self.damaged()
            mapping[key] = value

    def set_item(self) -> None:
        self.add_items(list(self.last(2)))

    # What was read before.

    def put(self, place: int) -> None:
        if not self.stack or self.stack[-1] is _MARK:
            raise self.damaged()
        self.memo[place] = self.stack[-1]

    def get(self, place: int) -> None:
        if place not in self.memo:
            raise self.damaged()
        self.push(self.memo[place])

    # Objects.

    def named(self) -> PickledName:
        module, name = (_decoded(self.line()) for _ in range(2))
        kind = _NAMES.get((module, name))
        if kind is None:
            raise self.forbidden(f"{module}.{name}"[:100])
        return PickledName(kind)

    def instance(self) -> None:
        name = self.named()
        self.push(self.made(name, tuple(self.pop_to_mark())))

    def instance_below_mark(self) -> None:
        name, *arguments = self.pop_to_mark() or [None]
        self.push(self.made(name, tuple(arguments)))

    def call(self) -> None:
        called, arguments = self.last(2)
        if isinstance(called, PickledName) and called.kind == "reconstructor":
            called, arguments = self.reconstructed(arguments), ()
        self.push(self.made(called, arguments))

    def reconstructed(self, arguments: object) -> PickledName:
        if not (
            isinstance(arguments, tuple) and arguments and isinstance(arguments[0], PickledName)
        ):
            raise self.damaged()
        return arguments[0]

    def made(self, name: object, arguments: object) -> Object | Point:
        if not isinstance(name, PickledName) or not isinstance(arguments, tuple):
            raise self.damaged()
        if name.kind == "point" and len(arguments) == 2:
            return self.point(*arguments)
        if name.kind not in _CLASSES or arguments:
            raise self.forbidden(name.kind)
        return Object(name.kind)

    def point(self, x: object, y: object) -> Point:
        if isinstance(x, int | float) and isinstance(y, int | float):
            return Point(x, y)
        raise self.damaged()

    def build(self) -> None:
        state = self.pop()
        target = self.top(Object)
        if not isinstance(state, dict) or len(state) > MOST_ATTRIBUTES:
            raise self.damaged()
        if not all(isinstance(key, str) for key in state):
            raise self.damaged()
        target.state.update(state)


#: The escapes in a text that Python 2 wrote.
_ESCAPE = re.compile(rb"\\(?:x([0-9a-fA-F]{2})|([\\'\"nrt]))")
_SIMPLE = {b"n": b"\n", b"r": b"\r", b"t": b"\t"}


def _meant(match: re.Match[bytes]) -> bytes:
    if match[1]:
        return bytes.fromhex(match[1].decode("ascii"))
    return _SIMPLE.get(match[2], match[2])


def _whole_characters(text: str) -> str:
    """Join the halves of characters, as some Pythons wrote them; half a one cannot be saved."""
    return text.encode("utf-16", "surrogatepass").decode("utf-16", "replace")


def _decoded(data: bytes) -> str:
    """A text of Python 2, which does not know its encoding."""
    try:
        return data.decode("utf-8")
    except UnicodeDecodeError:
        return data.decode("latin-1")


_Step = Callable[[_Reader], object]

#: The opcodes that are allowed, with what each does.
_STEPS: Mapping[bytes, _Step] = {
    # Numbers, and what has no content.
    b"I": _Reader.whole,
    b"L": _Reader.long,
    b"F": lambda machine: machine.push(machine.number(float, machine.line())),
    b"J": lambda machine: machine.push(machine.unpacked("<i")),
    b"K": lambda machine: machine.push(machine.unpacked("<B")),
    b"M": lambda machine: machine.push(machine.unpacked("<H")),
    b"G": lambda machine: machine.push(machine.unpacked(">d")),
    b"\x8a": lambda machine: machine.sized_long("<B"),
    b"\x8b": lambda machine: machine.sized_long("<i"),
    b"N": lambda machine: machine.push(None),
    b"\x88": lambda machine: machine.push(value=True),
    b"\x89": lambda machine: machine.push(value=False),
    # Texts.
    b"S": _Reader.quoted,
    b"T": lambda machine: machine.sized_bytes("<i"),
    b"U": lambda machine: machine.sized_bytes("<B"),
    b"B": lambda machine: machine.sized_bytes("<I"),
    b"C": lambda machine: machine.sized_bytes("<B"),
    b"V": _Reader.escaped,
    b"X": _Reader.sized_text,
    # Containers.
    b"(": lambda machine: machine.push(_MARK),
    b"t": lambda machine: machine.push(tuple(machine.pop_to_mark())),
    b")": lambda machine: machine.push(()),
    b"\x85": lambda machine: machine.push(machine.last(1)),
    b"\x86": lambda machine: machine.push(machine.last(2)),
    b"\x87": lambda machine: machine.push(machine.last(3)),
    b"l": lambda machine: machine.push(machine.pop_to_mark()),
    b"]": lambda machine: machine.push([]),
    b"a": _Reader.append,
    b"e": _Reader.appends,
    b"d": _Reader.dictionary,
    b"}": lambda machine: machine.push({}),
    b"s": _Reader.set_item,
    b"u": lambda machine: machine.add_items(machine.pop_to_mark()),
    # The stack and the memo.
    b"0": lambda machine: machine.pop(),
    b"1": lambda machine: machine.pop_to_mark(),
    b"2": lambda machine: machine.push(machine.top(object)),
    b"p": lambda machine: machine.put(machine.number(int, machine.line())),
    b"q": lambda machine: machine.put(machine.unpacked("<B")),
    b"r": lambda machine: machine.put(machine.unpacked("<I")),
    b"g": lambda machine: machine.get(machine.number(int, machine.line())),
    b"h": lambda machine: machine.get(machine.unpacked("<B")),
    b"j": lambda machine: machine.get(machine.unpacked("<I")),
    # Objects.
    b"c": lambda machine: machine.push(machine.named()),
    b"i": _Reader.instance,
    b"o": _Reader.instance_below_mark,
    b"R": _Reader.call,
    b"\x81": _Reader.call,
    b"b": _Reader.build,
    b"\x80": lambda machine: machine.take(1),
}
