"""Reads and executes the byte code of direct commands, as the firmware does.

It covers the operations for two wheels and four sensors, following LEGO's "EV3 Firmware Developer
Kit" (2013) and the firmware's published source (c_output.c, c_input.c, c_sound.c).
"""

import math
import struct
import time
from collections.abc import Callable

from learnblock.emulators.ev3.motors import FASTEST
from learnblock.emulators.vehicle import Vehicle

PORTS = "ABCD"
#: The plugged-in devices: touch, gyroscope, colour, ultrasonic, and two large motors.
TYPES = {0: 16, 1: 32, 2: 29, 3: 30, 17: 7, 19: 7}
NOTHING = 126


class ByteCodeError(Exception):
    """The firmware cannot execute this byte code."""


class ByteCodeReader:
    """Reads byte code from start to end."""

    def __init__(self, code: bytes) -> None:
        self._code = code
        self._next = 0

    def __bool__(self) -> bool:
        return self._next < len(self._code)

    def byte(self) -> int:
        """The next byte."""
        return self._bytes(1)[0]

    def constant(self) -> int:
        """A constant parameter, short (one byte) or long."""
        head = self.byte()
        if not head & 0x80:
            if head & 0x40:
                raise ByteCodeError("a variable where a constant is wanted")
            return (head & 0x1F) - (head & 0x20)
        form = {0x81: "<b", 0x82: "<h", 0x83: "<i"}.get(head)
        if form is None:
            raise ByteCodeError(f"the constant {head:#x}")
        value: int = struct.unpack(form, self._bytes(struct.calcsize(form)))[0]
        return value

    def text(self) -> str:
        """A constant text, which ends with a zero."""
        if self.byte() != 0x84:
            raise ByteCodeError("no text")
        letters = bytearray()
        while letter := self.byte():
            letters.append(letter)
        return letters.decode("ascii", "replace")

    def variable(self) -> int:
        """A parameter that names a position in the reply."""
        head = self.byte()
        if head & 0xE0 == 0x60:
            return head & 0x1F
        if head == 0xE1:
            return self.byte()
        raise ByteCodeError(f"the variable {head:#x}")

    def _bytes(self, count: int) -> bytes:
        piece = self._code[self._next : self._next + count]
        if len(piece) < count:
            raise ByteCodeError("the code ends too early")
        self._next += count
        return piece


