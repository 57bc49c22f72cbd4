"""Detection in images. OpenCV is loaded with the first frame."""

from learnblock.perception.detections import (
    ColouredObject,
    Detections,
    Face,
    FaceEmotion,
    Lines,
    LineView,
    Tag,
    TagPose,
)
from learnblock.perception.sight import DETECTORS, Detector, Sight, detect

__all__ = [
    "DETECTORS",
    "ColouredObject",
    "Detections",
    "Detector",
    "Face",
    "FaceEmotion",
    "LineView",
    "Lines",
    "Sight",
    "Tag",
    "TagPose",
    "detect",
]
