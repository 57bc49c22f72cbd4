"""Looks at a camera's pictures: each is searched once for one kind of thing, when it is asked."""

from collections.abc import Callable
from functools import cached_property
from typing import TYPE_CHECKING, Any

from learnblock.closing import Closing
from learnblock.vision.settings import TABLE, PerceptionSettings

if TYPE_CHECKING:
    from learnblock.perception.frames import Frame


class Vision(Closing):
    """What is to be seen in a camera's pictures.

    Args:
        read: answers the newest picture, the same object as long as there is no newer one, or None.
        drawn: whether the camera sees drawn and simulated faces alone, in which emotions may be
            recognised whatever the settings say.
    """

    def __init__(self, read: "Callable[[], Frame | None]", *, drawn: bool) -> None:
        self._read = read
        self._drawn = drawn
        self._found: dict[str, tuple[Frame, Any]] = {}

    def detect(self, name: str) -> Any:
        """What the detector of that name finds in the newest picture.

        None without a picture, where there is no such detector, or where it must not look.

        Raises:
            SettingsError: the settings of perception are wrong.
            RobotConnectionError: a component that looks in our place cannot be reached.
        """
        # Imported on first use: a robot whose camera nobody uses pays nothing for OpenCV.
        from learnblock.perception import DETECTORS  # noqa: PLC0415

        if name not in DETECTORS or not self._settings.permits(name, drawn=self._drawn):
            return None
        frame = self._read()
        return None if frame is None else self._in(frame, name)

    def close(self) -> None:
        """Look no more; the second time it does nothing."""

    @cached_property
    def _settings(self) -> PerceptionSettings:
        return TABLE.load()

    def _in(self, frame: "Frame", name: str) -> Any:
        """What is found in a picture, which is searched once."""
        seen, found = self._found.get(name, (None, None))
        if seen is not frame:
            found = self._search(frame, name)
            self._found[name] = (frame, found)
        return found

    def _search(self, frame: "Frame", name: str) -> Any:
        from learnblock.perception import detect  # noqa: PLC0415 - as above

        if name == "emotions":
            from learnblock.perception.emotions import emotions_of  # noqa: PLC0415

            # The faces that others have asked for are not looked for again.
            return emotions_of(frame, self._in(frame, "faces"))
        return detect(name, frame)
