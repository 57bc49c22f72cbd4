"""Direct commands: the byte code in which LEGO's own firmware is told what to do.

After LEGO's "EV3 Communication Developer Kit" and "EV3 Firmware Developer Kit" (2013) and the
firmware's published source. A command is the length of what follows, a counter that its reply
repeats, a type, the number of bytes it reserves for its reply, and operations; all little-endian.
"""

import math
import struct
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache

#: Bytes of the largest message of the firmware's.
LARGEST = 1024
WITH_REPLY, REPLY, REPLY_ERROR = 0x00, 0x02, 0x04
#: Nobody speaks of other bricks in a chain: ours is layer 0.
LAYER = b"\x00"

OUTPUT_STOP, OUTPUT_TIME_SPEED, OUTPUT_GET_COUNT = b"\xa3", b"\xaf", b"\xb3"
INPUT_TYPE_MODE, INPUT_READY_SI = b"\x99\x05", b"\x99\x1d"
SOUND_TONE = b"\x94\x01"

#: Of a command: its length, its counter, its type, the bytes of its reply; and of a reply.
_HEAD, _REPLY = struct.Struct("<HHBH"), struct.Struct("<HB")


@dataclass(frozen=True, slots=True)
class Query:
    """An operation with a result, complete but for the place of that result in the reply.

    Args:
        code: its bytes before that place.
        result: the form of its result, in the letters of `struct`.
    """

    code: bytes
    result: str


class Question:
    """Operations that together ask for one reply.

    Attributes:
        code: their bytes.
        reply: the form of the reply.
    """

    def __init__(self, queries: Sequence[Query]) -> None:
        self.code = b""
        form = "<"
        for query in queries:
            self.code += query.code
            for letter in query.result:
                # The firmware wants each variable at a multiple of its own size.
                width = struct.calcsize(letter)
                form += "x" * (-struct.calcsize(form) % width)
                self.code += place(struct.calcsize(form))
                form += letter
        self.reply = struct.Struct(form)


def number(value: int) -> bytes:
    """A constant, in as few bytes as it needs."""
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
    """Turn a motor at a regulated speed for so long, then brake."""
    times = number(0) + number(milliseconds) + number(0)
    return OUTPUT_TIME_SPEED + LAYER + number(1 << motor) + number(percent) + times + number(1)


def turned(motor: int) -> Query:
    """How far a motor has turned, degrees."""
    return Query(OUTPUT_GET_COUNT + LAYER + number(motor), "i")


def kind_of(port: int) -> Query:
    """What is plugged in at a port, 0 is port 1: its type and mode."""
    return Query(INPUT_TYPE_MODE + LAYER + number(port), "bb")


def reading(port: int, mode: int) -> Query:
    """What the sensor at a port reads in that mode, in its own unit, once it is ready."""
    # Type 0 leaves the type as it is; one value is asked for.
    asked = LAYER + number(port) + number(0) + number(mode) + number(1)
    return Query(INPUT_READY_SI + asked, "f")


def tone(hertz: int, milliseconds: int, volume: int = 50) -> bytes:
    """Sound for a while."""
    return SOUND_TONE + number(volume) + number(hertz) + number(milliseconds)


def command(counter: int, orders: bytes, question: Question) -> bytes:
    """A whole message, its length first: what is to be done, and what is asked then."""
    size = len(orders) + len(question.code) + _HEAD.size - 2
    return _HEAD.pack(size, counter, WITH_REPLY, question.reply.size) + orders + question.code


def answered(body: bytes, counter: int, question: Question) -> tuple[float, ...] | None:
    """The results in a reply, in the order of the question; a sensor without a value gives NaN.

    Args:
        body: the message without its length.
        counter: the command's; the reply to an earlier one is None.
        question: the command's.

    Raises:
        ValueError: it is no reply, or not of this form.
        RefusedError: the firmware could not execute the command.
    """
    if len(body) < _REPLY.size:
        raise ValueError("too short for a reply")
    count, kind = _REPLY.unpack_from(body)
    if kind not in {REPLY, REPLY_ERROR}:
        raise ValueError(f"a message of type {kind}")
    if count != counter:
        return None
    if kind == REPLY_ERROR:
        raise RefusedError
    try:
        results = question.reply.unpack_from(body, _REPLY.size)
    except struct.error:
        raise ValueError("a reply that is too short") from None
    if any(map(math.isinf, results)):
        raise ValueError("an infinite reading")
    return results


class RefusedError(Exception):
    """The firmware could not execute a command."""
