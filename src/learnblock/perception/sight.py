"""The detections in a frame: each detector runs at most once, and only on request."""

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
    """One frame, which each detector searches at most once.

    Detections are kept for later requests and for other detectors: emotions are read from the faces
    that have been found.

    Args:
        frame: RGB, uint8, shape (height, width, 3).
        focal: the lens's focal length in pixels, if known; it gives the poses of tags.
        tag_size: the side of the tags' black square in mm.
        detectors: the detectors by name; ours by default.
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
        """Run the detector called `name`.

        Raises:
            UnknownNameError: there is no detector with this name.
            FrameError: the frame is not a picture.
        """
        if name not in self._detectors:
            raise UnknownNameError("detector", name, self._detectors)
        if name not in self._found:
            self._found[name] = self._detectors[name].detect(self)
        return self._found[name]


class Detector(Protocol):
    """A detector of one kind of object."""

    @property
    def name(self) -> str: ...

    def detect(self, sight: Sight) -> Detections:
        """Search a frame, alone or with the detections of other detectors."""
        ...


@dataclass(frozen=True, slots=True)
class _BuiltIn:
    """The `look` function of the module with this name, which is imported when first used."""

    name: str

    def detect(self, sight: Sight) -> Detections:
        module = import_module(f"learnblock.perception.detectors.{self.name}")
        return cast(Detections, module.look(sight))


DETECTORS: Mapping[str, Detector] = MappingProxyType(
    {name: _BuiltIn(name) for name in ("lines", "tags", "objects", "faces", "emotions")}
)


def detect(name: str, frame: "Frame") -> Any:
    """Run the detector called `name` on `frame`, RGB uint8 of shape (height, width, 3).

    Raises:
        UnknownNameError: there is no detector with this name.
        FrameError: `frame` is not a picture.
    """
    return Sight(frame).detect(name)
