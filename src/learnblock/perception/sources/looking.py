"""Searches a camera's pictures, on request and once for each detector."""

from collections.abc import Callable, Mapping
from contextlib import ExitStack
from functools import cached_property
from typing import TYPE_CHECKING, Any

from learnblock.closing import Closing
from learnblock.perception.settings import TABLE, PerceptionSettings

if TYPE_CHECKING:
    from learnblock.perception import Detector, Sight
    from learnblock.perception.frames import Frame

#: The distance of the values of two frames that are compared first: a prime, so that they are of
#: all channels and columns.
APART = 997


# Why: docs/decisions.md, "Cameras are analysed in one place"
class Vision(Closing):
    """The detections in a camera's pictures.

    Args:
        read: returns the newest picture or None; a newer picture is a different object.
        drawn: whether the camera sees only drawn and simulated faces, whose emotions may always be
            recognised.
        focal: the lens's focal length in pixels, if known; it gives the poses of tags.
    """

    def __init__(
        self,
        read: "Callable[[], Frame | None]",
        *,
        drawn: bool,
        focal: float | None = None,
    ) -> None:
        self._read = read
        self._drawn = drawn
        self._focal = focal
        self._sight: Sight | None = None
        self._ending = ExitStack()

    def detect(self, name: str) -> Any:
        """Run a detector on the newest picture.

        None if there is no picture or no such detector, or if the settings forbid it.

        Raises:
            SettingsError: the settings are invalid.
            RobotConnectionError: a component cannot be reached.
        """
        if not self._settings.permits(name, drawn=self._drawn) or name not in self._detectors:
            return None
        frame = self._read()
        return None if frame is None else self._look(frame).detect(name)

    def close(self) -> None:
        """Close the components; calling it twice is harmless."""
        self._ending.close()

    @cached_property
    def _settings(self) -> PerceptionSettings:
        return TABLE.load()

    @cached_property
    def _detectors(self) -> "Mapping[str, Detector]":
        """Our detectors, except those for which the user has chosen components."""
        from learnblock.perception import DETECTORS  # noqa: PLC0415 - few programs see
        from learnblock.perception.sources.asking import chosen_components  # noqa: PLC0415 - as above

        asked = chosen_components(self._settings)
        for connection in asked.values():
            self._ending.callback(connection.close)
        return {**DETECTORS, **asked}

    def _look(self, frame: "Frame") -> "Sight":
        """The sight of a frame, which stores its detections."""
        from learnblock.perception import Sight  # noqa: PLC0415 - as above

        sight = self._sight
        if sight is None or not _is_same(sight.frame, frame):
            sight = self._sight = Sight(frame, self._focal, detectors=self._detectors)
        return sight


def _is_same(frame: "Frame", other: "Frame") -> bool:
    """Whether two frames are equal, like those of a simulator while nothing moves."""
    import numpy as np  # noqa: PLC0415 - as above

    if frame is other:
        return True
    # Frames of a robot that moves differ nearly everywhere, so a few of their values show it.
    few = slice(None, None, APART)
    return np.array_equal(frame.ravel()[few], other.ravel()[few]) and np.array_equal(frame, other)