class ByteCodeMachine:
    """Executes direct commands.

    Args:
        vehicle: the robot that it drives.
        now: returns the time in seconds.
    """

    def __init__(self, vehicle: Vehicle, now: Callable[[], float] = time.monotonic) -> None:
        self._vehicle = vehicle
        self._now = now
        #: For each running motor: percent of its full speed, and the time of its end.
        self._runs: dict[str, tuple[int, float]] = {}
        #: What has been drawn on the screen since it was emptied: places of lines, and the lines.
        self._drawn: dict[tuple[int, int], str] = {}
        self._operations: dict[int, Callable[[ByteCodeReader, bytearray], None]] = {
            0x84: self._draw,
            0x94: self._sound,
            0x99: self._input_device,
            0xA3: self._output_stop,
            0xAF: self._output_time_speed,
            0xB3: self._output_get_count,
        }

    def turn(self) -> None:
        """Turn the wheels with the motors that are still running."""
        now = self._now()
        self._runs = {port: run for port, run in self._runs.items() if run[1] > now}
        speeds = dict.fromkeys(PORTS, 0.0)
        speeds |= {port: percent / 100 * FASTEST for port, (percent, _) in self._runs.items()}
        self._vehicle.turn(speeds)

    def execute(self, message: bytes) -> bytes:
        """Execute a message and return its reply, both without their length."""
        if len(message) < 5:
            return b""
        counter, kind, sizes = struct.unpack_from("<HBH", message)
        reply = bytearray(sizes & 0x3FF)
        code = ByteCodeReader(message[5:])
        try:
            if kind & 0x7F:
                raise ByteCodeError("no direct command")
            while code:
                self._operation(code.byte())(code, reply)
        except ByteCodeError:
            return struct.pack("<HB", counter, 0x04)
        self.turn()
        return b"" if kind & 0x80 else struct.pack("<HB", counter, 0x02) + bytes(reply)

    def _operation(self, number: int) -> Callable[[ByteCodeReader, bytearray], None]:
        if number not in self._operations:
            raise ByteCodeError(f"the operation {number:#x}")
        return self._operations[number]

    def _draw(self, code: ByteCodeReader, reply: bytearray) -> None:
        del reply
        match code.byte():
            case 0x00:
                lines = [line for (_, _), line in sorted(self._drawn.items())]
                self._vehicle.show("\n".join(lines))
            case 0x05:
                colour, x, y = code.constant(), code.constant(), code.constant()
                line = code.text()
                if colour:
                    self._drawn[y, x] = line
            case 0x11 | 0x12:
                code.constant()
            case 0x13:
                colour, top, bottom = code.constant(), code.constant(), code.constant()
                if colour or top or bottom:
                    raise ByteCodeError("only the whole screen can be emptied")
                self._drawn.clear()
            case other:
                raise ByteCodeError(f"the subcode {other:#x}")

    def _sound(self, code: ByteCodeReader, reply: bytearray) -> None:
        del reply
        if code.byte() != 1:
            raise ByteCodeError("a sound that is no tone")
        volume, hertz, milliseconds = code.constant(), code.constant(), code.constant()
        if volume:
            self._vehicle.note("tone", float(hertz), float(milliseconds))

    def _input_device(self, code: ByteCodeReader, reply: bytearray) -> None:
        match code.byte():
            case 0x05:
                port = self._port(code)
                _put(reply, code.variable(), "<b", TYPES.get(port, NOTHING))
                _put(reply, code.variable(), "<b", 0)
            case 0x1D:
                port = self._port(code)
                _, mode, values = code.constant(), code.constant(), code.constant()
                if values != 1:
                    raise ByteCodeError("more values than one")
                _put(reply, code.variable(), "<f", self._measured(port, mode))
            case other:
                raise ByteCodeError(f"the subcode {other:#x}")

    def _measured(self, port: int, mode: int) -> float:
        """A reading in the sensor's own unit; only mode 0 of each sensor is simulated."""
        if mode:
            return math.nan
        match TYPES.get(port):
            case 16:
                return float(self._vehicle.touched())
            case 29:
                return float(round(self._vehicle.reflection()))
            case 30:
                return round(self._vehicle.distance()) / 10
            case 32:
                return float(round(self._vehicle.angle()))
            case _:
                return math.nan

    def _output_stop(self, code: ByteCodeReader, reply: bytearray) -> None:
        del reply
        for port in self._motors(code):
            self._runs.pop(port, None)
        code.constant()

    def _output_time_speed(self, code: ByteCodeReader, reply: bytearray) -> None:
        del reply
        ports, percent = self._motors(code), code.constant()
        up, even, down = code.constant(), code.constant(), code.constant()
        code.constant()
        until = self._now() + (up + even + down) / 1000
        self._runs |= {port: (min(max(percent, -100), 100), until) for port in ports}

    def _output_get_count(self, code: ByteCodeReader, reply: bytearray) -> None:
        port = self._port(code)
        if not 0 <= port < len(PORTS):
            raise ByteCodeError(f"the motor {port}")
        turned = self._vehicle.turned().get(PORTS[port], 0.0)
        _put(reply, code.variable(), "<i", round(turned))

    def _port(self, code: ByteCodeReader) -> int:
        if code.constant():
            raise ByteCodeError("another brick of a chain")
        return code.constant()

    def _motors(self, code: ByteCodeReader) -> list[str]:
        bits = self._port(code)
        return [port for index, port in enumerate(PORTS) if bits >> index & 1]


def _put(reply: bytearray, start: int, form: str, value: float) -> None:
    """Write a result; the firmware requires its position to be a multiple of its size."""
    size = struct.calcsize(form)
    if start % size or start + size > len(reply):
        raise ByteCodeError(f"no place for a result at {start}")
    struct.pack_into(form, reply, start, value)
