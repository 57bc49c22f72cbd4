"""Emulates a Create 3: its Bluetooth services and packets, which move a twin."""

import struct

from learnblock.emulators.irobot import Answer, EmulatedRobot, IRobotEmulator
from learnblock.emulators.twin import Twin
from learnblock.robots.irobot import messages
from learnblock.robots.irobot.packets import Packet


class EmulatedCreate3(EmulatedRobot):
    """A Create 3 as seen by Bluetooth."""

    name = "Create3"
    manufacturer = {messages.MAKER: b"C3"}  # noqa: RUF012 - never changed
    serial = "CR3000000001"
    firmware = "2.6"
    protocol = (1, 4)
    fastest = 306.0
    battery = 15500, 80

    def __init__(self, twin: Twin) -> None:
        self._cliffs = 0
        super().__init__(twin)

    def more_answers(self) -> dict[tuple[int, int], Answer]:
        return {messages.PROXIMITY[:2]: self._look}

    def position(self) -> bytes:
        # Its heading begins at 90 degrees and grows anticlockwise.
        x, y, heading = self.odometry.pose
        return struct.pack(">iih", round(-y), round(x), round(10 * (90 - heading)) % 3600)

    def finished(self) -> bytes:
        return self.stamped(self.position())

    def sensed(self) -> dict[tuple[int, int], bytes]:
        with self.twin.body() as body:
            is_pressed, ground = body.bumper(), body.ground()
            cliffs = (0x04 if ground["left"] == 0 else 0) | (0x02 if ground["right"] == 0 else 0)
            if cliffs and not self._cliffs:
                body.drive(0, 0)
            self._cliffs = cliffs
        return {
            messages.BUMPER_EVENT: self.state(messages.BUMPERS if is_pressed else 0),
            messages.CLIFF_EVENT: self.state(cliffs),
        }

    def _look(self, _: Packet) -> bytes:
        with self.twin.body() as body:
            sides = body.distances()
        seen = [*sides["left"], *sides["front"], *sides["right"]]
        levels = [messages.intensity(distance) for distance in seen] + [0]
        high = bytes(level >> 4 for level in levels[:7])
        halves = (level & 0x0F for level in levels)
        low = bytes(first << 4 | second for first, second in zip(halves, halves, strict=True))
        return self.stamped(b"\0" + high + low)


class Emulator(IRobotEmulator):
    """A Create 3."""

    robot_type = EmulatedCreate3
