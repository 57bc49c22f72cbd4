"""Looks at a camera's pictures: each is searched once for one kind of thing, when it is asked."""

from collections.abc import Callable, Mapping
from contextlib import ExitStack
from functools import cached_property
from typing import TYPE_CHECKING, Any

from learnblock.closing import Closing
from learnblock.vision.settings import TABLE, PerceptionSettings

if TYPE_CHECKING:
    from learnblock.perception import Detector, Sight
    from learnblock.perception.frames import Frame


class Vision(Closing):
    """What is to be seen in a camera's pictures.

    Args:
        read: answers the newest picture, a newer one being another object, or None.
        drawn: whether the camera sees drawn and simulated faces alone, in which emotions may be
            recognised whatever the settings say.
        focal: the lens's focal length in pixels, where it is known: it gives the poses of tags.
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
        """What the detector of that name finds in the newest picture.

        None without a picture, where there is no such detector, or where it must not look.

        Raises:
            SettingsError: the settings of perception are wrong.
            RobotConnectionError: a component that looks in our place cannot be reached.
        """
        if not self._settings.permits(name, drawn=self._drawn) or name not in self._detectors:
            return None
        frame = self._read()
        return None if frame is None else self._look(frame).detect(name)

    def close(self) -> None:
        """Look no more; the second time it does nothing."""
        self._ending.close()

    @cached_property
    def _settings(self) -> PerceptionSettings:
        return TABLE.load()

    @cached_property
    def _detectors(self) -> "Mapping[str, Detector]":
        """Ours, and components in the place of those that the user has chosen."""
        from learnblock.perception import DETECTORS  # noqa: PLC0415 - few programs see
        from learnblock.vision.asking import chosen_components  # noqa: PLC0415 - as above

        asked = chosen_components(self._settings)
        for one in asked.values():
            self._ending.callback(one.close)
        return {**DETECTORS, **asked}

    def _look(self, frame: "Frame") -> "Sight":
        """The look at a frame, in which what was found already is kept."""
        from learnblock.perception import Sight  # noqa: PLC0415 - as above

        sight = self._sight
        if sight is None or not _is_same(sight.frame, frame):
            sight = self._sight = Sight(frame, self._focal, detectors=self._detectors)
        return sight


def _is_same(one: "Frame", other: "Frame") -> bool:
    """Whether two frames show the same, as those of a simulator do while nothing moves."""
    import numpy as np  # noqa: PLC0415 - as above

    # To compare them costs a hundredth of looking for a face.
    return one is other or np.array_equal(one, other)
