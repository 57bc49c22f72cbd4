"""Write projects of the original LearnBlock: pickles, opcode by opcode, and none of its own files.

Each version of that tool wrote its own opcodes: Python 2 with old-style classes (`INST`), Python 2
and 3 with `_reconstructor`, Python 3 with `NEWOBJ`. Blocks refer to each other in circles.
"""

import struct
import sys
from collections.abc import Sequence
from dataclasses import dataclass, field
from itertools import count
from typing import Any

from learnblock import language
from learnblock.blocks import builtin
from learnblock.importing import import_project

TOP, BOTTOM, INSIDE, RIGHT, LEFT = 0, 1, -1, 3, 4
OPERATOR, CONTROL, SKILL, VARIABLE, FUNCTION, WHEN, LIBRARY = range(7)


@dataclass(eq=False)
class Thing:
    """An object of a class."""

    kind: str
    state: dict[str, Any] = field(default_factory=dict)


@dataclass(eq=False)
class Spot:
    """A QPointF."""

    x: float
    y: float


@dataclass(frozen=True)
class Style:
    """How a version writes.

    Args:
        objects: the opcode of objects: ``inst``, ``reconstructor`` or ``newobj``.
        protocol: of pickle.
        block: the module and class of blocks.
        parts: the module of connections and variables.
        point: the module of positions.
        encoding: of the bytes of texts in Python 2; empty for texts of Python 3.
    """

    objects: str
    protocol: int
    block: tuple[str, str]
    parts: str
    point: str
    encoding: str = ""


_LATER = "learnbot_dsl.learnbotCode."
VERSION_1 = Style(
    "inst", 0, ("AbstracBlockItem", "AbstractBlockItem"), "Block", "PySide.QtCore", "utf-8"
)
VERSION_2 = Style(
    "inst", 0, ("AbstractBlock", "AbstractBlock"), "Block", "PySide.QtCore", "latin-1"
)
VERSION_2_BINARY = Style(
    "reconstructor", 2, ("AbstractBlock", "AbstractBlock"), "Block", "PySide.QtCore", "utf-8"
)
VERSION_3 = Style(
    "reconstructor",
    0,
    (f"{_LATER}AbstractBlock", "AbstractBlock"),
    f"{_LATER}Block",
    "PySide2.QtCore",
)
VERSION_3_BINARY = Style(
    "newobj", 3, (f"{_LATER}AbstractBlock", "AbstractBlock"), f"{_LATER}Block", "PySide2.QtCore"
)
STYLES = (VERSION_1, VERSION_2, VERSION_2_BINARY, VERSION_3, VERSION_3_BINARY)


