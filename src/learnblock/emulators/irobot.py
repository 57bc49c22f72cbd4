"""What the emulated Root and Create 3 share: packets move a twin and are answered.

Their maker doesn't say what they do when the connection ends while they drive, so they drive on,
which is worst for a driver.
"""

import math
import struct
import threading
from collections.abc import Callable, Mapping
from contextlib import suppress
from typing import Any, NamedTuple

from learnblock.emulators.gatt import NOT_SUPPORTED, GattError, GattServer, Notify, Services
from learnblock.emulators.twin import Twin
from learnblock.robots.irobot import messages
from learnblock.robots.irobot.packets import SIZE, Packet
from learnblock.wheels import Odometry, body_speeds, limited

#: Seconds between two looks at sensors and motions.
TICK = 0.02
#: The device that drives.
MOTORS = 1
FIRMWARE_REVISION = "00002a26-0000-1000-8000-00805f9b34fb"

Answer = Callable[[Packet], bytes | None]


class _Drive(NamedTuple):
    """A drive that ends by itself: how far the faster wheel rolls, and what it answers."""

    way: float
    begun: tuple[float, float]
    answer: Packet


class EmulatedRobot:
    """A robot as seen by Bluetooth.

    Args:
        twin: what moves.

    Attributes:
        received: the packets so far, as they came.
    """

    name: str
    largest = SIZE
    manufacturer: Mapping[int, bytes]
    #: Its serial number and its firmware's version.
    serial: str
    firmware: str
    #: The protocol's version.
    protocol: tuple[int, int]
    #: The fastest wheel, mm/s.
    fastest: float
    #: What its battery reports, mV and %.
    battery = 4000, 75
    #: The boards that it has.
    boards: frozenset[int] = frozenset({messages.MAIN_BOARD})
    services: Services = {  # noqa: RUF012 - never changed
        messages.SERVICE: {},
        messages.DEVICE_INFORMATION: {
            messages.SERIAL_NUMBER: ["read"],
            FIRMWARE_REVISION: ["read"],
        },
        messages.UART: {
            messages.TO_ROBOT: ["write", "write-without-response"],
            messages.FROM_ROBOT: ["notify"],
        },
    }

    def __init__(self, twin: Twin) -> None:
        self.twin = twin
        self.received: list[bytes] = []
        self._lock = threading.RLock()
        self._notify: Notify | None = None
        self._events = 0
        self._reported: dict[tuple[int, int], bytes] = {}
        self._due: list[tuple[float, Packet]] = []
        self._drive: _Drive | None = None
        with twin.body() as body:
            wheels = body.description.wheels
            self._rolled = body.wheels_rolled
        self._track = wheels.track
        #: The way in which it stops from its highest speed, mm.
        self._braking = self.fastest**2 / (2 * wheels.acceleration)
        self.odometry = Odometry(self._track)
        self._answers: dict[tuple[int, int], Answer] = {
            (0, 0): self._versions,
            (0, 2): lambda _: self.name.encode(),
            (0, 3): self._stop,
            (0, 14): lambda _: self.serial.encode(),
            (1, 4): self._turn_wheels,
            (1, 8): self._drive_distance,
            (1, 12): self._rotate,
            (1, 15): self._reset_position,
            (1, 16): self._tell_position,
            (3, 2): self._show,
            (5, 0): self._play,
            (14, 1): lambda _: self.stamped(struct.pack(">HB", *self.battery)),
            **self.more_answers(),
        }
        self._closed = threading.Event()
        self._thread = threading.Thread(target=self._live, name="irobot", daemon=True)
        self._thread.start()

    # What differs between them.

    def more_answers(self) -> dict[tuple[int, int], Answer]:
        """How it answers what only this robot is asked."""
        return {}

    def position(self) -> bytes:
        """Where it is, by its wheels, as it reports it."""
        raise NotImplementedError

    def sensed(self) -> dict[tuple[int, int], bytes]:
        """What it reports when it changes: the payload of each event, with 0 as its time."""
        raise NotImplementedError

    def finished(self) -> bytes:
        """What it answers at the end of a drive."""
        return b""

    # As the robot of a `GattServer`.

    def connected(self, notify: Notify) -> None:
        with self._lock:
            self._notify = notify
            self._reported = self.sensed()
            self._reset_position(None)

    def heard(self, uuid: str) -> None:
        """Do nothing: it says nothing until something changes."""

    def disconnected(self) -> None:
        self._notify = None

    def read(self, uuid: str) -> bytes:
        values = {messages.SERIAL_NUMBER: self.serial, FIRMWARE_REVISION: self.firmware}
        if uuid not in values:
            raise GattError(NOT_SUPPORTED)
        return values[uuid].encode()

    def write(self, uuid: str, value: bytes) -> None:
        if uuid != messages.TO_ROBOT or len(value) != SIZE:
            raise GattError(NOT_SUPPORTED)
        self.received.append(value)
        # A checksum of 0 is not compared.
        with suppress(ValueError):
            unchecked = Packet(value[0], value[1], value[2], value[3:-1])
            packet = Packet.parsed(value) if value[-1] else unchecked
            with self._lock:
                self._take(packet)

    def close(self) -> None:
        """Stop it."""
        self._closed.set()
        self._thread.join()

    # For the robots.

    def stamped(self, payload: bytes) -> bytes:
        """A payload after the milliseconds since it was switched on."""
        return struct.pack(">I", int(self.twin.time * 1000)) + payload

    @staticmethod
    def state(value: int) -> bytes:
        """The payload of an event that tells a state."""
        return bytes((0, 0, 0, 0, value))

    def answer_later(self, seconds: float, packet: Packet, payload: bytes = b"") -> None:
        """Answer a packet when it is done."""
        self._due.append((self.twin.time + seconds, packet._replace(payload=payload)))

    def halt(self) -> None:
        """Stop the wheels."""
        self._move(0, 0)

    def answer(self, question: messages.RobotMessage, payload: bytes) -> None:
        """Answer a question that it would not answer otherwise."""
        self._answers[question[:2]] = lambda _: payload

    def press_button(self) -> None:
        """Stop, and say so, as its button does."""
        with self._lock:
            self._stop(None)
            self._report(messages.BUTTON, b"")

    # Commands.

    def _take(self, packet: Packet) -> None:
        answer = self._answers.get(packet[:2])
        payload = answer(packet) if answer else None
        if payload is not None:
            self._send(packet._replace(payload=payload[:16]))

    def _versions(self, packet: Packet) -> bytes | None:
        board = packet.payload[0]
        if board not in self.boards:
            return None
        major, minor = map(int, self.firmware.split(".")[:2])
        return bytes((board, major, minor, 1, 0, 1, 0, *self.protocol))

    def _stop(self, _: Packet | None) -> None:
        self.halt()
        self._due.clear()
        self._reset_position(None)

    def _turn_wheels(self, packet: Packet) -> None:
        self._drive = None
        left, right = struct.unpack_from(">ii", packet.payload)
        self._move(left, right)

    def _move(self, left: float, right: float) -> None:
        self._drive = None
        most = self.fastest
        wheels = min(max(left, -most), most), min(max(right, -most), most)
        with self.twin.body() as body:
            body.drive(*body_speeds(wheels, self._track))

    def _drive_distance(self, packet: Packet) -> None:
        (distance,) = struct.unpack_from(">i", packet.payload)
        self._begin(packet, distance, distance)

    def _rotate(self, packet: Packet) -> None:
        (angle,) = struct.unpack_from(">i", packet.payload)
        way = math.radians(angle / 10) * self._track / 2
        self._begin(packet, way, -way)

    def _begin(self, packet: Packet, left: float, right: float) -> None:
        way = max(abs(left), abs(right))
        if way:
            self._move(*limited((left * self.fastest, right * self.fastest), self.fastest))
        self._drive = _Drive(way, self._wheels(), packet)

    def _tell_position(self, _: Packet) -> bytes:
        self._follow()
        return self.stamped(self.position())

    def _reset_position(self, _: Packet | None) -> None:
        self._follow()
        self.odometry = Odometry(self._track)

    def _show(self, packet: Packet) -> None:
        state, red, green, blue = packet.payload[:4]
        with self.twin.body() as body:
            body.set_led(messages.LAMP, (red, green, blue) if state else (0, 0, 0))

    def _play(self, packet: Packet) -> None:
        hertz, milliseconds = struct.unpack_from(">IH", packet.payload)
        with self.twin.body() as body:
            body.note("Speaker", "tone", hertz, milliseconds)
        self.answer_later(milliseconds / 1000, packet)

    # Answers and events.

    def _live(self) -> None:
        while not self._closed.wait(TICK):
            with self._lock:
                self._follow()
                self._finish()
                for kind, payload in self.sensed().items():
                    if self._reported.get(kind) != payload:
                        self._reported[kind] = payload
                        self._report(kind, payload)

    def _wheels(self) -> tuple[float, float]:
        with self.twin.body() as body:
            return body.wheels_rolled

    def _follow(self) -> None:
        """Reckon where it is."""
        before, self._rolled = self._rolled, self._wheels()
        self.odometry.roll(self._rolled[0] - before[0], self._rolled[1] - before[1])

    def _finish(self) -> None:
        """End what is over, and answer it."""
        drive = self._drive
        if drive:
            wheels = zip(self._rolled, drive.begun, strict=True)
            if max(abs(now - then) for now, then in wheels) >= drive.way - self._braking:
                self.halt()
                self.answer_later(2 * self._braking / self.fastest, drive.answer)
        over = [(due, answer) for due, answer in self._due if due <= self.twin.time]
        self._due = [waiting for waiting in self._due if waiting not in over]
        for _, answer in over:
            is_drive = answer.device == MOTORS
            self._send(answer._replace(payload=self.finished()) if is_drive else answer)

    def _report(self, kind: tuple[int, int], payload: bytes) -> None:
        self._events = (self._events + 1) % 256
        self._send(Packet(*kind, self._events, payload))

    def _send(self, packet: Packet) -> None:
        notify = self._notify
        if notify:
            notify(messages.FROM_ROBOT, packet.encoded)


class IRobotEmulator:
    """Serves an emulated robot.

    Args:
        twin: the robot that it drives.
        address: the local address on which it listens.
        port: its port; a free one by default.

    Attributes:
        settings: the settings with which a client reaches it.
    """

    #: What it serves.
    robot_type: type[EmulatedRobot]

    def __init__(self, twin: Twin, *, address: str = "127.0.0.1", port: int = 0) -> None:
        self.robot = self.robot_type(twin)
        self._server = GattServer(self.robot, address, port)
        self.settings: Mapping[str, Any] = {"address": f"{address}:{self._server.port}"}

    def close(self) -> None:
        self._server.close()
        self.robot.close()
