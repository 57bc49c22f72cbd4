"""From what CoppeliaSim answers to what devices read: m to mm, and turned the other way round.

CoppeliaSim's angles are radians, counterclockwise seen from above; ours are degrees, clockwise.
Positions are metres there, with x and y as ours.
"""

import threading
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

import msgspec

from learnblock.devices import NOTHING_SEEN, number
from learnblock.errors import DeviceValueError

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Frame = NDArray[np.uint8]

#: Where the average intensity stands in the first packet of a vision sensor's reading: least, most
#: and average of intensity, red, green, blue and depth (``sim.readVisionSensor``).
AVERAGE_INTENSITY = 10


class NonsenseError(ValueError):
    """An answer has not the form it should have."""


class Turning:
    """A heading that comes wrapped, followed through full turns.

    Somebody must ask before the robot has turned by 180 degrees.

    Args:
        read: answers degrees clockwise, wrapped or not.
        reset: lets the robot's own sensor begin at 0, where it has one.
    """

    def __init__(self, read: Callable[[], float], reset: Callable[[], object]) -> None:
        self._read = read
        self._reset = reset
        self._lock = threading.Lock()
        self._turned = 0.0
        self._last = read()

    def read(self) -> float:
        """Degrees turned since the reset, clockwise."""
        with self._lock:
            heading = self._read()
            self._turned += wrapped(heading - self._last)
            self._last = heading
            return self._turned

    def reset(self) -> None:
        """Begin at 0."""
        with self._lock:
            self._reset()
            self._last = self._read()
            self._turned = 0.0


def wrapped(degrees: float) -> float:
    """The same direction from -180 to 180."""
    return (degrees + 180) % 360 - 180


def finite(value: object) -> float:
    """A number.

    Raises:
        NonsenseError: it is none.
    """
    try:
        return number("reading", value)
    except DeviceValueError as error:
        raise NonsenseError(str(error)) from None


def matrix(reply: object) -> tuple[float, ...]:
    """The twelve numbers of an object's pose: three rows of three directions and a position, m.

    Raises:
        NonsenseError: they are not.
    """
    if not isinstance(reply, Sequence) or len(reply) != 12:
        raise NonsenseError(f"{reply!r:.80} is no matrix of 12 numbers")
    return tuple(map(finite, reply))


def distance(reply: object) -> float:
    """What a proximity sensor sees, in mm: found or not, m, and more that is not needed.

    Raises:
        NonsenseError: this is no reading.
    """
    found, *rest = reply if isinstance(reply, tuple) else (reply,)
    if found != 1:
        return NOTHING_SEEN
    if not rest:
        raise NonsenseError("a reading without distance")
    return millimetres(rest[0])


def millimetres(metres: object) -> float:
    """A distance as our sensors tell it.

    Raises:
        NonsenseError: it is no number.
    """
    return min(max(1000 * finite(metres), 0.0), NOTHING_SEEN)


def brightness(reply: object) -> float | None:
    """How bright a vision sensor's picture is, 0 to 100; None while it has none.

    Raises:
        NonsenseError: this is no reading.
    """
    packet = reply[1] if isinstance(reply, tuple) and len(reply) > 1 else None
    if not isinstance(packet, Sequence) or isinstance(packet, str) or not packet:
        return None
    if len(packet) <= AVERAGE_INTENSITY:
        raise NonsenseError(f"{len(packet)} numbers, at least {AVERAGE_INTENSITY + 1} are expected")
    return percent(100 * finite(packet[AVERAGE_INTENSITY]))


def percent(value: object) -> float:
    """A number brought to 0 to 100.

    Raises:
        NonsenseError: it is no number.
    """
    return min(max(finite(value), 0.0), 100.0)


def picture(reply: object) -> "Frame":
    """A vision sensor's image, upright: it comes with its lowest row first.

    Raises:
        NonsenseError: it is no image.
    """
    import numpy as np  # noqa: PLC0415 - a robot without a camera does without

    image = converted(reply, tuple[bytes, tuple[int, int]])
    data, (width, height) = image
    if width < 1 or height < 1 or len(data) != 3 * width * height:
        raise NonsenseError(f"{len(data)} bytes for an image of {width} by {height}")
    frame = np.frombuffer(data, np.uint8).reshape(height, width, 3)[::-1].copy()
    frame.flags.writeable = False
    return frame


def converted(reply: object, kind: Any) -> Any:
    """An answer as a value of that type.

    Raises:
        NonsenseError: it is none.
    """
    try:
        return msgspec.convert(reply, kind)
    except msgspec.ValidationError as error:
        raise NonsenseError(str(error)) from None
    except (RecursionError, TypeError) as error:
        raise NonsenseError(f"{reply!r:.80}") from error
