"""Direct commands: the byte code that LEGO's own firmware executes.

It follows LEGO's "EV3 Communication Developer Kit" and "EV3 Firmware Developer Kit" (2013) and the
firmware's published source. A command consists of the length of the rest, a counter that the reply
repeats, a type, the number of bytes reserved for the reply, and operations; all little-endian.
"""

import math
import struct
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache

from learnblock.robots.ev3.screen import Font

#: The size of the firmware's largest message in bytes.
LARGEST = 1024
WITH_REPLY, REPLY, REPLY_ERROR = 0x00, 0x02, 0x04
#: Layer 0 is the brick itself; other layers are bricks chained to it.
LAYER = b"\x00"

OUTPUT_STOP, OUTPUT_TIME_SPEED, OUTPUT_GET_COUNT = b"\xa3", b"\xaf", b"\xb3"
INPUT_TYPE_MODE, INPUT_READY_SI = b"\x99\x05", b"\x99\x1d"
SOUND_TONE = b"\x94\x01"
DRAW_UPDATE, DRAW_TEXT, DRAW_FONT = b"\x84\x00", b"\x84\x05", b"\x84\x11"
DRAW_TOP_LINE, DRAW_WINDOW = b"\x84\x12", b"\x84\x13"

#: The header of a command (length, counter, type, size of the reply), and that of a reply.
_HEAD, _REPLY = struct.Struct("<HHBH"), struct.Struct("<HB")


@dataclass(frozen=True, slots=True)
class Query:
    """An operation with a result, without the position of the result in the reply.

    Args:
        code: the bytes before that position.
        result: the format of its result, as a `struct` format character.
    """

    code: bytes
    result: str


class Question:
    """Operations that share one reply.

    Attributes:
        code: their bytes.
        reply: the format of the reply.
    """

    def __init__(self, queries: Sequence[Query]) -> None:
        self.code = b""
        form = "<"
        for query in queries:
            self.code += query.code
            for letter in query.result:
                # The firmware requires each variable at a multiple of its size.
                width = struct.calcsize(letter)
                form += "x" * (-struct.calcsize(form) % width)
                self.code += place(struct.calcsize(form))
                form += letter
        self.reply = struct.Struct(form)


def number(value: int) -> bytes:
    """A constant in as few bytes as possible."""
    if -32 <= value < 32:
        return bytes([value & 0x3F])
    for head, form, bits in ((0x81, "<b", 8), (0x82, "<h", 16), (0x83, "<i", 32)):
        if -(1 << bits - 1) <= value < 1 << bits - 1:
            return bytes([head]) + struct.pack(form, value)
    raise ValueError(f"{value} is too large")


def place(index: int) -> bytes:
    """A variable in the reply, by the number of its first byte."""
    return bytes([0x60 | index]) if index < 32 else bytes([0xE1, index])


@cache
def stop(motor: int) -> bytes:
    """Brake a motor: 0 is port A."""
    return OUTPUT_STOP + LAYER + number(1 << motor) + number(1)


@cache
def turn(motor: int, percent: int, milliseconds: int) -> bytes:
    """Turn a motor at a regulated speed for some time, then brake."""
    times = number(0) + number(milliseconds) + number(0)
    return OUTPUT_TIME_SPEED + LAYER + number(1 << motor) + number(percent) + times + number(1)


def turned(motor: int) -> Query:
    """Query the degrees that a motor has turned."""
    return Query(OUTPUT_GET_COUNT + LAYER + number(motor), "i")


def kind_of(port: int) -> Query:
    """Query the type and mode of the device at a port; 0 is port 1."""
    return Query(INPUT_TYPE_MODE + LAYER + number(port), "bb")


def reading(port: int, mode: int) -> Query:
    """Query a sensor's reading in a mode, in its own unit, once it is ready."""
    # Type 0 keeps the current type; one value is requested.
    parameters = LAYER + number(port) + number(0) + number(mode) + number(1)
    return Query(INPUT_READY_SI + parameters, "f")


def tone(hertz: int, milliseconds: int, volume: int = 50) -> bytes:
    """Play a tone."""
    return SOUND_TONE + number(volume) + number(hertz) + number(milliseconds)


def text(letters: str) -> bytes:
    """A constant text in ASCII."""
    return b"\x84" + letters.encode("ascii") + b"\x00"


def show(font: Font, lines: Sequence[str]) -> bytes:
    """Show lines on an empty screen; without lines, show the menu's top line again."""
    top_line = DRAW_TOP_LINE + number(not lines)
    window = DRAW_WINDOW + number(0) + number(0) + number(0)
    commands = (
        DRAW_TEXT + number(1) + number(0) + number(row * font.line) + text(line)
        for row, line in enumerate(lines)
    )
    return b"".join([top_line, window, DRAW_FONT, number(font.number), *commands, DRAW_UPDATE])


def command(counter: int, orders: bytes, question: Question) -> bytes:
    """A whole message, its length first: commands, then a query."""
    size = len(orders) + len(question.code) + _HEAD.size - 2
    return _HEAD.pack(size, counter, WITH_REPLY, question.reply.size) + orders + question.code


def answered(body: bytes, counter: int, question: Question) -> tuple[float, ...] | None:
    """The results in a reply, in the order of the query; a sensor without a value gives NaN.

    Args:
        body: the message without its length.
        counter: the command's counter; for the reply to an earlier command the result is None.
        question: the command's query.

    Raises:
        ValueError: it is not a reply, or has a different format.
        CommandFailedError: the firmware could not execute the command.
    """
    if len(body) < _REPLY.size:
        raise ValueError("too short for a reply")
    count, kind = _REPLY.unpack_from(body)
    if kind not in {REPLY, REPLY_ERROR}:
        raise ValueError(f"a message of type {kind}")
    if count != counter:
        return None
    if kind == REPLY_ERROR:
        raise CommandFailedError
    try:
        results = question.reply.unpack_from(body, _REPLY.size)
    except struct.error:
        raise ValueError("a reply that is too short") from None
    if any(map(math.isinf, results)):
        raise ValueError("an infinite reading")
    return results


class CommandFailedError(Exception):
    """The firmware could not execute a command."""
