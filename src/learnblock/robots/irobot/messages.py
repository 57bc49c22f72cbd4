"""What iRobot's education robots are asked and answer, by the documented protocol.

The protocol is that of https://github.com/iRobotEducation/root-robot-ble-protocol; what only
Create 3 has is as iRobot's own `irobot-edu-sdk` reads it.
"""

import math
import struct
from typing import NamedTuple

from learnblock.devices import NOTHING_SEEN, Pose

#: The service that only iRobot's robots have.
SERVICE = "48c5d828-ac2a-442d-97a3-0c9822b04979"
UART = "6e400001-b5a3-f393-e0a9-e50e24dcca9e"
TO_ROBOT = "6e400002-b5a3-f393-e0a9-e50e24dcca9e"
FROM_ROBOT = "6e400003-b5a3-f393-e0a9-e50e24dcca9e"
DEVICE_INFORMATION = "0000180a-0000-1000-8000-00805f9b34fb"
SERIAL_NUMBER = "00002a25-0000-1000-8000-00805f9b34fb"
#: iRobot's number, with which it marks what its robots advertise.
MAKER = 0x0600
#: The serial number of every Root begins with this, and so does its kind, such as RT1.
ROOT = b"RT"

MAIN_BOARD, COLOUR_BOARD = 0xA5, 0xC6
#: The key of the lights, which are on top.
LAMP = "Up"
#: What a colour sensor sees; all other values count as white.
WHITE, BLACK, RED, GREEN, BLUE = range(5)
#: How bright each is for a ground sensor, 0 to 100.
BRIGHTNESS = {BLACK: 0.0, RED: 30.0, GREEN: 40.0, BLUE: 25.0}
COLOURS = 32
#: The strip answers how much light it sees in this number of parts, with one of its own lights.
BANKS = 4
UNLIT, RED_LIT, GREEN_LIT, BLUE_LIT, ALL_LIT = range(5)
#: The bits of a bumper's event.
BUMPERS = 0xC0
#: What a proximity sensor reports of a white wall: at the bumper, each mm further away less by this
#: share, and at 200 mm. The maker's simulator has these numbers from its experiments.
BRIGHTEST, DECAY, FAINTEST = 3500, 0.026831568, 16
#: The longest tone, ms.
LONGEST_TONE = 0xFFFF


class RobotMessage(NamedTuple):
    """A request or a command, without its number."""

    device: int
    command: int
    payload: bytes = b""


#: Also cancels what the robot does, and sets its position to 0.
STOP = RobotMessage(0, 3)
RESET_POSITION = RobotMessage(1, 15)
POSITION = RobotMessage(1, 16)
#: Only Create 3 answers this.
PROXIMITY = RobotMessage(11, 2)
LIGHT = RobotMessage(13, 1)
BATTERY = RobotMessage(14, 1)

# What the robot reports by itself: device and command.
BUTTON = (0, 4)
COLOUR_EVENT = (4, 2)
BUMPER_EVENT = (12, 0)
CLIFF_EVENT = (20, 0)
EVENTS = frozenset({COLOUR_EVENT, BUMPER_EVENT, CLIFF_EVENT})


def drive(left: float, right: float) -> RobotMessage:
    """Turn the wheels until the next command, mm/s forward."""
    return RobotMessage(1, 4, struct.pack(">ii", round(left), round(right)))


def marker(*, down: bool) -> RobotMessage:
    """Put the marker down or lift it; the robot answers once it has."""
    return RobotMessage(2, 0, bytes((down,)))


def lights(red: int, green: int, blue: int) -> RobotMessage:
    """Show a colour on all lights; black switches them off."""
    is_lit = red or green or blue
    return RobotMessage(3, 2, bytes((1, red, green, blue) if is_lit else (0, 255, 255, 255)))


def note(hertz: float, milliseconds: float) -> RobotMessage:
    """Play a tone."""
    lasting = min(max(round(milliseconds), 0), LONGEST_TONE)
    return RobotMessage(5, 0, struct.pack(">IH", max(round(hertz), 0), lasting))


def strip_levels(bank: int, lighting: int) -> RobotMessage:
    """Ask a bank of eight colour sensors how much light each sees, of 4095."""
    return RobotMessage(4, 1, bytes((bank, lighting, 0)))


def versions(board: int) -> RobotMessage:
    """Ask for the versions of a board."""
    return RobotMessage(0, 0, bytes((board,)))


# What the robot answers. Each has 16 bytes.


def protocol(payload: bytes) -> tuple[int, int]:
    """The version of the protocol: major, minor."""
    return payload[7], payload[8]


def volts(payload: bytes) -> float:
    """The battery's voltage."""
    return int(struct.unpack_from(">H", payload, 4)[0]) / 1000


def brightness(payload: bytes) -> float:
    """The mean of both eyes, 0 to 1023; an eye reports up to 1000 mV."""
    left, right = struct.unpack_from(">HH", payload, 4)
    return float(min((left + right) / 2 * 1.023, 1023.0))


def root_pose(payload: bytes) -> Pose:
    """Where Root is: mm forward and to the left of its start, and degrees clockwise."""
    right, forward, heading = struct.unpack_from(">hhh", payload, 4)
    return float(forward), float(-right), _wrapped(heading / 10)


def create3_pose(payload: bytes) -> Pose:
    """Where Create 3 is; its own heading begins at 90 degrees and grows anticlockwise."""
    right, forward, heading = struct.unpack_from(">iih", payload, 4)
    return float(forward), float(-right), _wrapped(90 - heading / 10)


def distances(payload: bytes) -> list[float]:
    """The distance in mm of what each of Create 3's seven proximity sensors sees, left to right."""
    return [distance(level) for level in _levels(payload)]


def _levels(payload: bytes) -> list[int]:
    """How much light comes back to each sensor: 8 bits of each, and then 4 of each."""
    high, low = payload[5:12], payload[12:16]
    halves = (half for byte in low for half in (byte >> 4, byte & 0x0F))
    return [upper << 4 | lower for upper, lower in zip(high, halves, strict=False)]


def distance(level: int) -> float:
    """The distance in mm of a white wall from which so much light comes back."""
    if level < FAINTEST:
        return NOTHING_SEEN
    return max(math.log(BRIGHTEST / level) / DECAY, 0.0)


def intensity(distance: float) -> int:
    """How much light comes back from a white wall, 0 to 3500."""
    return round(BRIGHTEST * math.exp(-distance * DECAY))


def colours(payload: bytes) -> list[int]:
    """What each of Root's 32 colour sensors sees, from left to right."""
    return [half for byte in payload for half in (byte >> 4, byte & 0x0F)]


def levels(payload: bytes) -> tuple[int, ...]:
    """How much light each of eight colour sensors sees, from left to right."""
    return struct.unpack(">8H", payload)


def brightness_of(colour: int) -> float:
    """How bright a colour is, 0 (black) to 100 (white)."""
    return BRIGHTNESS.get(colour, 100.0)


def state(payload: bytes) -> int:
    """The state of bumpers or cliff sensors in an event."""
    return payload[4]


def _wrapped(degrees: float) -> float:
    return (degrees + 180) % 360 - 180
