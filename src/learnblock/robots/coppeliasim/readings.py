"""Converts CoppeliaSim's replies to our readings.

CoppeliaSim's angles are radians, counterclockwise seen from above; ours are degrees, clockwise.
Its positions are metres, with the same x and y axes as ours.
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

#: The index of the average intensity in the first packet of a vision sensor's reading, which has
#: minimum, maximum and average of intensity, red, green, blue and depth (``sim.readVisionSensor``).
AVERAGE_INTENSITY = 10


class BadReplyError(ValueError):
    """A reply of CoppeliaSim has an unexpected form; the message is the shortened reply."""

    def __init__(self, reply: object) -> None:
        super().__init__(f"{reply!r:.80}")


class Turning:
    """Follows a wrapped heading through full turns.

    It must be read again before the robot has turned by 180 degrees.

    Args:
        read: returns degrees clockwise, wrapped or not.
        reset: resets the robot's own sensor, if it has one.
    """

    def __init__(self, read: Callable[[], float], reset: Callable[[], object]) -> None:
        self._read = read
        self._reset = reset
        self._lock = threading.Lock()
        self._turned = 0.0
        self._last = read()

    def read(self) -> float:
        """Degrees turned clockwise since the reset."""
        with self._lock:
            heading = self._read()
            self._turned += wrapped(heading - self._last)
            self._last = heading
            return self._turned

    def reset(self) -> None:
        """Set the current heading to 0."""
        with self._lock:
            self._reset()
            self._last = self._read()
            self._turned = 0.0


def wrapped(degrees: float) -> float:
    """The same direction from -180 to 180."""
    return (degrees + 180) % 360 - 180


def finite(value: object) -> float:
    """A value as a finite number.

    Raises:
        BadReplyError: it is not a finite number.
    """
    try:
        return number("reading", value)
    except DeviceValueError:
        raise BadReplyError(value) from None


def matrix(reply: object) -> tuple[float, ...]:
    """The twelve numbers of an object's pose: three rows of three directions and a position in m.

    Raises:
        BadReplyError: it is not a pose.
    """
    if not isinstance(reply, Sequence) or len(reply) != 12:
        raise BadReplyError(reply)
    return tuple(map(finite, reply))


def distance(reply: object) -> float:
    """A proximity sensor's distance in mm, from a reply that starts with a flag and metres.

    Raises:
        BadReplyError: it is not a reading.
    """
    detected, *rest = reply if isinstance(reply, tuple) else (reply,)
    if detected != 1:
        return NOTHING_SEEN
    if not rest:
        raise BadReplyError(reply)
    return millimetres(rest[0])


def millimetres(metres: object) -> float:
    """A distance in mm, limited to the range of our sensors.

    Raises:
        BadReplyError: it is not a number.
    """
    return min(max(1000 * finite(metres), 0.0), NOTHING_SEEN)


def brightness(reply: object) -> float | None:
    """The brightness of a vision sensor's picture, 0 to 100; None before the first picture.

    Raises:
        BadReplyError: it is not a reading.
    """
    packet = reply[1] if isinstance(reply, tuple) and len(reply) > 1 else None
    if not isinstance(packet, Sequence) or isinstance(packet, str) or not packet:
        return None
    if len(packet) <= AVERAGE_INTENSITY:
        raise BadReplyError(reply)
    return percent(100 * finite(packet[AVERAGE_INTENSITY]))


def percent(value: object) -> float:
    """A number limited to 0 to 100.

    Raises:
        BadReplyError: it is not a number.
    """
    return min(max(finite(value), 0.0), 100.0)


def picture(reply: object) -> "Frame":
    """A vision sensor's image, turned upright: CoppeliaSim sends the lowest row first.

    Raises:
        BadReplyError: it is not an image.
    """
    import numpy as np  # noqa: PLC0415 - not needed without a camera

    image = converted(reply, tuple[bytes, tuple[int, int]])
    data, (width, height) = image
    if width < 1 or height < 1 or len(data) != 3 * width * height:
        raise BadReplyError(reply)
    frame = np.frombuffer(data, np.uint8).reshape(height, width, 3)[::-1].copy()
    frame.flags.writeable = False
    return frame


def converted(reply: object, kind: Any) -> Any:
    """A reply converted to a type.

    Raises:
        BadReplyError: it does not match the type.
    """
    try:
        return msgspec.convert(reply, kind)
    except (msgspec.ValidationError, RecursionError, TypeError) as error:
        raise BadReplyError(reply) from error
