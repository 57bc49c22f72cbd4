"""Direct commands: the byte code in which LEGO's own firmware is told what to do.

After LEGO's "EV3 Communication Developer Kit" and "EV3 Firmware Developer Kit" (2013) and the
firmware's published source. A command is the length of what follows, a counter that its reply
repeats, a type, the number of bytes it reserves for its reply, and operations; all little-endian.
"""

import math
import struct
from collections.abc import Sequence
from dataclasses import dataclass

#: Bytes of the largest message of the firmware's.
LARGEST = 1024
WITH_REPLY, REPLY, REPLY_ERROR = 0x00, 0x02, 0x04
#: Nobody speaks of other bricks in a chain: ours is layer 0.
LAYER = b"\x00"

OUTPUT_STOP, OUTPUT_TIME_SPEED, OUTPUT_GET_COUNT = b"\xa3", b"\xaf", b"\xb3"
INPUT_TYPE_MODE, INPUT_READY_SI = b"\x99\x05", b"\x99\x1d"
SOUND_TONE = b"\x94\x01"


@dataclass(frozen=True, slots=True)
class Operation:
    """An operation, complete but for the place of its result in the reply.

    Args:
        code: its bytes before that place.
        result: the form of its result, in the letters of `struct`; "" for none.
    """

    code: bytes
    result: str = ""


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


def stop(motor: int) -> Operation:
    """Brake a motor: 0 is port A."""
    return Operation(OUTPUT_STOP + LAYER + number(1 << motor) + number(1))


def turn(motor: int, percent: int, milliseconds: int) -> Operation:
    """Turn a motor at a regulated speed for so long, then brake."""
    times = number(0) + number(milliseconds) + number(0)
    return Operation(
        OUTPUT_TIME_SPEED + LAYER + number(1 << motor) + number(percent) + times + number(1)
    )


def turned(motor: int) -> Operation:
    """How far a motor has turned, degrees."""
    return Operation(OUTPUT_GET_COUNT + LAYER + number(motor), "i")


def kind_of(port: int) -> Operation:
    """What is plugged in at a port, 0 is port 1: its type and mode."""
    return Operation(INPUT_TYPE_MODE + LAYER + number(port), "bb")


def reading(port: int, mode: int) -> Operation:
    """What the sensor at a port reads in that mode, in its own unit, once it is ready."""
    # Type 0 leaves the type as it is; one value is asked for.
    return Operation(
        INPUT_READY_SI + LAYER + number(port) + number(0) + number(mode) + number(1), "f"
    )


def tone(hertz: int, milliseconds: int, volume: int = 50) -> Operation:
    """Sound for a while."""
    return Operation(SOUND_TONE + number(volume) + number(hertz) + number(milliseconds))


def command(counter: int, operations: Sequence[Operation]) -> bytes:
    """A whole message, its length first."""
    code, size = b"", 0
    for operation in operations:
        code += operation.code
        for letter in operation.result:
            # The firmware wants variables where their own size divides their place.
            width = struct.calcsize(letter)
            size += -size % width
            code += place(size)
            size += width
    body = struct.pack("<HBH", counter, WITH_REPLY, size) + code
    return struct.pack("<H", len(body)) + body


def answered(body: bytes, counter: int, operations: Sequence[Operation]) -> list[float] | None:
    """The results in a reply, in the order of the operations; a sensor without a value gives NaN.

    Args:
        body: the message without its length.
        counter: the command's; the reply to an earlier one is None.
        operations: the command's.

    Raises:
        ValueError: it is no reply, or not of this form.
        RefusedError: the firmware could not execute the command.
    """
    if len(body) < 3:
        raise ValueError("too short for a reply")
    count, kind = struct.unpack_from("<HB", body)
    if kind not in {REPLY, REPLY_ERROR}:
        raise ValueError(f"a message of type {kind}")
    if count != counter:
        return None
    if kind == REPLY_ERROR:
        raise RefusedError
    return _results(body[3:], operations)


class RefusedError(Exception):
    """The firmware could not execute a command."""


def _results(data: bytes, operations: Sequence[Operation]) -> list[float]:
    results: list[float] = []
    start = 0
    for letter in "".join(operation.result for operation in operations):
        width = struct.calcsize(letter)
        start += -start % width
        if start + width > len(data):
            raise ValueError("a reply that is too short")
        value = struct.unpack_from("<" + letter, data, start)[0]
        if isinstance(value, float) and math.isinf(value):
            raise ValueError("an infinite reading")
        results.append(value)
        start += width
    return results
