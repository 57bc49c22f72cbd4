"""Conversion of a robot's monitor, and of the drawing on the floor, to messages for the page."""

from collections.abc import Sequence
from typing import TYPE_CHECKING

from msgspec.structs import asdict

from learnblock.server import messages

if TYPE_CHECKING:
    from learnblock.monitor import Monitor, Stroke
    from learnblock.monitor.monitor import Picture, State


def scene(monitor: "Monitor") -> messages.Scene:
    """The unchanging parts of its world."""
    return messages.Scene(**asdict(monitor.scene()))


def telemetry(monitor: "Monitor") -> messages.Telemetry:
    """Its current state."""
    return messages.Telemetry(**asdict(monitor.state()), found=monitor.found())


def of_state(state: "State") -> messages.Telemetry:
    """A state, current or past."""
    return messages.Telemetry(**asdict(state))


def link(monitor: "Monitor") -> messages.RobotLink:
    """Its link, rounded so that noise is not reported."""
    now = monitor.link()
    return messages.RobotLink(now.state, _rounded(now.battery), _rounded(now.quality))


def sounds(monitor: "Monitor") -> tuple[messages.Sound, ...]:
    """The sounds since the last call."""
    return tuple(
        messages.Sound(sound.device, sound.action, sound.values) for sound in monitor.sounds()
    )


def camera_frame(picture: "Picture", *, past: bool = False) -> messages.CameraFrame:
    """The message that precedes the picture itself."""
    return messages.CameraFrame(picture.width, picture.height, picture.time, picture.seen, past)


def _rounded(value: float | None) -> float | None:
    return None if value is None else round(value, 1)


class Drawn:
    """Finds the new parts of a drawing, because sending all of it again would be too much."""

    def __init__(self) -> None:
        #: The strokes that were sent, with the number of their points.
        self._sent: list[tuple[Stroke, int]] = []
        self._is_known = False

    def forget(self) -> None:
        """Send everything with the next message, because a page has joined."""
        self._sent.clear()
        self._is_known = False

    def news(self, strokes: "Sequence[Stroke]") -> messages.Drawing | None:
        """The message about what is new; None if nothing is.

        Args:
            strokes: the drawing now.
        """
        fresh = not self._is_known or not self._continues(strokes)
        if fresh:
            self._sent.clear()
        self._is_known = True
        parts = tuple(filter(None, map(self._part, range(len(strokes)), strokes)))
        return messages.Drawing(fresh, parts) if fresh or parts else None

    def _continues(self, strokes: "Sequence[Stroke]") -> bool:
        """Whether the drawing still has every stroke that was sent, in the same order."""
        return len(strokes) >= len(self._sent) and all(
            stroke is sent for stroke, (sent, _) in zip(strokes, self._sent, strict=False)
        )

    def _part(self, index: int, stroke: "Stroke") -> messages.StrokePart | None:
        if index == len(self._sent):
            self._sent.append((stroke, 0))
        sent = self._sent[index][1]
        # The world may add points in the meantime.
        points = tuple(stroke.points[sent:])
        self._sent[index] = stroke, sent + len(points)
        return messages.StrokePart(index, stroke.colour, stroke.width, points) if points else None