class Pickler:
    """Writes values in the opcodes of a style."""

    def __init__(self, style: Style) -> None:
        self.style = style
        self.out = bytearray()
        self.memo: dict[int, int] = {}
        self.kept: list[object] = []

    def dumps(self, value: object) -> bytes:
        if self.style.protocol >= 2:
            self.out += b"\x80" + bytes([self.style.protocol])
        limit = sys.getrecursionlimit()
        sys.setrecursionlimit(20_000)
        self.save(value)
        sys.setrecursionlimit(limit)
        return bytes(self.out + b".")

    def save(self, value: Any) -> None:
        if id(value) in self.memo:
            place = self.memo[id(value)]
            self.out += (
                b"g%d\n" % place if self.style.protocol == 0 else b"j" + struct.pack("<I", place)
            )
            return
        {
            type(None): lambda _: self.write(b"N"),
            bool: self.save_truth, int: self.save_number, float: self.save_float,
            str: self.save_text, list: self.save_list, tuple: self.save_tuple,
            dict: self.save_dict, Thing: self.save_thing, Spot: self.save_spot,
        }[type(value)](value)  # fmt: skip

    def write(self, data: bytes) -> None:
        self.out += data

    def keep(self, value: object) -> None:
        self.kept.append(value)
        place = self.memo[id(value)] = len(self.memo)
        self.write(
            b"p%d\n" % place if self.style.protocol == 0 else b"r" + struct.pack("<I", place)
        )

    def save_truth(self, value: bool) -> None:
        if self.style.protocol >= 2:
            self.write(b"\x88" if value else b"\x89")
        else:
            self.write(b"I01\n" if value else b"I00\n")

    def save_number(self, value: int) -> None:
        if self.style.protocol >= 2:
            self.write(b"K%c" % value if 0 <= value < 256 else b"J" + struct.pack("<i", value))
        else:
            self.write((b"I%d\n" if self.style.encoding else b"L%dL\n") % value)

    def save_float(self, value: float) -> None:
        if self.style.protocol:
            self.write(b"G" + struct.pack(">d", value))
        else:
            self.write(b"F%s\n" % repr(value).encode())

    def save_text(self, value: str) -> None:
        if self.style.encoding:
            data = value.encode(self.style.encoding)
            if self.style.protocol:
                self.write(
                    b"U" + bytes([len(data)]) + data
                    if len(data) < 256
                    else b"T" + struct.pack("<i", len(data)) + data
                )
            else:
                self.write(b"S" + repr(data)[1:].encode() + b"\n")
        elif self.style.protocol:
            data = value.encode("utf-8")
            self.write(b"X" + struct.pack("<I", len(data)) + data)
        else:
            self.write(
                b"V"
                + value.replace("\\", "\\u005c")
                .replace("\n", "\\u000a")
                .encode("raw-unicode-escape")
                + b"\n"
            )
        self.keep(value)

    def save_list(self, value: list[Any]) -> None:
        self.write(b"]" if self.style.protocol else b"(l")
        self.keep(value)
        for item in value:
            self.save(item)
            self.write(b"a")

    def save_tuple(self, value: tuple[Any, ...]) -> None:
        self.write(b"(")
        for item in value:
            self.save(item)
        self.write(b"t")

    def save_dict(self, value: dict[Any, Any]) -> None:
        self.write(b"}" if self.style.protocol else b"(d")
        self.keep(value)
        for key, item in value.items():
            self.save(key)
            self.save(item)
            self.write(b"s")

    def named(self, kind: str) -> tuple[str, str]:
        if kind == "block":
            return self.style.block
        return self.style.parts, kind.capitalize()

    def save_global(self, module: str, name: str) -> None:
        self.write(f"c{module}\n{name}\n".encode())

    def save_thing(self, value: Thing) -> None:
        module, name = self.named(value.kind)
        if self.style.objects == "inst":
            self.write(f"(i{module}\n{name}\n".encode())
        elif self.style.objects == "newobj":
            self.save_global(module, name)
            self.write(b")\x81")
        else:
            two = bool(self.style.encoding)
            self.save_global("copy_reg" if two else "copyreg", "_reconstructor")
            self.write(b"(")
            self.save_global(module, name)
            self.save_global("__builtin__" if two else "builtins", "object")
            self.write(b"NtR")
        self.keep(value)
        self.save(value.state)
        self.write(b"b")

    def save_spot(self, value: Spot) -> None:
        self.save_global(self.style.point, "QPointF")
        self.save_tuple((value.x, value.y))
        self.write(b"R")


# Blocks.


@dataclass
class Old:
    """A block, with what is inside it and at its right."""

    name: str
    type: int = CONTROL
    values: Sequence[tuple[str, str]] = ()
    right: Sequence["Old"] = ()
    inside: Sequence["Old"] | None = None
    event: str = ""
    place: tuple[float, float] = (0.0, 0.0)
    is_value: bool = False


def skill(name: str, *values: tuple[str, str]) -> Old:
    return Old(name, SKILL, values)


def main(*inside: Old, place: tuple[float, float] = (0.0, 0.0)) -> Old:
    return Old("main", inside=inside, place=place)


def forever(*inside: Old) -> Old:
    return Old("while True", inside=inside)


def control(word: str, condition: Sequence[Old], *inside: Old) -> Old:
    return Old(word, right=condition, inside=inside)


def define(name: str, *inside: Old, place: tuple[float, float] = (400.0, 0.0)) -> Old:
    return Old(name, FUNCTION, inside=inside, place=place)


def when(event: str, condition: Sequence[Old], *inside: Old) -> Old:
    return Old("when", WHEN, right=condition, inside=inside, event=event)


def word(name: str) -> Old:
    return Old(name, OPERATOR)


