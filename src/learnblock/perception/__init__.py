"""Images in, detections out. OpenCV is loaded when the first frame is looked at."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from importlib import import_module
from types import MappingProxyType
from typing import TYPE_CHECKING, Protocol, cast

from learnblock.errors import UnknownNameError
from learnblock.perception.detections import (
    ColouredObject,
    Face,
    FaceEmotion,
    Lines,
    LineView,
    Tag,
)

if TYPE_CHECKING:
    from learnblock.perception.frames import Frame

Detections = (
    Lines
    | tuple[Tag, ...]
    | tuple[ColouredObject, ...]
    | tuple[Face, ...]
    | tuple[FaceEmotion, ...]
)


class Detector(Protocol):
    """Something that finds one kind of thing in a frame."""

    @property
    def name(self) -> str: ...

    def detect(self, frame: "Frame") -> Detections:
        """What `frame`, RGB uint8 of shape (height, width, 3), shows."""
        ...


@dataclass(frozen=True, slots=True)
class _BuiltIn:
    """The function ``detect_NAME`` of the module NAME beside this one, imported when first used."""

    name: str

    def detect(self, frame: "Frame") -> Detections:
        module = import_module(f"{__name__}.{self.name}")
        return cast(Detections, getattr(module, f"detect_{self.name}")(frame))


DETECTORS: Mapping[str, Callable[["Frame"], Detections]] = MappingProxyType(
    {name: _BuiltIn(name).detect for name in ("lines", "tags", "faces", "emotions")}
)


def detect(name: str, frame: "Frame") -> Detections:
    """What the detector called `name` finds in `frame`, RGB uint8 of shape (height, width, 3).

    Raises:
        UnknownNameError: there is no detector of this name.
        FrameError: `frame` is no picture.
    """
    if name not in DETECTORS:
        raise UnknownNameError("detector", name, DETECTORS)
    return DETECTORS[name](frame)


__all__ = [
    "DETECTORS",
    "ColouredObject",
    "Detections",
    "Detector",
    "Face",
    "FaceEmotion",
    "LineView",
    "Lines",
    "Tag",
    "detect",
]
