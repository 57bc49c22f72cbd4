"""The lines that the agent on a hub sends and receives: `learnblock.robots.spike.agent`."""

from collections.abc import Mapping
from dataclasses import dataclass

from learnblock.errors import RobotConnectionError
from learnblock.robots.plain_letters import in_ascii

#: The agent's first word, and the version of its lines.
GREETING = "learnblock 1"
#: The first word of a line that reports an error.
ERROR = "error "
#: The first word of a report.
REPORT = "s "
#: The largest number of a report that is not nonsense.
_LARGEST = 1e9
#: The longest text for the light matrix, which shows a letter each half a second.
LONGEST_TEXT = 100
#: The names of the sensors that the agent may find.
SENSORS = ("distance", "colour", "force")


@dataclass(frozen=True, slots=True)
class HubState:
    """What a hub reports.

    Args:
        left: degrees that the left wheel has turned, forward positive.
        right: the same for the right wheel.
        heading: degrees, clockwise positive, since the program on the hub was started.
        distance: mm; 2000 if nothing is seen. None if there is no such sensor, as below.
        colour: reflected light, 0 to 100.
        force: 1 if the force sensor is pressed, otherwise 0.
        battery: V.
    """

    left: float
    right: float
    heading: float
    distance: float | None
    colour: float | None
    force: float | None
    battery: float


def state(line: str) -> HubState | None:
    """Parse a report; None if the line is none.

    Raises:
        ValueError: it is an incomplete one.
    """
    if not line.startswith(REPORT):
        return None
    values = line.removeprefix(REPORT).split()
    left, right, heading, distance, colour, force, battery = map(_number, values)
    if left is None or right is None:
        raise RobotConnectionError("spike-motor-lost", motor="left" if left is None else "right")
    return HubState(
        left, right, (heading or 0.0) / 10, distance, colour, force, (battery or 0.0) / 1000
    )


def ports(line: str) -> dict[str, str]:
    """The port of each motor and sensor in the agent's greeting; "" where there is none.

    Raises:
        ValueError: it is no greeting.
    """
    if not line.startswith(GREETING):
        raise ValueError("the agent's greeting is missing")
    return dict(word.split("=", 1) for word in line.removeprefix(GREETING).split())


def error(line: str) -> RobotConnectionError:
    """The error that the agent reports.

    Raises:
        ValueError: it reports none that is known.
    """
    _, code, *values = [*line.split(), "", ""]
    part, port = values[:2]
    match code:
        case "no-motor" if port:
            return RobotConnectionError("spike-no-motor-at", motor=part, port=port)
        case "no-motor":
            return RobotConnectionError("spike-no-motor", motor=part)
        case "no-sensor":
            return RobotConnectionError("spike-no-sensor", sensor=part, port=port)
        case "motor-lost":
            return RobotConnectionError("spike-motor-lost", motor=part)
    raise ValueError("the agent's error is unknown")


def wishes(chosen: Mapping[str, str]) -> bytes:
    """The ports that the user chose for motors and sensors; "" is any port."""
    words = (f"{name}={port}" for name, port in chosen.items() if port)
    return " ".join(("ports", *words)).encode() + b"\n"


def drive(left: float, right: float) -> bytes:
    """Turn the wheels: degrees/s, forward positive."""
    return b"d %d %d\n" % (round(left), round(right))


def beep(hertz: float, milliseconds: float) -> bytes:
    """Play a tone."""
    return b"b %d %d\n" % (round(hertz), round(milliseconds))


def show(text: str) -> bytes:
    """Show a text on the light matrix, instead of what was there; an empty one clears it."""
    letters = " ".join(in_ascii(text)[:LONGEST_TEXT].split())
    return b"t " + letters.encode() + b"\n"


def light(hue: float, saturation: float, brightness: float) -> bytes:
    """Show a colour on the status light: degrees, %, %."""
    return b"l %d %d %d\n" % (round(hue), round(saturation), round(brightness))


def pulse() -> bytes:
    """Say that the driver is still there."""
    return b"p\n"


def _number(word: str) -> float | None:
    if word == "-":
        return None
    number = int(word)
    if abs(number) > _LARGEST:
        raise ValueError("no hub reports such a number")
    return float(number)