class _Canvas:
    def __init__(self) -> None:
        self.blocks: dict[str, Thing] = {}
        self.ids = (str(number) for number in count())

    def stack(self, olds: Sequence[Old], above: Thing | None, end: int) -> None:
        for old in olds:
            block = self.block(old)
            if above is not None:
                _connect(above, end, block, TOP)
            above, end = block, BOTTOM

    def block(self, old: Old) -> Thing:
        key = next(self.ids)
        fields = [{"type": kind, "name": "x", "defaul": text} for kind, text in old.values]
        state = {
            "pos": Spot(*old.place),
            "name": old.name,
            "file": "block1.png",
            "id": key,
            "vars": [Thing("variable", value) for value in fields],
            "connections": [],
            "dicTrans": {},
            "dicToolTip": None,
            "nameControl": old.event,
            "typeBlock": 1,
            "type": old.type,
            "hue": 0,
        }
        block = Thing("block", state)
        self.blocks[key] = block
        if old.inside is not None:
            _end(block, INSIDE)
            self.stack(old.inside, block, INSIDE)
        left = block
        for operand in old.right:
            right = self.block(operand)
            _connect(left, RIGHT, right, LEFT)
            left = right
        if old.is_value:
            _end(block, LEFT)
        return block


def _end(block: Thing, kind: int) -> Thing:
    for end in block.state["connections"]:
        if end.state["_Connection__type"] == kind:
            return end
    state = {
        "_Connection__parent": block,
        "_Connection__connect": None,
        "_Connection__point": Spot(5.0, 5.0),
        "_Connection__idItem": None,
        "_Connection__type": kind,
    }
    new = Thing("connection", state)
    block.state["connections"].append(new)
    return new


def _connect(first_block: Thing, end: int, other: Thing, other_end: int) -> None:
    first, second = _end(first_block, end), _end(other, other_end)
    first.state.update(_Connection__connect=second, _Connection__idItem=other.state["id"])
    second.state.update(_Connection__connect=first, _Connection__idItem=first_block.state["id"])


def project(
    *stacks: Old | Sequence[Old],
    style: Style = VERSION_3,
    variables: Sequence[str] = (),
    functions: Sequence[str] = (),
    libraries: Sequence[str] | None = (),
) -> bytes:
    """The file of a project; each stack is a block, or blocks below one another."""
    canvas = _Canvas()
    for stack in stacks:
        canvas.stack([stack] if isinstance(stack, Old) else stack, None, BOTTOM)
    value: tuple[Any, ...] = (canvas.blocks, [], [], list(variables), list(functions))
    if libraries is not None:
        value = (*value, list(libraries))
    return Pickler(style).dumps(value)


# Fuzzing.


def read_text(text: str) -> None:
    """Import a file given as one character for each byte, and do all that a page does with it."""
    import_result = import_project(
        text.encode("latin-1", "replace"), "fuzzed.blockProject", builtin()
    )
    program = language.parse(import_result.blocktext)
    if language.from_workspace(import_result.workspace, builtin()).program != program:
        raise AssertionError("the blocks are another program")


def texts() -> tuple[str, ...]:
    """Projects of every version, with one character for each byte."""
    return tuple(data.decode("latin-1") for data in examples())


def examples() -> tuple[bytes, ...]:
    """A project that uses everything, in every style."""
    return tuple(map(example, STYLES))


def example(style: Style) -> bytes:
    """A project that uses everything."""
    near = [skill("front_obstacle", ("float", "60")), word("and"), Old("n", VARIABLE)]
    far = [word("not"), skill("is_turning")]
    decision = (
        control("if", [*near, word(">"), word("3")], skill("say_Text", ("string", "hola"))),
        control("elif", far, Old("n", VARIABLE, [("float", "1")])),
        control("else", [], Old("f", FUNCTION), Old("activate e", VARIABLE)),
    )
    drive = skill("set_move", ("float", "20"), ("float", "0.2"))
    message = skill("subscribe", ("string", "x"))
    return project(
        main(forever(*decision)),
        define("f", Old("print", right=[Old('"a"')]), drive),
        when("e", [skill("is_any_tag")], skill("mover_recto"), message),
        [skill("stop_bot"), skill("turn_right")],
        Old("is_turning", SKILL, is_value=True),
        style=style,
        variables=["n"],
        functions=["f"],
        libraries=["dance"],
    )
