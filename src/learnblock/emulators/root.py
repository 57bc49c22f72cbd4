"""Emulates a Root: its Bluetooth services and packets, which move a twin."""

import struct

from learnblock.emulators.irobot import Answer, EmulatedRobot, IRobotEmulator
from learnblock.emulators.twin import Twin
from learnblock.robots.irobot import messages
from learnblock.robots.irobot.packets import Packet

#: The colour strip: mm in front of the wheels, and to the left of their middle.
STRIP = 32.7
STRIP_Y = [42.8 - 2.76 * i for i in range(messages.COLOURS)]
#: What counts as white and as black, of 100; between them it is the colour of nearest brightness.
LIGHT, DARK = 55.0, 18.0
NEAREST = {messages.RED: 32.0, messages.GREEN: 42.0, messages.BLUE: 28.0}
#: What a sensor of the strip counts in the dark, what white adds under each of its lights, and its
#: greatest count, as which it measures 3300 mV.
DARKNESS, MOST, MILLIVOLTS = 150, 4095, 3300
ADDED = {
    messages.UNLIT: 0,
    messages.RED_LIT: 800,
    messages.GREEN_LIT: 600,
    messages.BLUE_LIT: 400,
    messages.ALL_LIT: 1800,
}
#: mm in front of the wheels of the cliff sensor, and seconds that the marker takes.
CLIFF, MARKER = 55.0, 0.3
DOWN = 1


class EmulatedRoot(EmulatedRobot):
    """A Root Pro as seen by Bluetooth, its strip and cliff sensor included.

    Args:
        twin: what moves.

    Attributes:
        is_marker_stuck: whether the marker neither moves nor says that it has.
    """

    name = "ROOT"
    manufacturer = {messages.MAKER: b"RT1"}  # noqa: RUF012 - never changed
    serial = "RT0123456789"
    firmware = "2.1"
    protocol = (1, 3)
    fastest = 100.0
    boards = frozenset({messages.MAIN_BOARD, messages.COLOUR_BOARD})

    def __init__(self, twin: Twin) -> None:
        self.is_marker_stuck = False
        self._was_at_edge = False
        super().__init__(twin)

    def more_answers(self) -> dict[tuple[int, int], Answer]:
        return {(2, 0): self._move_marker, (4, 1): self._strip, (13, 1): self._light}

    def position(self) -> bytes:
        x, y, heading = self.odometry.pose
        return struct.pack(">hhh", round(-y), round(x), round(heading * 10) % 3600)

    def sensed(self) -> dict[tuple[int, int], bytes]:
        with self.twin.body() as body:
            is_pressed = body.bumper()
            is_at_edge = body.brightness_at(CLIFF, 0) == 0
            levels = [body.brightness_at(STRIP, y) for y in STRIP_Y]
            if is_at_edge and not self._was_at_edge:
                body.drive(0, 0)
                body.pen.set(False)
            self._was_at_edge = is_at_edge
        colours = [_colour(level) for level in levels]
        pairs = zip(colours[::2], colours[1::2], strict=True)
        return {
            messages.BUMPER_EVENT: self.state(messages.BUMPERS if is_pressed else 0),
            messages.CLIFF_EVENT: self.state(is_at_edge),
            messages.COLOUR_EVENT: bytes(left << 4 | right for left, right in pairs),
        }

    def _move_marker(self, packet: Packet) -> None:
        if self.is_marker_stuck:
            return
        position = packet.payload[0]
        with self.twin.body() as body:
            body.pen.set(position == DOWN)
        self.answer_later(MARKER, packet, bytes((position,)))

    def _strip(self, packet: Packet) -> bytes:
        """How much light a bank of the strip sees."""
        bank, lighting, is_voltage = packet.payload[:3]
        with self.twin.body() as body:
            levels = [body.brightness_at(STRIP, y) for y in STRIP_Y[8 * bank :][:8]]
        added = ADDED.get(lighting, 0)
        counts = [DARKNESS + level / 100 * added for level in levels]
        scale = MILLIVOLTS / MOST if is_voltage else 1
        return struct.pack(f">{len(counts)}H", *(round(count * scale) for count in counts))

    def _light(self, _: Packet) -> bytes:
        with self.twin.body() as body:
            eye = round(body.light() / 1.023)
        return self.stamped(struct.pack(">HH", eye, eye))


def _colour(level: float) -> int:
    if level >= LIGHT:
        return messages.WHITE
    if level < DARK:
        return messages.BLACK
    return min(NEAREST, key=lambda colour: abs(NEAREST[colour] - level))


class Emulator(IRobotEmulator):
    """A Root."""

    robot_type = EmulatedRoot
