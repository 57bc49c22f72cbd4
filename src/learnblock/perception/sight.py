"""Looking at a frame: each detector once at most, and only those that are asked for."""

from collections.abc import Mapping
from dataclasses import dataclass
from importlib import import_module
from types import MappingProxyType
from typing import TYPE_CHECKING, Any, Protocol, cast

from learnblock.errors import UnknownNameError
from learnblock.perception.detections import Detections

if TYPE_CHECKING:
    from learnblock.perception.frames import Frame


class Sight:
    """One frame, at which each detector looks once at most.

    What was found is kept, for whoever asks next and for the detectors that start from it: emotions
    are read from the faces that were found already.

    Args:
        frame: RGB, uint8, shape (height, width, 3).
        focal: the lens's focal length in pixels, where it is known; it gives the poses of tags.
        tag_size: the side of the tags' black square in mm.
        detectors: by their names; ours by default.
    """

    def __init__(
        self,
        frame: "Frame",
        focal: float | None = None,
        tag_size: float = 80.0,
        detectors: "Mapping[str, Detector] | None" = None,
    ) -> None:
        self.frame = frame
        self.focal = focal
        self.tag_size = tag_size
        self._detectors = DETECTORS if detectors is None else detectors
        self._found: dict[str, Any] = {}

    def detect(self, name: str) -> Any:
        """What the detector called `name` finds.

        Raises:
            UnknownNameError: there is no detector of this name.
            FrameError: the frame is no picture.
        """
        if name not in self._detectors:
            raise UnknownNameError("detector", name, self._detectors)
        if name not in self._found:
            self._found[name] = self._detectors[name].detect(self)
        return self._found[name]


class Detector(Protocol):
    """Something that finds one kind of thing."""

    @property
    def name(self) -> str: ...

    def detect(self, sight: Sight) -> Detections:
        """What there is in a frame, by itself or from what other detectors find in it."""
        ...


@dataclass(frozen=True, slots=True)
class _BuiltIn:
    """The function `look` of the module of this name, which is imported when first used."""

    name: str

    def detect(self, sight: Sight) -> Detections:
        return cast(Detections, import_module(f"learnblock.perception.{self.name}").look(sight))


DETECTORS: Mapping[str, Detector] = MappingProxyType(
    {name: _BuiltIn(name) for name in ("lines", "tags", "objects", "faces", "emotions")}
)


def detect(name: str, frame: "Frame") -> Any:
    """What the detector called `name` finds in `frame`, RGB uint8 of shape (height, width, 3).

    Raises:
        UnknownNameError: there is no detector of this name.
        FrameError: `frame` is no picture.
    """
    return Sight(frame).detect(name)
