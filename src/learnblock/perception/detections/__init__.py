"""The results of detectors: plain values that can be sent between processes.

Columns grow to the right and rows downwards. Thresholds are given for a frame of 320 by 240 pixels
and scale with the frame size, which each detection contains.
"""

from collections.abc import Mapping
from types import MappingProxyType
from typing import Any

from learnblock.perception.detections.faces import Face, FaceEmotion
from learnblock.perception.detections.lines import Lines, LineView
from learnblock.perception.detections.objects import ColouredObject
from learnblock.perception.detections.points import Point
from learnblock.perception.detections.tags import Tag, TagPose

Detections = (
    Lines
    | tuple[Tag, ...]
    | tuple[ColouredObject, ...]
    | tuple[Face, ...]
    | tuple[FaceEmotion, ...]
)
#: The result type of each detector, by its name.
KINDS: Mapping[str, Any] = MappingProxyType(
    {
        "lines": Lines,
        "tags": tuple[Tag, ...],
        "objects": tuple[ColouredObject, ...],
        "faces": tuple[Face, ...],
        "emotions": tuple[FaceEmotion, ...],
    }
)

__all__ = [
    "KINDS",
    "ColouredObject",
    "Detections",
    "Face",
    "FaceEmotion",
    "LineView",
    "Lines",
    "Point",
    "Tag",
    "TagPose",
]
